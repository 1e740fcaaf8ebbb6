// Money and units of price tags by country. Rows of the catalogue are in euro and metric units; a
// store in a country has rows of its own money (Product::country), made by localized().
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"

namespace marketgen::catalog {

enum class UnitSystem { metric, us_customary };

struct Country {
  std::string_view id, name;
  std::string_view currency;  // ISO 4217
  std::string_view sign;
  bool sign_first = false;
  int minor_digits = 2;  // of the smallest coin: 0 where there is none
  double per_euro = 1;   // ECB reference rate, mean of 2024
  int ending = 0;        // prices in the smallest coin leave this rest ...
  int period = 1;        // ... when divided by this
  UnitSystem units = UnitSystem::metric;
};

const std::vector<Country>& countries();
// Null for an id that is not there.
const Country* find_country(std::string_view id);
// That of a plan or a row: the euro area where none is named.
const Country& country_or_euro(const std::optional<std::string>& id);
// The country whose money and units the row has.
const Country& country_of(const Product& product);
// Error `code`, with the nearest id.
Result<void> check_country(std::string_view id, std::string code, std::string where);

// The nearest price with the usual ending, in the country's money; never 0.
double usual_price(double price, const Country& country);

// The row with its price in the country's money, on the nearest usual ending, never 0. A row that
// is in that money already stays as it is.
Product localized(Product product, const Country& country);

// The catalogue as a store in a country has it; the very one where none is named. `country` must be
// known, `rows` outlive it.
class LocalCatalog {
 public:
  LocalCatalog(const Catalog& rows, const std::optional<std::string>& country);
  const Catalog& get() const { return local_ ? *local_ : rows_; }

 private:
  const Catalog& rows_;
  std::optional<Catalog> local_;
};

// "2.38 €", "$2.49", "¥258".
std::string price_text(double price, const Country& country);

// What goods cost by amount, as price tags must say: a kilo, litre or piece (directive 98/6/EC); in
// US customary units an ounce, a pound of loose goods, or a fluid ounce.
struct UnitPrice {
  double price = 0;
  std::string_view per;  // "kg", "l", "piece", "oz", "lb", "fl oz"
};
UnitPrice unit_price(const Product& product);
// "€ 2.38 / kg", "$0.21 / oz".
std::string unit_price_text(const Product& product);

// The net quantity as the country's tags have it: "340 g", "12 oz (340 g)".
std::string net_text(const Product& product);

}  // namespace marketgen::catalog
