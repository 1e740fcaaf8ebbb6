#include "assets/print/pack_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <span>

#include "assets/print/small_print.h"

namespace marketgen::assets {
namespace {

std::string grams(double amount) {
  return amount < 0.05 ? "0 g"
         : amount < 10 ? fmt::format("{:.1f} g", amount)
                       : fmt::format("{:.0f} g", amount);
}

// "Zero Sugar", a "Light" drink: sweetened with something else.
bool is_sugar_free(const catalog::Product& product) {
  const auto says = [&](std::string_view words) { return has_phrase(product.variant, words); };
  const bool drink = product.category == "beverages";
  return says("zero sugar") || says("sugar free") || says("no sugar") ||
         (drink && (says("zero") || says("light") || says("diet")));
}

FoodRow without_sugar(FoodRow row) {
  row.carbohydrate -= row.sugars;
  row.sugars = 0;
  return row;
}

// Writes `with` in place of the first `what`; the text itself when there is none.
std::string replaced(std::string text, std::string_view what, std::string_view with) {
  const std::size_t at = text.find(what);
  return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

std::string ingredients_of(const FoodRow& row, const catalog::Product& product) {
  std::string text = replaced(std::string(row.ingredients), "{name}", product.name);
  if (is_sugar_free(product))
    text = replaced(std::move(text), ", sugar", ", sweeteners: sucralose, acesulfame K");
  return "Ingredients: " + text;
}

// Each maker's own figures lie within a tenth of the kind's.
void fill_nutrition(PackFacts& facts, const FoodRow& row, Stream& draw) {
  const double whole = row.fat + row.carbohydrate + row.protein + row.salt;
  const double maker = std::min(draw.uniform(0.9, 1.1), 100 / std::max(whole, 1.0));
  const double fat = row.fat * maker;
  const double carbohydrate = row.carbohydrate * maker;
  const double protein = row.protein * maker;
  const double sugars = row.sugars * maker;
  // Energy factors of regulation (EU) 1169/2011, annex XIV: fat 37 kJ/g, carbohydrate and protein
  // 17 kJ/g.
  const double kj = 37 * fat + 17 * (carbohydrate + protein);
  facts.nutrition = {{"Energy", fmt::format("{:.0f} kJ / {:.0f} kcal", kj, kj / 4.184)},
                     {"Fat", grams(fat)},
                     {"of which saturates", grams(row.saturates * maker)},
                     {"Carbohydrate", grams(carbohydrate)},
                     {"of which sugars", grams(sugars)},
                     {"Protein", grams(protein)},
                     {"Salt", fmt::format("{:.2f} g", row.salt * maker)}};
}

std::string storage_advice(catalog::Storage storage) {
  switch (storage) {
    case catalog::Storage::ambient:
      return "Store in a cool, dry place. Once opened, consume soon.";
    case catalog::Storage::chilled:
      return "Keep refrigerated at 2 to 7 \u00b0C. Once opened, consume within 3 days.";
    case catalog::Storage::frozen:
      return "Store at -18 \u00b0C or below. Do not refreeze after thawing.";
  }
  return {};
}

// The store is as on the day of its last delivery, a Monday, so that dates follow from the rows.
constexpr std::chrono::sys_days delivery_day = std::chrono::year{2026} / 3 / 2;

// "14.08.2027", the last day of a product's shelf life.
std::string date_of(const catalog::Product& product) {
  const std::chrono::year_month_day day{delivery_day + std::chrono::days(product.shelf_life_days)};
  return fmt::format("{:02}.{:02}.{}",
                     static_cast<unsigned>(day.day()),
                     static_cast<unsigned>(day.month()),
                     static_cast<int>(day.year()));
}

// What spoils unseen has a last day (article 24 of the regulation), all else a best-before date.
bool is_highly_perishable(const catalog::Product& product) {
  const std::string& group = product.subcategory;
  return product.storage == catalog::Storage::chilled &&
         (group == "fresh meat" || group == "poultry" || group == "fish");
}

// Claims that suit whatever the shelf group sells.
std::span<const std::string_view> claims_for(const catalog::Product& product) {
  static constexpr std::string_view drinks[] = {
      "Ice cold", "100 % recycled", "Refreshing taste", "Since 1962"};
  static constexpr std::string_view fresh[] = {
      "Freshly picked", "Less plastic", "Grown with care", "Class I"};
  static constexpr std::string_view foods[] = {"No added colours",
                                               "Less plastic",
                                               "Family recipe",
                                               "Quality since 1962",
                                               "Traditional recipe",
                                               "Now even better"};
  static constexpr std::string_view pets[] = {"Pets love it", "No added sugar", "With vitamins"};
  static constexpr std::string_view house[] = {
      "Less plastic", "Top quality", "Made to last", "Value pack"};
  static constexpr std::string_view care[] = {
      "Dermatologist tested", "Vegan formula", "pH neutral", "Extra gentle", "Less plastic"};
  static constexpr std::string_view pieces[] = {"Top quality", "Less plastic", "New design"};
  if (product.category == "beverages") return drinks;
  if (product.category == "produce") return fresh;
  if (product.category == "household") return house;
  if (product.category == "personal_care")
    return product.unit_of_measure == "piece" ? std::span<const std::string_view>(pieces) : care;
  return goods_row_of(product) != nullptr ? std::span<const std::string_view>(pets) : foods;
}

}  // namespace

PackFacts pack_facts(const PackArt& art) {
  const catalog::Product& product = *art.product;
  Stream draw = art.seed.child("small print").stream();
  PackFacts facts;
  facts.lot = fmt::format("L {:05}", draw.integer(1, 99999));
  if (const GoodsRow* row = goods_row_of(product)) {
    facts.food = false;
    facts.contents = "Contents: " + std::string(row->contents);
    facts.directions = row->directions;
    if (row->dated) facts.best_before = "Best before " + date_of(product);
    return facts;
  }
  const FoodRow* row = food_row_of(product);
  facts.contents = row == nullptr ? product.description : ingredients_of(*row, product);
  facts.directions = storage_advice(product.storage);
  facts.nutrition_head = product.unit_of_measure == "l" ? "per 100 ml" : "per 100 g";
  if (row != nullptr && row->fat != no_table)
    fill_nutrition(facts, is_sugar_free(product) ? without_sugar(*row) : *row, draw);
  facts.best_before =
      (is_highly_perishable(product) ? "Use by " : "Best before ") + date_of(product);
  return facts;
}

std::string claim_of(const PackArt& art, Stream& draw) {
  const std::span<const std::string_view> claims = claims_for(*art.product);
  return std::string(
      claims[static_cast<std::size_t>(draw.integer(0, static_cast<int>(claims.size()) - 1))]);
}

}  // namespace marketgen::assets
