// Boards fitted to their goods, and how a zone's front is shared among kinds of goods.
#include "scene/fitted_shelves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "hand_made_stock.h"
#include "plan/plan.h"
#include "scene/fitted_boards.h"
#include "scene/planogram_rows.h"
#include "scene/shelf_shares.h"
#include "scene_of.h"

namespace marketgen {
namespace {

scene::BayOpening gondola_opening() {
  return {1.2, 0.45, 0.15, 1.65, true, 0.041, 0.05, {2, 8}};
}

// Eight products of one height, half a metre of front each.
scene::BayRange eight_products() {
  scene::BayRange range;
  for (std::uint32_t row = 0; row < 8; ++row)
    range.push_back({row, 0.5});
  return range;
}

std::vector<int> boards_for(int height_mm, const std::vector<int>& beside = {}) {
  std::vector<catalog::Product> rows;
  for (int i = 0; i < 8; ++i)
    rows.push_back(stock_row("p" + std::to_string(i), "food_tin", {75, 75, height_mm}, 0.4, 1));
  const catalog::Catalog catalog = catalog_of(std::move(rows));
  return scene::fitted_spacings(gondola_opening(), eight_products(), {}, catalog, beside);
}

TEST(FittedBoards, LowPacksHaveMoreBoardsThanTallOnes) {
  EXPECT_GT(boards_for(110).size(), boards_for(240).size());
  EXPECT_GT(boards_for(240).size(), boards_for(400).size());
}

TEST(FittedBoards, HangInSlotsAndLeaveAHandOverThePacks) {
  for (const int height_mm : {90, 150, 240, 320}) {
    const std::vector<int> boards = boards_for(height_mm);
    ASSERT_GE(boards.size(), 2U);
    int sum_mm = 0;
    for (std::size_t i = 0; i + 1 < boards.size(); ++i) {
      EXPECT_EQ(boards[i] % 50, 0);
      EXPECT_GE(boards[i] - 41, height_mm + 35);
      sum_mm += boards[i];
    }
    EXPECT_LE(sum_mm + boards.back(), 1650);
  }
}

TEST(FittedBoards, RunThroughFromTheBayBesideWhereTheyShowAsMuch) {
  const std::vector<int> own = boards_for(150);
  EXPECT_EQ(boards_for(145, own), own);
  EXPECT_NE(boards_for(400, own), own);  // they do not hold it
}

HandLaidShop fitted_shop() {
  HandLaidShop shop = shop_of(selling_types());
  shop.plan.shelves = plan::ShelfPitch::fitted;
  return shop;
}

TEST(FittedShelves, APlanThatSaysNothingHasEvenBoards) {
  const HandLaidShop shop = shop_of(selling_types());
  HandLaidShop even = shop;
  even.plan.shelves = plan::ShelfPitch::even;
  const scene::Scene scene = scene_of(shop);
  EXPECT_EQ(scene::scene_hash(scene_of(even)), scene::scene_hash(scene));
  for (const layout::Fixture& fixture : scene.layout.fixtures)
    EXPECT_FALSE(fixture.spacings_mm.has_value());
}

TEST(FittedShelves, BoardsStandAsTheLayoutSaysAndHoldTheirGoods) {
  const scene::Scene scene = scene_of(fitted_shop());
  std::size_t fitted = 0;
  for (std::size_t f = 0; f < scene.fixtures.size(); ++f) {
    const layout::Fixture& fixture = scene.layout.fixtures[f];
    if (!fixture.spacings_mm) continue;
    ++fitted;
    EXPECT_EQ(fixture.levels, static_cast<int>(fixture.spacings_mm->size()));
    const scene::SceneShelf* below = nullptr;
    for (std::uint32_t s = 0; s < scene.fixtures[f].shelf_count; ++s) {
      const scene::SceneShelf& shelf = scene.shelves[scene.fixtures[f].first_shelf + s];
      if (shelf.side != 0) continue;
      if (below != nullptr) {
        EXPECT_NEAR(shelf.position_m[2] - below->position_m[2],
                    (*fixture.spacings_mm)[static_cast<std::size_t>(below->level)] * 1e-3,
                    1e-6);
      }
      below = &shelf;
    }
  }
  EXPECT_GT(fitted, 0U);
  for (const scene::PlanogramRow& row : scene::planogram_rows(scene))
    EXPECT_GT(row.facings, 0);
}

// The same again from a layout whose boards are fitted already: an edit lets kept fixtures stand.
TEST(FittedShelves, AreTheSameFromALayoutThatHasThem) {
  HandLaidShop shop = fitted_shop();
  const scene::Scene first = scene_of(shop);
  shop.layout = first.layout;
  EXPECT_EQ(scene::scene_hash(scene_of(shop)), scene::scene_hash(first));
  EXPECT_TRUE(scene::same_but_for_boards(first.layout, fitted_shop().layout));
}

TEST(ShelfShares, EachNamesGoodsThatThereAre) {
  std::set<std::pair<std::string_view, std::string_view>> kinds, names, rows;
  for (const catalog::Product& product : committed_catalog().products) {
    kinds.insert({product.category, product.subcategory});
    names.insert({product.category, product.name});
  }
  for (const scene::ShelfShare& row : scene::shelf_shares()) {
    EXPECT_TRUE(kinds.contains({row.category, row.subcategory})) << row.subcategory;
    EXPECT_TRUE(rows.insert({row.category, row.subcategory}).second) << row.subcategory;
  }
  EXPECT_EQ(rows.size(), kinds.size());  // every kind has one
  for (const scene::GoodsShare& row : scene::goods_shares())
    EXPECT_TRUE(names.contains({row.category, row.name})) << row.name;
}

TEST(ShelfShares, MilkHasMoreRoomThanEggs) {
  std::map<std::string, double> front_m;
  const scene::Scene scene = scene_of(fitted_shop());
  for (const scene::Facing& facing : scene.facings) {
    const layout::Fixture& fixture = scene.layout.fixtures[scene.shelves[facing.shelf].fixture];
    const catalog::Product& product = scene.catalog[facing.sku];
    if (fixture.zone == "dairy") front_m[product.subcategory] += facing.width_m;
  }
  ASSERT_FALSE(front_m.empty());
  EXPECT_GT(front_m["milk"], 2 * front_m["eggs"]);
  EXPECT_GT(front_m["yoghurt"], 2 * front_m["eggs"]);
  EXPECT_GT(front_m["cheese"], 2 * front_m["eggs"]);
}

}  // namespace
}  // namespace marketgen
