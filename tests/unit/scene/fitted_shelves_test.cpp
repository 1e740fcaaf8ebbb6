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
#include "scene/shelf_fill.h"
#include "scene/shelf_shares.h"
#include "scene/store_catalog.h"
#include "scene/zone_range.h"
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

// Of a bay for each height, beside one another.
std::vector<std::vector<int>> boards_of(const std::vector<int>& heights_mm) {
  std::vector<catalog::Product> rows;
  std::vector<scene::BayRange> ranges;
  for (const int height_mm : heights_mm) {
    scene::BayRange& range = ranges.emplace_back(eight_products());
    for (scene::RangedGoods& goods : range) {
      goods.product = static_cast<std::uint32_t>(rows.size());
      const std::string sku = "p" + std::to_string(rows.size());
      rows.push_back(stock_row(sku, "food_tin", {75, 75, height_mm}, 0.4, 1));
    }
  }
  const catalog::Catalog catalog = catalog_of(std::move(rows));
  const scene::BayOpening opening = gondola_opening();
  std::vector<scene::FitBay> bays;
  for (const scene::BayRange& range : ranges)
    bays.push_back({&opening, &range});
  return scene::fitted_spacings(bays, {}, catalog);
}

std::vector<int> boards_for(int height_mm) {
  return boards_of({height_mm}).front();
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

TEST(FittedBoards, RunThroughNeighboursWhereTheyShowAsMuch) {
  const std::vector<std::vector<int>> alike = boards_of({150, 154, 145});
  EXPECT_EQ(alike, std::vector(3, alike[0]));
  for (std::size_t i = 0; i + 1 < alike[0].size(); ++i)
    EXPECT_GE(alike[0][i] - 41, 154 + 35);  // the tallest of all
  const std::vector<std::vector<int>> apart = boards_of({110, 400});
  EXPECT_EQ(apart, (std::vector{boards_for(110), boards_for(400)}));
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

// Four produce tables in a row, so that goods go on from one to the next.
TEST(FittedShelves, LooseGoodsLieInHeapsAndNotInSingleFile) {
  HandLaidShop shop = shop_of({"produce"});
  shop.plan.shelves = plan::ShelfPitch::fitted;
  shop.plan.zones[0].stock.out_of_stock = 0;
  const layout::Fixture first = shop.layout.fixtures[0];
  for (int number = 2; number <= 4; ++number) {
    layout::Fixture next = first;
    next.id = first.run + "/module-" + std::to_string(number);
    next.x_mm = first.x_mm + (number - 1) * first.width_mm;
    shop.layout.fixtures.push_back(next);
  }
  std::size_t heaps = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const scene::Scene scene = scene_of(shop, seed);
    std::map<std::uint32_t, double> taken_m;
    for (const scene::Facing& facing : scene.facings) {
      ASSERT_EQ(scene.shelves[facing.shelf].use, assets::ShelfUse::heap);
      const catalog::Product& product = scene.catalog[facing.sku];
      EXPECT_GE(facing.width_m, scene::min_heap_front_m(product) - 1e-6) << product.sku;
      taken_m[facing.shelf] += facing.width_m;
      ++heaps;
    }
    EXPECT_EQ(taken_m.size(), scene.shelves.size());
    for (const auto& [shelf, width_m] : taken_m)
      EXPECT_GE(width_m, 0.7 * scene.shelves[shelf].width_m) << shelf;
  }
  EXPECT_GT(heaps, 40U);
}

plan::Plan fitted_plan() {
  plan::Plan plan;
  plan.shelves = plan::ShelfPitch::fitted;
  return plan;
}

TEST(StoreCatalog, BreadAndBunchesArePiledWhereBoardsAreFitted) {
  const catalog::Catalog& rows = committed_catalog();
  EXPECT_EQ(&scene::StoreCatalog(rows, plan::Plan{}).get(), &rows);
  const plan::Plan plan = fitted_plan();
  const scene::StoreCatalog piled(rows, plan);
  std::size_t loaves = 0, bunches = 0;
  for (std::size_t i = 0; i < rows.products.size(); ++i) {
    const catalog::Product &row = rows.products[i], &now = piled.get().products[i];
    ASSERT_EQ(now.sku, row.sku);
    EXPECT_GE(now.stack_max, row.stack_max) << row.sku;
    if (row.archetype == "loaf" && row.height_m() <= 0.12) {
      EXPECT_GE(now.stack_max, 2) << row.sku;
      ++loaves;
    } else if (row.archetype == "herb_bunch") {
      EXPECT_GE(now.stack_max, 2) << row.sku;
      ++bunches;
    } else if (row.archetype == "milk_jug" || row.archetype == "tray") {
      EXPECT_EQ(now.stack_max, row.stack_max) << row.sku;
    }
    EXPECT_LE(now.stack_max * now.height_m(), std::max(0.25, row.stack_max * row.height_m()))
        << row.sku;
  }
  EXPECT_GT(loaves, 30U);
  EXPECT_GT(bunches, 2U);
}

TEST(StoreCatalog, LeavesRowsOfTheUsersOwn) {
  catalog::Catalog rows = catalog_of({stock_row("a-loaf", "loaf", {225, 108, 108}, 0.5),
                                      stock_row("own-loaf", "loaf", {225, 108, 108}, 0.5)});
  rows.own = {"own-loaf"};
  const plan::Plan plan = fitted_plan();
  const scene::StoreCatalog piled(rows, plan);
  EXPECT_EQ(piled.get().product("a-loaf")->stack_max, 2);
  EXPECT_EQ(piled.get().product("own-loaf")->stack_max, 1);
}

// What shoppers took of a pile is missing on top; the board is covered from front to back.
TEST(PiledBunches, LieOverTheWholeDepth) {
  catalog::Product leek = stock_row("leek", "leek", {336, 39, 39}, 0.3, 3);
  leek.category = "produce";
  leek.material = "skin";
  leek.orientation = catalog::Orientation::flat;
  const catalog::Catalog catalog = catalog_of({leek});
  const scene::ShelfRoom room{1.2, 0.54, 0.2, assets::ShelfUse::heap};
  plan::StockSpec stock;
  stock.jitter = 1;
  stock.out_of_stock = 0;
  const auto blocks = scene::fill_shelf({{0, 3}}, room, stock, catalog, Stream(7));
  ASSERT_EQ(blocks.size(), 1U);
  std::map<std::pair<double, double>, int> high;
  for (const scene::ShelfItem& item : blocks[0].items)
    ++high[{item.position.x, item.position.y}];
  EXPECT_EQ(high.size(), static_cast<std::size_t>(3 * blocks[0].rows_deep));
  double front_m = 1, back_m = 0;
  int lower = 0;
  for (const auto& [at, count] : high) {
    front_m = std::min(front_m, at.second - leek.depth_m() / 2);
    back_m = std::max(back_m, at.second + leek.depth_m() / 2);
    EXPECT_GE(count, 2);
    lower += count == 2 ? 1 : 0;
  }
  EXPECT_GE(front_m, 0);
  EXPECT_LE(back_m, room.depth_m);
  EXPECT_LT(room.depth_m - (back_m - front_m), 0.04);
  EXPECT_GT(lower, 0);
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
