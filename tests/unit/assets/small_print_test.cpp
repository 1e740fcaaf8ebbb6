// Small print: every product's ingredients and directions are of its kind.
#include "assets/print/small_print.h"

#include <gtest/gtest.h>

#include <cctype>
#include <string>
#include <string_view>

#include "assets/print/pack_facts.h"
#include "base/text.h"
#include "catalog/catalog.h"
#include "io/file.h"

namespace marketgen {
namespace {

catalog::Product product_of(std::string_view category,
                            std::string_view subcategory,
                            std::string_view name) {
  catalog::Product product;
  product.sku = "test";
  product.category = category;
  product.subcategory = subcategory;
  product.name = name;
  return product;
}

assets::PackFacts facts_of(const catalog::Product& product) {
  return assets::pack_facts(assets::pack_art(product).value());
}

TEST(SmallPrint, MatchesWholeWordsAndTheirPlurals) {
  EXPECT_TRUE(assets::has_phrase("Garden Peas", "pea"));
  EXPECT_FALSE(assets::has_phrase("Peach Halves", "pea"));
  EXPECT_TRUE(assets::has_phrase("Peaches", "peach"));
  EXPECT_TRUE(assets::has_phrase("Chopped Tomatoes", "tomato"));
  EXPECT_TRUE(assets::has_phrase("Cranberries, dried", "cranberry"));
  EXPECT_TRUE(assets::has_phrase("Long-Life Milk", "long life milk"));
  EXPECT_FALSE(assets::has_phrase("Ginger Ale", "gin"));
  EXPECT_FALSE(assets::has_phrase("Milk Drink", "milk roll"));
  EXPECT_FALSE(assets::has_phrase("Anything", ""));
}

// Names that a search for the beginnings of words got wrong.
struct Known {
  std::string_view category, subcategory, name, says, says_not;
};

class SmallPrintOf : public testing::TestWithParam<Known> {};

TEST_P(SmallPrintOf, IsOfItsKind) {
  const Known& known = GetParam();
  const assets::PackFacts facts =
      facts_of(product_of(known.category, known.subcategory, known.name));
  const std::string text = facts.contents + " " + facts.directions;
  EXPECT_NE(text.find(known.says), std::string::npos) << known.name << ": " << text;
  EXPECT_EQ(text.find(known.says_not), std::string::npos) << known.name << ": " << text;
}

INSTANTIATE_TEST_SUITE_P(
    Names,
    SmallPrintOf,
    testing::Values(
        Known{"beverages", "soft drinks", "Ginger Ale", "ginger", "spirit"},
        Known{"beverages", "soft drinks", "Root Beer", "Water, sugar", "BARLEY"},
        Known{"beverages", "juice", "Ginger Shot", "ginger juice", "spirit"},
        Known{"beverages", "coffee & tea drinks", "Kombucha", "Fermented tea", "coffee"},
        Known{"beverages", "water", "Coconut Water", "coconuts", "mineral"},
        Known{"bakery", "cakes", "Gingerbread", "honey", "spirit"},
        Known{"canned", "fruit", "Peach Halves", "Peach Halves, water", "salt"},
        Known{"canned", "fruit", "Apple Sauce", "Apples", "Tomatoes"},
        Known{"canned", "fruit", "Red Fruit Dessert", "cherries", "MILK"},
        Known{"canned", "vegetables", "Sweetcorn", "Maize", "gelatine"},
        Known{"canned", "vegetables", "Roasted Peppers", "Roasted Peppers", "spices"},
        Known{"canned", "vegetables", "Water Chestnuts", "Water Chestnuts, water", "mineral"},
        Known{"canned", "beans", "Butter Beans", "Butter Beans, water", "Cream"},
        Known{"canned", "canned meals", "Cabbage Rolls", "meat", "yeast, salt"},
        Known{"canned", "canned meat", "Goose Fat Spread", "Goose fat", "pectin"},
        Known{"canned", "pickles", "Pickled Ginger", "Ginger, water", "spirit"},
        Known{"dairy", "cheese", "Goat Cheese Roll", "goat's MILK", "WHEAT"},
        Known{"dairy", "deli", "Stuffed Peppers", "Sweet peppers", "Sea salt"},
        Known{"dairy", "deli", "Guacamole", "Avocado", "Pork"},
        Known{"dairy", "milk", "Almond Drink", "ALMONDS", "Roasted"},
        Known{"dairy", "milk", "Soy Drink", "SOYA", "MILK"},
        Known{"frozen", "frozen potatoes", "Sweet Potato Fries", "Sweet potatoes", "gelatine"},
        Known{"frozen", "frozen meals", "Spring Rolls", "vegetables", "yeast"},
        Known{"frozen", "frozen meals", "Butter Chicken", "chicken", "cultures"},
        Known{"snacks", "sweets", "Peach Rings", "gelatine", "Beans"},
        Known{"snacks", "crisps", "Rice Cakes", "whole grain rice", "chocolate"},
        Known{"household", "laundry", "Colour Catcher Sheets", "dye", "Meat"},
        Known{"household", "batteries", "Batteries", "mercury", "surfactants"},
        Known{"personal_care", "hair styling", "Hair Brush", "nylon", "sulfate"},
        Known{"dry_goods", "pet food", "Cat Food", "animal", "WHEAT"}),
    [](const testing::TestParamInfo<Known>& row) {
      std::string name;
      for (const char c : row.param.name) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += c;
      }
      return name;
    });

TEST(SmallPrint, AForeignSubcategoryStillFindsItsWords) {  // a user's own catalogue
  const assets::PackFacts facts = facts_of(product_of("personal_care", "teeth", "Toothbrush"));
  EXPECT_NE(facts.contents.find("nylon"), std::string::npos);
}

// The places a row names, without the subcategories.
bool names_category(std::string_view where, const std::string& category) {
  for (const std::string& place : split(where, ',')) {
    const std::string_view name = std::string_view(place).substr(place.find_first_not_of(' '));
    if (name == category || name.starts_with(category + "/")) return true;
  }
  return false;
}

bool names_subcategory(std::string_view where, const catalog::Product& product) {
  return (", " + std::string(where) + ",")
             .find(" " + product.category + "/" + product.subcategory + ",") != std::string::npos;
}

TEST(SmallPrint, EveryRowHasOneForItsOwnShelf) {
  const catalog::Catalog catalog = catalog::load_catalog(io::data_folder().value()).value();
  ASSERT_GE(catalog.products.size(), 200U);
  for (const catalog::Product& product : catalog.products) {
    const assets::GoodsRow* goods = assets::goods_row_of(product);
    const assets::FoodRow* food = assets::food_row_of(product);
    ASSERT_NE(goods == nullptr, food == nullptr) << product.sku;
    const std::string_view where = goods != nullptr ? goods->where : food->where;
    EXPECT_TRUE(names_category(where, product.category)) << product.sku << ": " << where;
    // Produce is one kind of goods; all else has rows for its shelf group.
    if (product.category != "produce") {
      EXPECT_TRUE(names_subcategory(where, product)) << product.sku << ": " << where;
    }
    const bool is_eaten = product.category != "household" && product.category != "personal_care" &&
                          product.subcategory != "pet food";
    EXPECT_EQ(food != nullptr, is_eaten) << product.sku;
  }
}

TEST(SmallPrint, NutritionAddsUp) {
  const catalog::Catalog catalog = catalog::load_catalog(io::data_folder().value()).value();
  for (const catalog::Product& product : catalog.products) {
    const assets::FoodRow* row = assets::food_row_of(product);
    if (row == nullptr || row->fat == assets::no_table) continue;
    EXPECT_LE(row->fat + row->carbohydrate + row->protein + row->salt, 100.5) << row->words;
    EXPECT_LE(row->saturates, row->fat) << row->words;
    EXPECT_LE(row->sugars, row->carbohydrate) << row->words;
  }
}

TEST(PackDates, FollowFromTheShelfLife) {  // the store is as on 2 March 2026
  catalog::Product steak = product_of("dairy", "fresh meat", "Beef Steak");
  steak.storage = catalog::Storage::chilled;
  steak.shelf_life_days = 5;
  EXPECT_EQ(facts_of(steak).best_before, "Use by 07.03.2026");
  catalog::Product rice = product_of("dry_goods", "rice", "Rice");
  rice.shelf_life_days = 365;
  EXPECT_EQ(facts_of(rice).best_before, "Best before 02.03.2027");
  EXPECT_EQ(facts_of(product_of("household", "cleaners", "Bleach")).best_before, "");
}

}  // namespace
}  // namespace marketgen
