// What a store sells, and what of it a request allows.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "catalog/country.h"
#include "catalog/product.h"
#include "shopping/request.h"

namespace marketgen::shopping {

struct Assortment {
  std::vector<catalog::Product> products;  // in the store's money, sorted by SKU
  std::vector<std::string> sold_out;       // SKUs of them that are not there today, sorted

  // Null when the store does not sell it.
  const catalog::Product* product(std::string_view sku) const;
  bool is_sold_out(std::string_view sku) const;
};

// That of its prices.
const catalog::Country& country_of(const Assortment& assortment);
// Whether a word names any money: its sign or code as it stands in the text, or what people call it
// ("euro"), lower case and singular.
bool is_money(std::string_view text, std::string_view plain);

// In the smallest coin of the row's country: exact where prices are summed.
std::int64_t coins_of(const catalog::Product& product);
// The price of so many coins, of the assortment's country.
double price_of(std::int64_t coins, const Assortment& assortment);
// Coins of the budget, rounded down. Error: shopping.other_money, when the store has another money
// than was said.
Result<std::int64_t> coins_of(const Budget& budget, const Assortment& assortment);

// Why the request forbids the product: "its row does not tell that it is gluten free". Empty when
// it does not.
std::optional<std::string> refusal(const catalog::Product& product,
                                   const ShoppingRequest& request,
                                   const ShoppingKnowledge& knowledge);

}  // namespace marketgen::shopping
