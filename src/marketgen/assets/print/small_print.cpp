#include "assets/print/small_print.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "base/text.h"

namespace marketgen::assets {
namespace {

constexpr FoodRow food_rows[] = {
#define FOOD(where, words, fat, saturates, carbohydrate, sugars, protein, salt, ingredients) \
  {where, words, fat, saturates, carbohydrate, sugars, protein, salt, ingredients},
#include "assets/print/pack_foods.inc"
#undef FOOD
};

constexpr GoodsRow goods_rows[] = {
#define GOODS(where, words, dated, contents, directions) \
  {where, words, dated, contents, directions},
#include "assets/print/pack_goods.inc"
#undef GOODS
};

bool ends_with_any(std::string_view word, std::initializer_list<std::string_view> endings) {
  return std::any_of(endings.begin(), endings.end(), [&](std::string_view ending) {
    return word.ends_with(ending);
  });
}

// "berries" -> "berry", "peaches" -> "peach", "peas" -> "pea"; both sides of a comparison go
// through it, so that it need not be right, only the same.
std::string singular(std::string word) {
  constexpr std::size_t shortest_plural = 4;
  if (word.size() < shortest_plural || ends_with_any(word, {"ss", "us", "is"})) return word;
  if (word.ends_with("ies")) return word.substr(0, word.size() - 3) + "y";
  if (ends_with_any(word, {"oes", "ches", "shes", "sses", "xes"}))
    return word.substr(0, word.size() - 2);
  if (word.ends_with('s')) word.pop_back();
  return word;
}

// Lower case, singular; whatever is no letter or digit parts words, but for apostrophes.
std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  const auto finish = [&] {
    if (!word.empty()) words.push_back(singular(std::move(word)));
    word.clear();
  };
  for (const char c : lower_ascii(text)) {
    const auto byte = static_cast<unsigned char>(c);
    const bool letter = byte >= 0x80 || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (letter)
      word += c;
    else if (c != '\'')
      finish();
  }
  finish();
  return words;
}

bool contains(const std::vector<std::string>& text, const std::vector<std::string>& phrase) {
  return !phrase.empty() &&
         std::search(text.begin(), text.end(), phrase.begin(), phrase.end()) != text.end();
}

// Where a row stands to a product: for its subcategory, for all of its category, for another
// subcategory of it, or for other categories.
enum class Scope { none, sibling, category, subcategory };

Scope scope_of(std::string_view where, const catalog::Product& product) {
  const std::string subcategory = product.category + "/" + product.subcategory;
  Scope scope = Scope::none;
  for (const std::string& place : marketgen::split(where, ',')) {
    const std::string_view name = std::string_view(place).substr(place.find_first_not_of(' '));
    if (name == subcategory) return Scope::subcategory;
    if (name == product.category)
      scope = Scope::category;
    else if (scope == Scope::none && name.starts_with(product.category + "/"))
      scope = Scope::sibling;
  }
  return scope;
}

// Length of the row's longest phrase in the name, 0 when none is there.
std::size_t longest_phrase(std::string_view phrases, const std::vector<std::string>& name) {
  std::size_t longest = 0;
  for (const std::string& phrase : marketgen::split(phrases, '|')) {
    if (contains(name, words_of(phrase))) longest = std::max(longest, phrase.size());
  }
  return longest;
}

// The search for one product's row among the rows of one table.
template <class Row>
class RowSearch {
 public:
  RowSearch(std::span<const Row> rows, const catalog::Product& product)
      : rows_(rows), product_(product), name_(words_of(product.name)) {
    for (const Row& row : rows)
      known_ = known_ || scope_of(row.where, product) == Scope::subcategory;
  }

  const Row* best() const {
    const Row* best = nullptr;
    std::size_t best_fit = 0;
    for (const Row& row : rows_) {
      const std::size_t fit = fit_of(row);
      if (fit <= best_fit) continue;
      best = &row;
      best_fit = fit;
    }
    return best;
  }

 private:
  // 0 when the row does not apply, 1 and 2 for the rest of a category or subcategory, more for
  // longer phrases. Where no row is for the product's subcategory (a user's catalogue has its own),
  // the phrases of its whole category count.
  std::size_t fit_of(const Row& row) const {
    const Scope scope = scope_of(row.where, product_);
    if (scope == Scope::none || (scope == Scope::sibling && (known_ || row.words.empty())))
      return 0;
    if (row.words.empty()) return scope == Scope::subcategory ? 2 : 1;
    const std::size_t longest = longest_phrase(row.words, name_);
    return longest == 0 ? 0 : longest + 2;
  }

  std::span<const Row> rows_;
  const catalog::Product& product_;
  std::vector<std::string> name_;
  bool known_ = false;
};

}  // namespace

const GoodsRow* goods_row_of(const catalog::Product& product) {
  return RowSearch(std::span<const GoodsRow>(goods_rows), product).best();
}

const FoodRow* food_row_of(const catalog::Product& product) {
  if (goods_row_of(product) != nullptr) return nullptr;
  return RowSearch(std::span<const FoodRow>(food_rows), product).best();
}

bool has_phrase(std::string_view text, std::string_view phrase) {
  return contains(words_of(text), words_of(phrase));
}

}  // namespace marketgen::assets
