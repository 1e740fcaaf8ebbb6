#include "scene/assortment.h"

#include <algorithm>
#include <tuple>

#include "base/text.h"
#include "base/words.h"
#include "catalog/zone_goods.h"

namespace marketgen::scene {
namespace {

std::size_t position_in(const std::vector<std::string>& list, const std::string& name) {
  return static_cast<std::size_t>(std::find(list.begin(), list.end(), name) - list.begin());
}

double volume_of(const catalog::Product& product) {
  return product.width_m() * product.depth_m() * product.height_m();
}

// Whether "cola" is in "cola zero" and in "Colas". It is not in "chocolate".
bool has_word(const std::string& text, const std::string& word) {
  const std::string where = lower_ascii(text), wanted = lower_ascii(word);
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
  };
  for (std::size_t at = where.find(wanted); at != std::string::npos;
       at = where.find(wanted, at + 1)) {
    const bool starts = at == 0 || !letter(where[at - 1]);
    std::size_t end = at + wanted.size();
    if (end < where.size() && where[end] == 's') ++end;  // plural
    if (starts && (end >= where.size() || !letter(where[end]))) return true;
  }
  return false;
}

// Both as spaced_words has them, and so they are below.
bool stands_in(const std::string& words, const std::string& text) {
  return text.find(words) != std::string::npos;
}

// "basmati rice" is rice of the variant basmati: the last word ends the name, and the others stand
// in name or variant.
bool is_kind_of(const catalog::Product& product,
                const std::string& name,
                const std::string& wanted) {
  const std::size_t last = wanted.rfind(' ', wanted.size() - 2);
  if (last == 0 || !name.ends_with(wanted.substr(last))) return false;
  const std::string variant = spaced_words(product.variant);
  for (std::size_t at = 0; at < last;) {
    const std::size_t end = wanted.find(' ', at + 1);
    const std::string word = wanted.substr(at, end - at + 1);
    if (!stands_in(word, name) && !stands_in(word, variant)) return false;
    at = end;
  }
  return true;
}

// A word for goods, as it was said and as spaced_words has it: it is asked of every product.
struct GoodsWord {
  std::string said, spaced;
};

std::vector<GoodsWord> goods_words(const std::vector<std::string>& words) {
  std::vector<GoodsWord> made;
  for (const std::string& word : words)
    if (!word.empty()) made.push_back({word, spaced_words(word)});
  return made;
}

// How a word names a product, the nearest first.
enum class Naming { name, end_of_name, in_name, variant, keyword, otherwise };

// `name`: the product's, as spaced_words has it.
bool ends_name(const catalog::Product& product,
               const std::string& name,
               const std::string& wanted) {
  return !wanted.empty() && (name.ends_with(wanted) || is_kind_of(product, name, wanted));
}

Naming naming_of(const catalog::Product& product, const std::string& wanted) {
  const std::string name = spaced_words(product.name);
  if (wanted.empty()) return Naming::otherwise;
  if (name == wanted) return Naming::name;
  if (ends_name(product, name, wanted)) return Naming::end_of_name;
  if (stands_in(wanted, name)) return Naming::in_name;
  if (stands_in(wanted, spaced_words(product.variant))) return Naming::variant;
  const bool keyword = std::ranges::any_of(
      product.keywords, [&](const std::string& known) { return spaced_words(known) == wanted; });
  return keyword ? Naming::keyword : Naming::otherwise;
}

// Categories and subcategories that a zone sells: its own list, or its type's.
struct GoodsLists {
  const std::vector<std::string>&categories, &subcategories;
};

GoodsLists lists_of(const plan::Zone& zone, const catalog::Catalog& catalog) {
  static const std::vector<std::string> none;
  const catalog::ZoneTypeRow* type = catalog.zone_type(zone.type);
  if (!zone.stock.categories.empty() || type == nullptr) return {zone.stock.categories, none};
  return {type->categories, type->subcategories};
}

bool is_named(const catalog::Product& product, const std::vector<GoodsWord>& words) {
  if (words.empty()) return false;
  const std::string name = spaced_words(product.name);
  for (const GoodsWord& word : words) {
    if (ends_name(product, name, word.spaced)) return true;
    for (const std::string* text : {&product.name,
                                    &product.variant,
                                    &product.brand,
                                    &product.subcategory,
                                    &product.category}) {
      if (has_word(*text, word.said)) return true;
    }
    for (const std::string& keyword : product.keywords) {
      if (has_word(keyword, word.said)) return true;
    }
  }
  return false;
}

}  // namespace

bool named_by(const catalog::Product& product, const std::vector<std::string>& words) {
  return is_named(product, goods_words(words));
}

std::vector<std::uint32_t> best_named(const plan::Zone& zone,
                                      const std::string& word,
                                      const catalog::Catalog& catalog) {
  const std::vector<GoodsWord> wanted = goods_words({word});
  const std::vector<GoodsWord> excluded = goods_words(zone.stock.exclude);
  std::vector<std::uint32_t> best;
  Naming least = Naming::otherwise;
  for (std::uint32_t i = 0; i < catalog.products.size(); ++i) {
    const catalog::Product& product = catalog.products[i];
    if (!sells(zone, product, catalog)) continue;
    if (!is_named(product, wanted) || is_named(product, excluded)) continue;
    const Naming naming = naming_of(product, wanted.front().spaced);
    if (naming > least) continue;
    if (naming < least) best.clear();
    least = naming;
    best.push_back(i);
  }
  return best;
}

bool sells(const plan::Zone& zone,
           const catalog::Product& product,
           const catalog::Catalog& catalog) {
  const auto& [categories, subcategories] = lists_of(zone, catalog);
  return catalog::sold_in(product, categories, subcategories);
}

std::vector<std::uint32_t> assortment_of(const plan::Zone& zone,
                                         catalog::Storage temperature,
                                         const catalog::Catalog& catalog) {
  const std::vector<std::string>& categories = lists_of(zone, catalog).categories;
  const std::vector<GoodsWord> excluded = goods_words(zone.stock.exclude);
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 0; i < catalog.products.size(); ++i) {
    const catalog::Product& product = catalog.products[i];
    if (!catalog::keeps(temperature, product.storage) || !sells(zone, product, catalog)) continue;
    if (!is_named(product, excluded)) rows.push_back(i);
  }
  std::sort(rows.begin(), rows.end(), [&](std::uint32_t a, std::uint32_t b) {
    const catalog::Product& p = catalog.products[a];
    const catalog::Product& q = catalog.products[b];
    const std::size_t p_category = position_in(categories, p.category),
                      q_category = position_in(categories, q.category);
    const double p_volume = volume_of(p), q_volume = volume_of(q);
    return std::tie(p_category, p.category, p.subcategory, p.brand, p.family, p_volume, a) <
           std::tie(q_category, q.category, q.subcategory, q.brand, q.family, q_volume, b);
  });
  return rows;
}

}  // namespace marketgen::scene
