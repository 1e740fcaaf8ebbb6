// What a zone sells.
#include "scene/assortment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/text.h"
#include "hand_made_stock.h"

namespace marketgen {
namespace {

plan::Zone zone_of(std::string type) {
  plan::Zone zone;
  zone.id = type;
  zone.type = std::move(type);
  return zone;
}

TEST(NamedBy, WholeWordsOnly) {
  catalog::Product cola = stock_row("cola", "can", {66, 66, 115}, 0.35);
  cola.name = "Cola";
  cola.variant = "Zero Sugar";
  cola.keywords = {"fizzy drink"};
  EXPECT_TRUE(scene::named_by(cola, {"cola"}));
  EXPECT_TRUE(scene::named_by(cola, {"COLA"}));
  EXPECT_TRUE(scene::named_by(cola, {"zero"}));
  EXPECT_TRUE(scene::named_by(cola, {"drink"}));
  EXPECT_TRUE(scene::named_by(cola, {"beans"}));  // its subcategory
  EXPECT_TRUE(scene::named_by(cola, {"tea", "cola"}));
  EXPECT_FALSE(scene::named_by(cola, {"col"}));
  EXPECT_FALSE(scene::named_by(cola, {"ola"}));
  EXPECT_FALSE(scene::named_by(cola, {""}));
  EXPECT_FALSE(scene::named_by(cola, {}));
  catalog::Product chocolate = stock_row("chocolate", "box", {100, 20, 200}, 0.1);
  chocolate.name = "Chocolate";
  EXPECT_FALSE(scene::named_by(chocolate, {"cola"}));
  EXPECT_FALSE(scene::named_by(chocolate, {"late"}));
  catalog::Product chips = stock_row("chips", "pillow_bag", {200, 60, 280}, 0.15);
  chips.name = "Paprika Chips";
  EXPECT_TRUE(scene::named_by(chips, {"chip"}));  // plural of the word
}

TEST(Assortment, ExcludedWordsAreNotThere) {
  const catalog::Catalog& catalog = committed_catalog();
  plan::Zone zone = zone_of("beverages");
  const auto all = scene::assortment_of(zone, catalog::Storage::ambient, catalog);
  zone.stock.exclude = {"cola"};
  const auto without = scene::assortment_of(zone, catalog::Storage::ambient, catalog);
  EXPECT_LT(without.size(), all.size());
  for (const std::uint32_t row : without) {
    EXPECT_EQ(lower_ascii(catalog.products[row].name).find("cola"), std::string::npos)
        << catalog.products[row].sku;
  }
}

TEST(Assortment, EverySellingZoneTypeFindsProducts) {  // on the fixtures that it has by default
  const catalog::Catalog& catalog = committed_catalog();
  constexpr std::size_t fewest = 6;
  for (const catalog::ZoneTypeRow& type : catalog.zone_types) {
    if (type.categories.empty() || type.fixture.empty()) continue;
    const catalog::FixtureKind* kind = catalog.fixture_kind(type.fixture);
    ASSERT_NE(kind, nullptr) << type.type;
    EXPECT_GE(scene::assortment_of(zone_of(type.type), kind->temperature, catalog).size(), fewest)
        << type.type;
  }
}

TEST(Assortment, NothingWarmerThanItMayStand) {
  const catalog::Catalog& catalog = committed_catalog();
  for (const catalog::ZoneTypeRow& type : catalog.zone_types) {
    for (const catalog::Storage temperature :
         {catalog::Storage::ambient, catalog::Storage::chilled, catalog::Storage::frozen}) {
      for (const std::uint32_t row :
           scene::assortment_of(zone_of(type.type), temperature, catalog)) {
        const catalog::Storage needs = catalog.products[row].storage;
        const bool drinks_in_a_cooler =
            temperature == catalog::Storage::chilled && needs == catalog::Storage::ambient;
        EXPECT_TRUE(needs == temperature || drinks_in_a_cooler)
            << type.type << ": " << catalog.products[row].sku;
      }
    }
  }
}

TEST(Assortment, OwnCategoriesReplaceTheZoneTypes) {
  const catalog::Catalog& catalog = committed_catalog();
  plan::Zone zone = zone_of("household");
  zone.stock.categories = {"snacks"};
  const auto rows = scene::assortment_of(zone, catalog::Storage::ambient, catalog);
  ASSERT_FALSE(rows.empty());
  for (const std::uint32_t row : rows)
    EXPECT_EQ(catalog.products[row].category, "snacks");
}

TEST(Assortment, SubcategoriesNarrowTheCategories) {
  const catalog::Catalog& catalog = committed_catalog();
  const std::vector<std::string>& sold = catalog.zone_type("alcohol")->subcategories;
  for (const std::uint32_t row :
       scene::assortment_of(zone_of("alcohol"), catalog::Storage::ambient, catalog)) {
    EXPECT_NE(std::find(sold.begin(), sold.end(), catalog.products[row].subcategory), sold.end())
        << catalog.products[row].sku;
  }
}

// A shopper meets each category once, each subcategory once within it, each brand once within that.
TEST(Assortment, NeighboursBelongTogether) {
  const catalog::Catalog& catalog = committed_catalog();
  for (const char* type : {"beverages", "dairy", "dry_goods", "snacks", "baby_pet"}) {
    const auto rows =
        scene::assortment_of(zone_of(type),
                             catalog.fixture_kind(catalog.zone_type(type)->fixture)->temperature,
                             catalog);
    std::set<std::string> left;
    std::string here;
    for (const std::uint32_t row : rows) {
      const catalog::Product& p = catalog.products[row];
      const std::string group = p.category + "/" + p.subcategory + "/" + p.brand;
      if (group == here) continue;
      EXPECT_FALSE(left.contains(group)) << type << " comes back to " << group;
      left.insert(here);
      here = group;
    }
  }
}

TEST(Assortment, LookAlikesGrowToTheRight) {
  catalog::Catalog catalog = catalog_of({stock_row("a-large", "box", {200, 60, 300}, 0.7),
                                         stock_row("b-small", "box", {100, 60, 200}, 0.3),
                                         stock_row("c-middle", "box", {150, 60, 250}, 0.5)});
  for (catalog::Product& p : catalog.products)
    p.family = "flakes";
  plan::Zone zone;
  zone.stock.categories = {"canned"};
  EXPECT_EQ(scene::assortment_of(zone, catalog::Storage::ambient, catalog),
            (std::vector<std::uint32_t>{1, 2, 0}));
}

TEST(Assortment, CategoriesInTheOrderThatWasGiven) {
  const catalog::Catalog& catalog = committed_catalog();
  plan::Zone zone;
  zone.stock.categories = {"snacks", "canned"};
  const auto rows = scene::assortment_of(zone, catalog::Storage::ambient, catalog);
  ASSERT_GT(rows.size(), 2U);
  EXPECT_EQ(catalog.products[rows.front()].category, "snacks");
  EXPECT_EQ(catalog.products[rows.back()].category, "canned");
}

}  // namespace
}  // namespace marketgen
