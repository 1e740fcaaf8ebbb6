#include "assets/pack_facts.h"

#include <fmt/format.h>

#include <array>
#include <span>

#include "base/text.h"

namespace marketgen {
namespace {

struct FoodRow {
  std::string_view words;
  double fat, saturates, carbohydrate, sugars, protein, salt;
  std::string_view ingredients;
};

constexpr FoodRow food_rows[] = {
#define FOOD(words, fat, saturates, carbohydrate, sugars, protein, salt, ingredients) \
  {words, fat, saturates, carbohydrate, sugars, protein, salt, ingredients},
#include "assets/pack_foods.inc"
#undef FOOD
};

struct GoodsRow {
  std::string_view words, contents, directions;
};

constexpr GoodsRow goods_rows[] = {
#define GOODS(words, contents, directions) {words, contents, directions},
#include "assets/pack_goods.inc"
#undef GOODS
};

// Whether a word of the text begins with `word`: "tea" is in "green tea bags", not in "steak".
bool has_word_with(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + 1)) {
    if (at == 0 || text[at - 1] == ' ' || text[at - 1] == '-') return true;
  }
  return false;
}

// The row of `rows` that the text speaks of first; null when there is none.
template <class Row>
const Row* row_about(std::span<const Row> rows, const std::string& text) {
  for (const Row& row : rows) {
    for (const std::string& word : split(row.words, '|')) {
      if (has_word_with(text, word)) return &row;
    }
  }
  return nullptr;
}

// By the name, which says most; failing that by the shelf group.
template <class Row>
const Row* row_for(std::span<const Row> rows, const Product& product) {
  const Row* row = row_about(rows, lower_ascii(product.name));
  if (row != nullptr) return row;
  return row_about(rows, lower_ascii(product.subcategory + " " + product.category));
}

bool is_food(const Product& product) {
  const std::string category = lower_ascii(product.category);
  for (const std::string_view word : {"household", "personal", "care", "clean", "pet", "baby"}) {
    if (category.find(word) != std::string::npos) return false;
  }
  return true;
}

std::string grams(double amount) {
  return amount < 0.05 ? "0 g"
         : amount < 10 ? fmt::format("{:.1f} g", amount)
                       : fmt::format("{:.0f} g", amount);
}

// "Zero Sugar", "Light": sweetened with something else.
bool is_sugar_free(const std::string& variant) {
  const std::string text = lower_ascii(variant);
  for (const std::string_view word :
       {"zero", "light", "diet", "sugar free", "no sugar", "sugar-free"}) {
    if (text.find(word) != std::string::npos) return true;
  }
  return false;
}

FoodRow without_sugar(FoodRow row) {
  row.carbohydrate -= row.sugars;
  row.sugars = 0;
  return row;
}

// Each maker's own figures lie within a tenth of the kind's.
void fill_nutrition(PackFacts& facts, const FoodRow& row, Stream& draw) {
  const double maker = draw.uniform(0.9, 1.1);
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

std::string storage_advice(Storage storage) {
  switch (storage) {
    case Storage::ambient:
      return "Store in a cool, dry place. Once opened, consume soon.";
    case Storage::chilled:
      return "Keep refrigerated at 2 to 7 \u00b0C. Once opened, consume within 3 days.";
    case Storage::frozen:
      return "Store at -18 \u00b0C or below. Do not refreeze after thawing.";
  }
  return {};
}

// A date printed at the plant; the calendar does not matter, only that it is a possible one.
std::string date_after(std::string_view words, Stream& draw) {
  const int day = draw.integer(1, 28);
  const int month = draw.integer(1, 12);
  return fmt::format("{} {:02}.{:02}.{}", words, day, month, draw.integer(2027, 2029));
}

}  // namespace

PackFacts pack_facts(const PackArt& art) {
  const Product& product = *art.product;
  Stream draw = art.seed.child("small print").stream();
  PackFacts facts;
  facts.food = is_food(product);
  facts.lot = fmt::format("L {:05}", draw.integer(1, 99999));
  if (!facts.food) {
    const GoodsRow* row = row_for(std::span<const GoodsRow>(goods_rows), product);
    facts.contents =
        row == nullptr ? product.description : "Contents: " + std::string(row->contents);
    facts.directions =
        row == nullptr ? "Keep out of reach of children." : std::string(row->directions);
    return facts;
  }
  const FoodRow* row = row_for(std::span<const FoodRow>(food_rows), product);
  facts.contents =
      row == nullptr ? product.description : "Ingredients: " + std::string(row->ingredients);
  facts.directions = storage_advice(product.storage);
  facts.nutrition_head = product.unit_of_measure == "l" ? "per 100 ml" : "per 100 g";
  if (row != nullptr)
    fill_nutrition(facts, is_sugar_free(product.variant) ? without_sugar(*row) : *row, draw);
  facts.best_before = date_after("Best before", draw);
  return facts;
}

std::string claim_of(const PackArt& art, Stream& draw) {
  constexpr std::array food_claims{"No added colours",
                                   "100 % natural taste",
                                   "Source of energy",
                                   "Less plastic",
                                   "Family size",
                                   "Vegetarian",
                                   "Quality since 1962",
                                   "Traditional recipe"};
  constexpr std::array drink_claims{
      "Ice cold", "100 % recycled", "No sweeteners", "Naturally good", "Refreshing taste"};
  constexpr std::array care_claims{"Dermatologist tested",
                                   "48 h fresh",
                                   "Vegan formula",
                                   "pH neutral",
                                   "Extra gentle",
                                   "2 x stronger"};
  const auto one_of = [&](const auto& claims) {
    return std::string(
        claims[static_cast<std::size_t>(draw.integer(0, static_cast<int>(claims.size()) - 1))]);
  };
  if (!is_food(*art.product)) return one_of(care_claims);
  return art.product->unit_of_measure == "l" ? one_of(drink_claims) : one_of(food_claims);
}

}  // namespace marketgen
