// Prices and amounts as the tags of a country have them.
#include "catalog/country.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "support/committed_catalog.h"

namespace marketgen {
namespace {

using catalog::Country;
using catalog::Product;

const Country& known(std::string_view id) {
  const Country* country = catalog::find_country(id);
  if (country == nullptr) fatal("no such country");
  return *country;
}

Product sold(double price, std::string net, double amount, std::string unit) {
  Product product;
  product.sku = "goods-of-test";
  product.price = price, product.net = std::move(net);
  product.unit_amount = amount, product.unit_of_measure = std::move(unit);
  return product;
}

TEST(Countries, EachHasAnIdACurrencyAndAnEndingOfItsOwn) {
  std::set<std::string_view> ids;
  for (const Country& country : catalog::countries()) {
    EXPECT_TRUE(ids.insert(country.id).second) << country.id;
    EXPECT_EQ(country.currency.size(), 3U) << country.id;
    EXPECT_FALSE(country.sign.empty() || country.name.empty()) << country.id;
    EXPECT_GT(country.per_euro, 0) << country.id;
    EXPECT_TRUE(country.ending >= 0 && country.ending < country.period) << country.id;
  }
  EXPECT_EQ(catalog::countries().front().currency, "EUR");
}

TEST(Countries, PricesOfAllRowsHaveTheUsualEndingNearTheRate) {
  for (const Country& country : catalog::countries()) {
    const double coins = std::pow(10, country.minor_digits);
    for (const Product& row : committed_catalog().products) {
      const Product local = catalog::localized(row, country);
      const auto price = std::llround(local.price * coins);
      EXPECT_GT(price, 0) << row.sku;
      EXPECT_NEAR(local.price * coins, static_cast<double>(price), 1e-6) << row.sku;
      if (country.period > 1) {
        EXPECT_EQ(price % country.period, country.ending) << row.sku;
      }
      const double exact = row.price * country.per_euro * coins;
      EXPECT_LE(std::abs(local.price * coins - exact), std::max(country.period, 1)) << row.sku;
      EXPECT_EQ(catalog::country_of(local).currency, country.currency) << row.sku;
    }
  }
}

TEST(Countries, ARowOfTheSameMoneyStaysAsItIs) {
  const Product euro = sold(2.38, "500 g", 0.5, "kg");
  EXPECT_EQ(catalog::localized(euro, known("eu")).price, 2.38);
  EXPECT_FALSE(catalog::localized(euro, known("eu")).country);
  Product dollar = euro;
  dollar.country = "us", dollar.price = 4.18;  // no usual ending
  EXPECT_EQ(catalog::localized(dollar, known("us")).price, 4.18);
  EXPECT_EQ(catalog::localized(dollar, known("ca")).price, 5.69);  // 4.18 / 1.0824 * 1.4821 = 5.72
}

TEST(Countries, TagsHaveTheSignWhereTheCountryHasIt) {
  EXPECT_EQ(catalog::price_text(2.38, known("eu")), "2.38 \u20ac");
  EXPECT_EQ(catalog::price_text(2.49, known("us")), "$2.49");
  EXPECT_EQ(catalog::price_text(258, known("jp")), "\u00a5258");
  EXPECT_EQ(catalog::price_text(2.45, known("ch")), "CHF 2.45");
  EXPECT_EQ(catalog::price_text(27.9, known("se")), "27.90 kr");
}

TEST(Countries, UnitPricesAndAmountsAreInTheUnitsOfTheCountry) {
  Product pasta = sold(2.00, "453.6 g", 0.4536, "kg");
  EXPECT_EQ(catalog::unit_price_text(pasta), "\u20ac 4.41 / kg");
  EXPECT_EQ(catalog::net_text(pasta), "453.6 g");
  pasta.country = "us";
  EXPECT_EQ(catalog::unit_price_text(pasta), "$0.12 / oz");  // 2.00 / 16
  EXPECT_EQ(catalog::net_text(pasta), "16 oz (453.6 g)");
  Product apples = pasta;
  apples.plu = "4011";
  EXPECT_EQ(catalog::unit_price_text(apples), "$2.00 / lb");
  Product cola = sold(6.00, "6 x 355 ml", 2.13, "l");
  cola.country = "us";
  EXPECT_EQ(catalog::net_text(cola), "6 x 12 fl oz (6 x 355 ml)");
  EXPECT_EQ(catalog::unit_price_text(cola), "$0.08 / fl oz");
  Product eggs = sold(3.49, "10 eggs", 10, "piece");
  eggs.country = "us";
  EXPECT_EQ(catalog::net_text(eggs), "10 eggs");
}

TEST(Countries, OneThatIsNotThereIsNamedWithTheNearest) {
  EXPECT_TRUE(catalog::check_country("jp", "catalog.unknown_kind", "--country").ok());
  const auto wrong = catalog::check_country("uss", "catalog.unknown_kind", "--country");
  ASSERT_FALSE(wrong.ok());
  EXPECT_EQ(wrong.error().where, "--country");
  EXPECT_NE(wrong.error().message.find("\"us\""), std::string::npos) << wrong.error().message;
}

}  // namespace
}  // namespace marketgen
