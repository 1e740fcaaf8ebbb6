#include "shopping/assortment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "base/words.h"

namespace marketgen::shopping {
namespace {

double coins_a_unit(const catalog::Country& country) {
  return std::pow(10.0, country.minor_digits);
}

// What people call money, and which it may be.
constexpr std::pair<std::string_view, std::string_view> money_names[] = {{"euro", "EUR"},
                                                                         {"dollar", "USD"},
                                                                         {"dollar", "CAD"},
                                                                         {"dollar", "AUD"},
                                                                         {"buck", "USD"},
                                                                         {"pound", "GBP"},
                                                                         {"yuan", "CNY"},
                                                                         {"yen", "JPY"},
                                                                         {"franc", "CHF"},
                                                                         {"zloty", "PLN"}};

bool is_sign_or_code(const std::string& low, const catalog::Country& country) {
  return low == lower_ascii(country.sign) || low == lower_ascii(country.currency);
}

bool is_its_money(std::string_view said, const catalog::Country& country) {
  const std::string low = lower_ascii(said);
  return said.empty() || is_sign_or_code(low, country) ||
         std::ranges::any_of(money_names, [&](const auto& name) {
           return name.first == low && name.second == country.currency;
         });
}

// All that the row says, as spaced words; keywords do not run into one another.
std::string row_words(const catalog::Product& product) {
  std::string words = spaced_words(product.name + " " + product.variant);
  for (const std::string& keyword : product.keywords)
    words += "|" + spaced_words(keyword);
  return words + "|" + spaced_words(product.description) + "|" + spaced_words(product.subcategory);
}

bool says_any(const std::string& row, const std::vector<std::string>& words) {
  return std::ranges::any_of(words, [&](const auto& each) { return has_words(row, each); });
}

bool in_list(const std::vector<std::string>& list, const std::string& name) {
  return std::ranges::find(list, name) != list.end();
}

std::optional<std::string> refusal_of(const Diet& diet, const catalog::Product& product) {
  if (diet.cannot_tell) return std::nullopt;
  const std::string row = row_words(product);
  if (says_any(row, diet.told_by)) return std::nullopt;
  const std::string group = group_of(product);
  if (in_list(diet.never_groups, group) || says_any(row, diet.never_words))
    return fmt::format("does not go with \"{}\"", diet.id);
  const bool plain =
      in_list(diet.plain_groups, group) || says_any(spaced_words(product.name), diet.plain_names);
  const bool must_be_plain =
      diet.only_told || !diet.plain_groups.empty() || !diet.plain_names.empty();
  if (must_be_plain && !plain)
    return fmt::format("its row does not tell whether it goes with \"{}\"", diet.id);
  return std::nullopt;
}

}  // namespace

const catalog::Country& country_of(const Assortment& assortment) {
  return assortment.products.empty() ? catalog::country_or_euro({})
                                     : catalog::country_of(assortment.products.front());
}

bool is_money(std::string_view text, std::string_view plain) {
  const std::string low = lower_ascii(text);
  return std::ranges::any_of(money_names, [&](const auto& name) { return name.first == plain; }) ||
         std::ranges::any_of(catalog::countries(), [&](const catalog::Country& country) {
           return is_sign_or_code(low, country);
         });
}

const catalog::Product* Assortment::product(std::string_view sku) const {
  const auto found = std::ranges::lower_bound(products, sku, {}, &catalog::Product::sku);
  return found == products.end() || found->sku != sku ? nullptr : &*found;
}

bool Assortment::is_sold_out(std::string_view sku) const {
  return std::ranges::binary_search(sold_out, sku);
}

std::int64_t coins_of(const catalog::Product& product) {
  return std::llround(product.price * coins_a_unit(catalog::country_of(product)));
}

double price_of(std::int64_t coins, const Assortment& assortment) {
  return static_cast<double>(coins) / coins_a_unit(country_of(assortment));
}

Result<std::int64_t> coins_of(const Budget& budget, const Assortment& assortment) {
  const catalog::Country& country = country_of(assortment);
  if (!is_its_money(budget.money, country))
    return Error{"shopping.other_money",
                 fmt::format("{:g} {}", budget.amount, budget.money),
                 fmt::format("the store's prices are in {} ({}); say the sum in it, or without a "
                             "currency",
                             country.currency,
                             country.sign)};
  constexpr double rounding = 1e-6;
  return static_cast<std::int64_t>(std::floor(budget.amount * coins_a_unit(country) + rounding));
}

std::optional<std::string> refusal(const catalog::Product& product,
                                   const ShoppingRequest& request,
                                   const ShoppingKnowledge& knowledge) {
  for (const std::string& id : request.diets)
    if (const Diet* diet = knowledge.table().diet(id))
      if (auto why = refusal_of(*diet, product)) return why;
  if (request.without.empty()) return std::nullopt;
  const std::string row = row_words(product);
  for (const std::string& word : request.without) {
    const bool free = has_words(row, word + " free") || has_words(row, "no " + word) ||
                      has_words(row, "without " + word);
    if (!free && has_words(row, word)) return fmt::format("its row says \"{}\"", word);
  }
  return std::nullopt;
}

}  // namespace marketgen::shopping
