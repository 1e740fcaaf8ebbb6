// Brand blocks: whose goods stand where in a bay, and how many facings they have.
#include "scene/brand_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "hand_made_stock.h"
#include "scene/assortment.h"
#include "scene/bays.h"
#include "scene/demand.h"
#include "scene/shelf_fill.h"
#include "scene_of.h"

namespace marketgen {
namespace {

using plan::BlockPattern;
using scene::PlannedShelf;

scene::Bay gondola_of(int boards, double width_m = 1.0) {
  scene::Bay bay;
  for (int level = 0; level < boards; ++level) {
    bay.shelves.push_back(shelf_room(width_m, 0.45, 0.34));
    bay.shelves.back().board_m = 0.15 + 0.36 * level;
  }
  return bay;
}

// So many tins of each brand, in the order of the catalogue.
catalog::Catalog tins_of(const std::vector<std::string>& brands, int each, double mass_kg = 0.4) {
  std::vector<catalog::Product> rows;
  for (const std::string& brand : brands) {
    for (int i = 0; i < each; ++i) {
      rows.push_back(
          stock_row(brand + "-" + std::to_string(i), "food_tin", {75, 75, 110}, mass_kg, 2));
      rows.back().brand = brand;
    }
  }
  return catalog_of(std::move(rows));
}

std::vector<PlannedShelf> blocked(const scene::Bay& bay,
                                  const catalog::Catalog& catalog,
                                  BlockPattern block,
                                  const std::vector<std::uint32_t>& certain = {}) {
  plan::StockSpec stock;
  stock.block = block;
  scene::AssortmentCursor cursor;
  return scene::plan_brand_blocks(
      bay, all_rows(catalog), stock, catalog, cursor, Stream(1), certain);
}

// Left and right end of each brand's goods on each board.
using Extents = std::map<std::string, std::map<std::size_t, std::pair<double, double>>>;

Extents extents_of(const std::vector<PlannedShelf>& shelves, const catalog::Catalog& catalog) {
  Extents extents;
  for (std::size_t level = 0; level < shelves.size(); ++level) {
    for (const scene::PlannedBlock& block : shelves[level]) {
      const double end_m = *block.x_m + scene::block_width_m(block, catalog);
      auto& extent = extents[catalog.products[block.product].brand]
                         .try_emplace(level, std::pair(*block.x_m, end_m))
                         .first->second;
      extent = {std::min(extent.first, *block.x_m), std::max(extent.second, end_m)};
    }
  }
  return extents;
}

void expect_room_for_all(const scene::Bay& bay,
                         const std::vector<PlannedShelf>& shelves,
                         const catalog::Catalog& catalog) {
  for (std::size_t level = 0; level < shelves.size(); ++level) {
    double end_m = 0;
    for (const scene::PlannedBlock& block : shelves[level]) {
      EXPECT_GE(*block.x_m, end_m);
      end_m = *block.x_m + scene::block_width_m(block, catalog);
      EXPECT_TRUE(scene::fits(catalog.products[block.product], bay.shelves[level]));
    }
    EXPECT_LE(end_m, bay.shelves[level].width_m);
  }
}

TEST(BrandBlocks, GiveEachBrandAColumnOverAllBoards) {
  const catalog::Catalog catalog = tins_of({"Anda", "Bolo", "Cira"}, 5);
  const scene::Bay bay = gondola_of(5);
  const auto shelves = blocked(bay, catalog, BlockPattern::brand_columns);
  expect_room_for_all(bay, shelves, catalog);
  const Extents extents = extents_of(shelves, catalog);
  ASSERT_GE(extents.size(), 2U);
  double left_m = 0;
  for (const auto& [brand, levels] : extents) {  // by name, as the catalogue has them
    EXPECT_EQ(levels.size(), bay.shelves.size()) << brand;
    double right_m = left_m;
    for (const auto& [level, extent] : levels) {
      EXPECT_GE(extent.first, left_m) << brand << " on board " << level;
      right_m = std::max(right_m, extent.second);
    }
    left_m = right_m;
  }
}

TEST(BrandBlocks, HorizontalKeepsABrandOnFewBoards) {
  const catalog::Catalog catalog = tins_of({"Anda", "Bolo", "Cira"}, 9);
  const scene::Bay bay = gondola_of(6);
  const auto upright = extents_of(blocked(bay, catalog, BlockPattern::brand_columns), catalog);
  const auto shelves = blocked(bay, catalog, BlockPattern::brand_horizontal);
  expect_room_for_all(bay, shelves, catalog);
  for (const auto& [brand, levels] : extents_of(shelves, catalog)) {
    EXPECT_LT(levels.size(), upright.at(brand).size()) << brand;
    const std::size_t lowest = levels.begin()->first, highest = levels.rbegin()->first;
    EXPECT_EQ(highest - lowest + 1, levels.size()) << brand << " has boards apart";
  }
}

TEST(BrandBlocks, WhatIsAskedForHasTheFacings) {
  const catalog::Catalog catalog = tins_of({"Anda"}, 30);
  const auto shelves = blocked(gondola_of(5), catalog, BlockPattern::brand_columns);
  std::map<std::uint32_t, int> facings;
  for (const PlannedShelf& shelf : shelves)
    for (const scene::PlannedBlock& block : shelf)
      facings[block.product] += block.facings;
  double more = 0, less = 0;
  int more_count = 0, less_count = 0;
  for (const auto& [row, count] : facings) {
    const bool wanted = scene::demand_of(catalog.products[row]) > 1;
    (wanted ? more : less) += count;
    ++(wanted ? more_count : less_count);
  }
  ASSERT_GT(more_count, 0);
  ASSERT_GT(less_count, 0);
  EXPECT_GT(more / more_count, less / less_count);
}

TEST(BrandBlocks, HeavyGoodsStandLow) {
  catalog::Catalog catalog = tins_of({"Anda"}, 20);
  for (std::size_t row = 0; row < catalog.products.size(); row += 2)
    catalog.products[row].mass_kg = 1.9;
  const auto shelves = blocked(gondola_of(5), catalog, BlockPattern::brand_columns);
  double heavy = 0, light = 0;
  int heavy_count = 0, light_count = 0;
  for (std::size_t level = 0; level < shelves.size(); ++level) {
    for (const scene::PlannedBlock& block : shelves[level]) {
      const bool is_heavy = catalog.products[block.product].mass_kg > 1;
      (is_heavy ? heavy : light) += static_cast<double>(level);
      ++(is_heavy ? heavy_count : light_count);
    }
  }
  ASSERT_GT(heavy_count, 0);
  ASSERT_GT(light_count, 0);
  EXPECT_LT(heavy / heavy_count, light / light_count - 1);
}

TEST(BrandBlocks, WhatIsCertainStandsOrTheBayIsStockedOtherwise) {
  catalog::Catalog catalog = tins_of({"Anda", "Bolo", "Cira"}, 20);
  const std::vector<std::uint32_t> certain{59, 3, 31};
  const auto shelves = blocked(gondola_of(4), catalog, BlockPattern::brand_columns, certain);
  std::set<std::uint32_t> stands;
  for (const PlannedShelf& shelf : shelves)
    for (const scene::PlannedBlock& block : shelf)
      if (block.certain) stands.insert(block.product);
  EXPECT_EQ(stands, (std::set<std::uint32_t>{3, 31, 59}));
}

TEST(BrandBlocks, OnlyWhereGoodsStandAndThePlanAsks) {
  plan::StockSpec stock;
  for (const BlockPattern plain : {BlockPattern::mixed, BlockPattern::brand_vertical}) {
    stock.block = plain;
    EXPECT_FALSE(scene::has_brand_blocks(gondola_of(3), stock));
  }
  stock.block = BlockPattern::brand_columns;
  EXPECT_TRUE(scene::has_brand_blocks(gondola_of(3), stock));
  scene::Bay offers = gondola_of(3), heaps = gondola_of(3);
  offers.promotion = true;
  heaps.shelves.back().use = assets::ShelfUse::heap;
  EXPECT_FALSE(scene::has_brand_blocks(offers, stock));
  EXPECT_FALSE(scene::has_brand_blocks(heaps, stock));
}

TEST(BrandBlocks, NothingToSellGivesEmptyShelves) {
  const auto shelves = blocked(gondola_of(3), catalog::Catalog{}, BlockPattern::brand_columns);
  ASSERT_EQ(shelves.size(), 3U);
  for (const PlannedShelf& shelf : shelves)
    EXPECT_TRUE(shelf.empty());
}

TEST(BrandOrder, LeaderFirstThenTheShopsOwn) {
  catalog::Catalog catalog = tins_of({"Anda", "Bolo", "Cira", "Own"}, 6);
  for (const char* category : {"dairy", "bakery"}) {  // the shop's own brand is in all categories
    catalog.products.push_back(stock_row(category, "food_tin", {75, 75, 110}, 0.4));
    catalog.products.back().brand = "Own";
    catalog.products.back().category = category;
  }
  std::vector<std::uint32_t> rows = all_rows(catalog);
  plan::StockSpec stock;
  scene::order_by_demand(rows, stock, catalog);
  EXPECT_EQ(rows, all_rows(catalog)) << "brand-vertical changes nothing";
  stock.block = BlockPattern::brand_columns;
  scene::order_by_demand(rows, stock, catalog);
  std::vector<std::string> brands;
  std::map<std::string, double> demand;
  for (const std::uint32_t row : rows) {
    const catalog::Product& product = catalog.products[row];
    if (product.category != "canned") continue;
    demand[product.brand] += scene::demand_of(product);
    if (brands.empty() || brands.back() != product.brand) brands.push_back(product.brand);
  }
  ASSERT_EQ(brands.size(), 4U) << "each brand stands together";
  EXPECT_EQ(brands[1], "Own");
  EXPECT_GE(demand[brands[0]], demand[brands[2]]);
  EXPECT_GE(demand[brands[2]], demand[brands[3]]);
}

TEST(BrandOrder, MixedGoesByDemandWhateverTheBrand) {
  const catalog::Catalog catalog = tins_of({"Anda", "Bolo", "Cira"}, 12);
  std::vector<std::uint32_t> rows = all_rows(catalog);
  plan::StockSpec stock;
  stock.block = BlockPattern::mixed;
  scene::order_by_demand(rows, stock, catalog);
  int changes = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const catalog::Product &before = catalog.products[rows[i - 1]],
                           &now = catalog.products[rows[i]];
    EXPECT_GE(scene::demand_of(before), scene::demand_of(now));
    changes += before.brand != now.brand ? 1 : 0;
  }
  EXPECT_GT(changes, 8);
  std::ranges::sort(rows);
  EXPECT_EQ(rows, all_rows(catalog));
}

// A whole shop of the committed catalogue: how much of a brand's width its boards have in common.
double shared_width(BlockPattern block) {
  HandLaidShop shop = shop_of({"beverages", "canned", "snacks", "household"});
  for (plan::Zone& zone : shop.plan.zones)
    zone.stock.block = block;
  const scene::Scene scene = scene_of(shop);
  double shared = 0, all = 0;
  for (const scene::BayRef& bay : scene::bays_of(scene)) {
    if (bay.bay.promotion || bay.bay.shelves.front().use != assets::ShelfUse::stand) continue;
    std::map<std::string, std::map<std::uint32_t, std::pair<double, double>>> extents;
    for (const scene::Facing& facing : scene.facings) {
      if (std::ranges::find(bay.shelves, facing.shelf) == bay.shelves.end()) continue;
      const catalog::Product& product = scene.catalog[facing.sku];
      const double left = facing.x_m, right = facing.x_m + facing.width_m;
      auto& extent = extents[product.subcategory + product.brand]
                         .try_emplace(facing.shelf, std::pair(left, right))
                         .first->second;
      extent = {std::min(extent.first, left), std::max(extent.second, right)};
    }
    for (const auto& [brand, boards] : extents) {
      if (boards.size() < 2) continue;
      double in_all_from = 0, in_all_to = 1e9, from = 1e9, to = 0;
      for (const auto& [board, extent] : boards) {
        in_all_from = std::max(in_all_from, extent.first);
        in_all_to = std::min(in_all_to, extent.second);
        from = std::min(from, extent.first);
        to = std::max(to, extent.second);
      }
      shared += std::max(0.0, in_all_to - in_all_from);
      all += to - from;
    }
  }
  return shared / all;
}

TEST(BrandBlocks, BrandsOfAWholeShopStandAboveOneAnother) {
  const double columns = shared_width(BlockPattern::brand_columns);
  const double plain = shared_width(BlockPattern::brand_vertical);
  EXPECT_GT(columns, 0.5);
  EXPECT_GT(columns, plain + 0.15);
}

}  // namespace
}  // namespace marketgen
