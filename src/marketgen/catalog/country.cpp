#include "catalog/country.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "catalog/net_content.h"

namespace marketgen::catalog {
namespace {

constexpr double grams_an_ounce = 28.349523125, ml_a_fluid_ounce = 29.5735295625;
constexpr double ounces_a_pound = 16;

// "12", "1.5": one decimal where there is one.
std::string amount_text(double amount) {
  std::string text = fmt::format("{:.1f}", amount);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

bool is_loose(const Product& product) {
  return !product.plu.empty();
}

}  // namespace

const std::vector<Country>& countries() {
  static const std::vector<Country> all{
#define COUNTRY(id, name, currency, sign, first, digits, per_euro, ending, period, units) \
  {#id, name, currency, sign, first, digits, per_euro, ending, period, UnitSystem::units},
#include "catalog/countries.inc"
#undef COUNTRY
  };
  return all;
}

const Country* find_country(std::string_view id) {
  const auto at = std::ranges::find(countries(), id, &Country::id);
  return at == countries().end() ? nullptr : &*at;
}

const Country& country_or_euro(const std::optional<std::string>& id) {
  const Country* country = id ? find_country(*id) : nullptr;
  return country != nullptr ? *country : countries().front();
}

const Country& country_of(const Product& product) {
  return country_or_euro(product.country);
}

Result<void> check_country(std::string_view id, std::string code, std::string where) {
  if (find_country(id) != nullptr) return {};
  std::vector<std::string_view> known;
  for (const Country& country : countries())
    known.push_back(country.id);
  return unknown_name(std::move(code), std::move(where), "country", id, known);
}

double usual_price(double price, const Country& country) {
  const double coins = std::pow(10, country.minor_digits);
  const double periods = std::round((price * coins - country.ending) / country.period);
  double usual = periods * country.period + country.ending;
  if (usual <= 0) usual = country.ending > 0 ? country.ending : country.period;
  return usual / coins;
}

Product localized(Product product, const Country& country) {
  const Country& from = country_of(product);
  if (from.currency == country.currency) return product;
  product.price = usual_price(product.price / from.per_euro * country.per_euro, country);
  product.country = std::string(country.id);
  return product;
}

LocalCatalog::LocalCatalog(const Catalog& rows, const std::optional<std::string>& country)
    : rows_(rows) {
  const Country* known = country ? find_country(*country) : nullptr;
  if (known == nullptr) return;
  local_ = rows;
  for (Product& product : local_->products)
    product = localized(std::move(product), *known);
}

std::string price_text(double price, const Country& country) {
  const std::string number = fmt::format("{:.{}f}", price, country.minor_digits);
  if (!country.sign_first) return fmt::format("{} {}", number, country.sign);
  return fmt::format("{}{}{}", country.sign, country.sign.size() > 2 ? " " : "", number);
}

UnitPrice unit_price(const Product& product) {
  const double price = product.price / std::max(1e-6, product.unit_amount);
  if (country_of(product).units == UnitSystem::metric) return {price, product.unit_of_measure};
  const double an_ounce = price * grams_an_ounce / 1000;
  if (product.unit_of_measure == "kg" && is_loose(product))
    return {an_ounce * ounces_a_pound, "lb"};
  if (product.unit_of_measure == "kg") return {an_ounce, "oz"};
  if (product.unit_of_measure == "l") return {price * ml_a_fluid_ounce / 1000, "fl oz"};
  return {price, product.unit_of_measure};
}

std::string unit_price_text(const Product& product) {
  const Country& country = country_of(product);
  const UnitPrice unit = unit_price(product);
  if (!country.sign_first) return fmt::format("{} {:.2f} / {}", country.sign, unit.price, unit.per);
  return fmt::format("{} / {}", price_text(unit.price, country), unit.per);
}

std::string net_text(const Product& product) {
  const auto content = net_content(product.net);
  if (country_of(product).units == UnitSystem::metric || !content ||
      content->unit == NetUnit::piece)
    return product.net;
  const bool mass = content->unit == NetUnit::gram;
  const double ounces = content->amount / (mass ? grams_an_ounce : ml_a_fluid_ounce);
  const std::string packs = content->packs > 1 ? fmt::format("{} x ", content->packs) : "";
  return fmt::format(
      "{}{} {} ({})", packs, amount_text(ounces), mass ? "oz" : "fl oz", product.net);
}

}  // namespace marketgen::catalog
