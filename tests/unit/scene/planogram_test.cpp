// The planogram: what goes on which shelf.
#include "scene/planogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "hand_made_stock.h"

namespace marketgen {
namespace {

TEST(StackHeight, KnownAnswers) {  // 25 mm stay free for a hand
  const catalog::Product tin = stock_row("tin", "food_tin", {75, 75, 110}, 0.4, 3);
  EXPECT_EQ(scene::stack_height(tin, shelf_room(1, 0.5, 0.134)), 0);  // 109 mm are usable
  EXPECT_EQ(scene::stack_height(tin, shelf_room(1, 0.5, 0.136)), 1);  // 111 mm
  EXPECT_EQ(scene::stack_height(tin, shelf_room(1, 0.5, 0.244)), 1);  // 219 mm
  EXPECT_EQ(scene::stack_height(tin, shelf_room(1, 0.5, 0.246)), 2);  // 221 mm
  EXPECT_EQ(scene::stack_height(tin, shelf_room(1, 0.5, 0.9)), 3);    // the row allows three
  const catalog::Product bottle = stock_row("bottle", "wine_bottle", {75, 75, 300}, 1.3, 1);
  EXPECT_EQ(scene::stack_height(bottle, shelf_room(1, 0.5, 2.0)), 1);
}

TEST(StackHeight, HeavyPacksRestLow) {  // also those that stand on others
  const auto packs = [](double mass_kg, double board_m) {
    const catalog::Product pack = stock_row("pack", "box", {200, 200, 200}, mass_kg, 3);
    scene::ShelfRoom room = shelf_room(1, 0.5, 0.9);
    room.board_m = board_m;
    return scene::stack_height(pack, room);
  };
  EXPECT_EQ(packs(1.9, 1.7), 3);
  EXPECT_EQ(packs(2, 1.7), 0) << "the stretch level begins at 1.60 m";
  EXPECT_EQ(packs(2, 1.3), 2) << "at 1.3 and 1.5 m";
  EXPECT_EQ(packs(2, 1.1), 3);
  EXPECT_EQ(packs(8, 1.1), 1) << "more than 7 kg rest below 1.15 m";
  EXPECT_EQ(packs(8, 0.9), 2);
  EXPECT_EQ(packs(8, 1.2), 0);
}

scene::Bay bay_of(std::vector<scene::ShelfRoom> shelves, bool promotion = false) {
  return {std::move(shelves), promotion};
}

std::vector<scene::PlannedShelf> planned(const scene::Bay& bay,
                                         const catalog::Catalog& catalog,
                                         const plan::StockSpec& stock,
                                         std::uint64_t seed = 1) {
  scene::AssortmentCursor cursor;
  return scene::plan_bay(bay, all_rows(catalog), stock, catalog, cursor, Stream(seed));
}

double planned_width(const scene::PlannedShelf& shelf, const catalog::Catalog& catalog) {
  double width = 0;
  for (const scene::PlannedBlock& block : shelf) {
    width += block.facings * (catalog.products[block.product].width_m() + scene::pack_gap_m);
  }
  return width;
}

TEST(PlanBay, EmptyAssortmentGivesEmptyShelves) {
  const catalog::Catalog none;
  const auto shelves = planned(bay_of({shelf_room(), shelf_room()}), none, {});
  ASSERT_EQ(shelves.size(), 2U);
  EXPECT_TRUE(shelves[0].empty() && shelves[1].empty());
}

TEST(PlanBay, OneProductFillsTheShelfUpToItsLimit) {  // 1.2 m at 0.95 take 14 cans of 76 + 4 mm, in
                                                      // blocks of at most 8
  const catalog::Catalog catalog = catalog_of({stock_row("tin", "food_tin", {76, 76, 110}, 0.4)});
  const auto shelves = planned(bay_of({shelf_room()}), catalog, {});
  int facings = 0;
  for (const scene::PlannedBlock& block : shelves[0]) {
    EXPECT_LE(block.facings, scene::max_facings);
    facings += block.facings;
  }
  EXPECT_EQ(facings, 14);
}

TEST(PlanBay, HeavyGoodsStandLow) {  // four products, each of which fills one level
  catalog::Catalog catalog = catalog_of({stock_row("a-light", "box", {280, 200, 200}, 0.2),
                                         stock_row("b-water", "bundle", {280, 200, 200}, 9),
                                         stock_row("c-flour", "paper_bag", {280, 200, 200}, 2),
                                         stock_row("d-tea", "box", {280, 200, 200}, 0.1)});
  plan::StockSpec stock;
  stock.facings = {4, 4};
  stock.fill = 1;
  const auto shelves =
      planned(bay_of({shelf_room(), shelf_room(), shelf_room(), shelf_room()}), catalog, stock);
  std::vector<std::string> from_below;
  for (const scene::PlannedShelf& shelf : shelves)
    from_below.push_back(catalog.products[shelf.at(0).product].sku);
  EXPECT_EQ(from_below, (std::vector<std::string>{"b-water", "c-flour", "a-light", "d-tea"}));
}

TEST(PlanBay, MeanMassFallsWithEveryLevelOfARealAssortment) {
  const catalog::Catalog& catalog = committed_catalog();
  std::vector<std::uint32_t> drinks;
  for (std::uint32_t i = 0; i < catalog.products.size(); ++i) {
    if (catalog.products[i].category == "beverages" || catalog.products[i].category == "canned")
      drinks.push_back(i);
  }
  std::array<double, 4> mass{};
  std::array<int, 4> facings{};
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    scene::AssortmentCursor cursor{seed * 3};
    const scene::Bay bay = bay_of({shelf_room(1.2, 0.45, 0.4),
                                   shelf_room(1.2, 0.45, 0.36),
                                   shelf_room(1.2, 0.45, 0.36),
                                   shelf_room(1.2, 0.45, 0.36)});
    const auto shelves = scene::plan_bay(bay, drinks, {}, catalog, cursor, Stream(seed));
    for (std::size_t level = 0; level < 4; ++level) {
      for (const scene::PlannedBlock& block : shelves[level]) {
        mass[level] += block.facings * catalog.products[block.product].mass_kg;
        facings[level] += block.facings;
      }
    }
  }
  for (std::size_t level = 0; level < 4; ++level)
    mass[level] /= facings[level];
  EXPECT_GT(mass[0], mass[1]);
  EXPECT_GT(mass[0], 1.5 * mass[3]);
  EXPECT_GT(mass[1], mass[3]);
}

TEST(PlanBay,
     LevelsKeepTheAssortmentsOrder) {  // vertical blocks: the same brand one above the other
  std::vector<catalog::Product> rows;
  for (int i = 0; i < 12; ++i)
    rows.push_back(
        stock_row("p" + std::to_string(10 + i), "box", {90, 90, 200}, 0.1 + 0.05 * ((i * 7) % 12)));
  const catalog::Catalog catalog = catalog_of(std::move(rows));
  const auto shelves = planned(bay_of({shelf_room(), shelf_room(), shelf_room()}), catalog, {});
  for (const scene::PlannedShelf& shelf : shelves) {
    for (std::size_t i = 1; i < shelf.size(); ++i)
      EXPECT_LE(shelf[i - 1].product, shelf[i].product);
  }
}

TEST(PlanBay, TallGoodsGoWhereTheyFit) {  // 300 mm stand only on the second level
  const catalog::Catalog catalog =
      catalog_of({stock_row("bottle", "wine_bottle", {80, 80, 300}, 1.3),
                  stock_row("tin", "food_tin", {80, 80, 100}, 0.4)});
  const auto shelves =
      planned(bay_of({shelf_room(1, 0.4, 0.2), shelf_room(1, 0.4, 0.35)}), catalog, {});
  for (const scene::PlannedBlock& block : shelves[0])
    EXPECT_EQ(block.product, 1U);
  EXPECT_TRUE(std::any_of(shelves[1].begin(), shelves[1].end(), [](const scene::PlannedBlock& b) {
    return b.product == 0;
  }));
}

TEST(PlanBay, CratesAreNotLiftedOverTheShoulders) {  // though only the top has room for them
  const catalog::Catalog catalog = catalog_of({stock_row("crate", "crate", {400, 300, 300}, 19.8),
                                               stock_row("tin", "food_tin", {75, 75, 110}, 0.4)});
  scene::ShelfRoom low = shelf_room(1.2, 0.45, 0.25), high = shelf_room(1.2, 0.45, 0.60);
  low.board_m = 0.2, high.board_m = 1.4;
  const auto shelves = planned(bay_of({low, high}), catalog, {});
  for (const scene::PlannedShelf& shelf : shelves) {
    ASSERT_FALSE(shelf.empty());
    for (const scene::PlannedBlock& block : shelf)
      EXPECT_EQ(catalog.products[block.product].sku, "tin");
  }
  high.board_m = 1.1;
  const auto lower = planned(bay_of({low, high}), catalog, {});
  EXPECT_TRUE(
      std::ranges::any_of(lower[1], [](const scene::PlannedBlock& b) { return b.product == 0; }));
}

TEST(PlanBay, NothingThatIsTooDeepOrTooWide) {
  const catalog::Catalog catalog = catalog_of({stock_row("deep", "box", {100, 500, 100}, 1),
                                               stock_row("wide", "box", {1300, 100, 100}, 1)});
  const auto shelves = planned(bay_of({shelf_room(1.2, 0.45, 0.3)}), catalog, {});
  EXPECT_TRUE(shelves[0].empty());
}

TEST(PlanBay, PromotionsShowFewProductsInManyFacings) {
  std::vector<catalog::Product> rows;
  for (int i = 0; i < 20; ++i)
    rows.push_back(stock_row("p" + std::to_string(10 + i), "can", {66, 66, 115}, 0.35));
  const catalog::Catalog catalog = catalog_of(std::move(rows));
  const auto usual = planned(bay_of({shelf_room(), shelf_room()}), catalog, {});
  const auto promotion = planned(bay_of({shelf_room(), shelf_room()}, true), catalog, {});
  const auto products = [](const std::vector<scene::PlannedShelf>& shelves) {
    std::map<std::uint32_t, int> seen;
    for (const scene::PlannedShelf& shelf : shelves) {
      for (const scene::PlannedBlock& block : shelf)
        seen[block.product] += block.facings;
    }
    return seen.size();
  };
  EXPECT_LE(products(promotion), 4U);
  EXPECT_GT(products(usual), 2 * products(promotion));
}

TEST(PlanBay, TheNextBayGoesOnWhereThisOneEnded) {
  std::vector<catalog::Product> rows;
  for (int i = 0; i < 40; ++i)
    rows.push_back(stock_row("p" + std::to_string(10 + i), "box", {90, 90, 200}, 0.3));
  const catalog::Catalog catalog = catalog_of(std::move(rows));
  scene::AssortmentCursor cursor;
  scene::plan_bay(bay_of({shelf_room()}), all_rows(catalog), {}, catalog, cursor, Stream(1));
  const std::size_t after_one = cursor.next;
  EXPECT_GT(after_one, 1U);
  EXPECT_LT(after_one, 10U);  // a shelf of 1.14 m takes 12 facings, two to four of each
  scene::plan_bay(bay_of({shelf_room()}), all_rows(catalog), {}, catalog, cursor, Stream(2));
  EXPECT_GT(cursor.next, after_one);
}

// Random bays, stocks and slices of the real rows.
TEST(PlanBay, FacingsAndWidthsStayWithinTheirLimits) {
  const catalog::Catalog& catalog = committed_catalog();
  const auto rows = all_rows(catalog);
  int blocks = 0, narrower_than_asked = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Stream draw(seed);
    scene::Bay bay;
    bay.promotion = draw.chance(0.2);
    for (int level = draw.integer(1, 6); level > 0; --level) {
      bay.shelves.push_back(
          shelf_room(draw.uniform(0.5, 2.5), draw.uniform(0.25, 0.9), draw.uniform(0.15, 0.6)));
    }
    plan::StockSpec stock;
    stock.facings = {draw.integer(1, 3), draw.integer(3, 6)};
    stock.fill = draw.uniform(0.3, 1.0);
    scene::AssortmentCursor cursor{static_cast<std::size_t>(draw.integer(0, 300))};
    const auto shelves = scene::plan_bay(bay, rows, stock, catalog, cursor, Stream(seed + 1000));
    ASSERT_EQ(shelves.size(), bay.shelves.size());
    for (std::size_t level = 0; level < shelves.size(); ++level) {
      EXPECT_LE(planned_width(shelves[level], catalog),
                bay.shelves[level].width_m * stock.fill + 1e-9)
          << seed;
      for (const scene::PlannedBlock& block : shelves[level]) {
        EXPECT_GE(block.facings, 1);
        EXPECT_LE(block.facings, scene::max_facings);
        EXPECT_GT(scene::stack_height(catalog.products[block.product], bay.shelves[level]), 0);
        ++blocks;
        narrower_than_asked += block.facings < stock.facings[0] ? 1 : 0;
      }
    }
  }
  EXPECT_GT(blocks, 1500);
  // Fewer facings than asked for only where no more fit: the last gap of a shelf, or a wide pack on
  // a narrow one.
  EXPECT_LT(narrower_than_asked, blocks / 5);
}

TEST(PlanBay, FullShelvesAreReallyFull) {  // what is left of a level is narrower than its narrowest
                                           // fitting pack
  const catalog::Catalog& catalog = committed_catalog();
  plan::StockSpec stock;
  stock.fill = 1;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    scene::AssortmentCursor cursor{seed * 5};
    const auto shelves =
        scene::plan_bay(bay_of({shelf_room(1.23, 0.45, 0.35), shelf_room(1.23, 0.45, 0.35)}),
                        all_rows(catalog),
                        stock,
                        catalog,
                        cursor,
                        Stream(seed));
    for (const scene::PlannedShelf& shelf : shelves)
      EXPECT_GT(planned_width(shelf, catalog), 0.94 * 1.23);
  }
}

}  // namespace
}  // namespace marketgen
