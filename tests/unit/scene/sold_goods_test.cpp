// Shelves as shoppers leave them: what is missing where, in single blocks and in whole shops.
#include "scene/sold_goods.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "hand_made_stock.h"
#include "scene_of.h"

namespace marketgen {
namespace {

const catalog::Catalog& cans() {
  static const catalog::Catalog catalog =
      catalog_of({stock_row("beans", "can", {75, 75, 110}, 0.4, 2)});
  return catalog;
}

// Four columns, each as deep as it happens to be.
scene::FilledBlock whole_block() {
  plan::StockSpec stock;
  stock.out_of_stock = 0;
  return scene::fill_shelf({{0, 4}}, shelf_room(), stock, cans(), Stream(1)).front();
}

scene::FilledBlock sold(scene::UnitsWanted wanted,
                        bool leaves_one = false,
                        std::uint64_t seed = 1) {
  scene::FilledBlock block = whole_block();
  take_sold(block, wanted, false, leaves_one, Stream(seed));
  return block;
}

using Place = std::tuple<double, double, double>;
std::set<Place> places(const scene::FilledBlock& block) {
  std::set<Place> all;
  for (const scene::ShelfItem& item : block.items)
    all.emplace(item.position.x, item.position.y, item.position.z);
  return all;
}

std::map<double, std::vector<scene::ShelfItem>> columns(const scene::FilledBlock& block) {
  std::map<double, std::vector<scene::ShelfItem>> by_x;
  for (const scene::ShelfItem& item : block.items)
    by_x[item.position.x].push_back(item);
  return by_x;
}

// No pack stands over a place from which one was taken.
void expect_nothing_floats(const scene::FilledBlock& block) {
  const std::set<Place> standing = places(block);
  for (const auto& [x, y, z] : standing) {
    EXPECT_TRUE(z < 0.05 || standing.contains({x, y, 0.0}));
  }
}

TEST(SoldGoods, GoInFrontAndTheShelfBehindRemains) {
  const scene::FilledBlock whole = whole_block();
  const int packs = static_cast<int>(whole.items.size());
  ASSERT_GE(packs, 16);
  EXPECT_EQ(whole.stack, 2);
  EXPECT_EQ(columns(whole).size(), 4U);
  for (int n = 0; n <= packs + 5; ++n) {
    const scene::FilledBlock block = sold({0, n});
    EXPECT_EQ(static_cast<int>(block.items.size()), std::max(0, packs - n));
    EXPECT_TRUE(std::ranges::includes(places(whole), places(block)));
    expect_nothing_floats(block);
    for (const auto& [x, items] : columns(block))
      EXPECT_EQ(items.back().position.y, columns(whole).at(x).back().position.y);
  }
}

TEST(SoldGoods, AreMissingAtTheBackWhereStaffPulledForward) {
  const scene::FilledBlock whole = whole_block();
  for (int n = 0; n < static_cast<int>(whole.items.size()); ++n) {
    const scene::FilledBlock block = sold({n, 0});
    EXPECT_TRUE(std::ranges::includes(places(whole), places(block)));
    expect_nothing_floats(block);
    for (const auto& [x, items] : columns(block))
      EXPECT_EQ(items.front().position.y, columns(whole).at(x).front().position.y);
  }
}

TEST(SoldGoods, TheFrontRowIsTheForemostThatIsLeft) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const auto& [x, items] : columns(sold({4, 9}, false, seed))) {
      for (const scene::ShelfItem& item : items)
        EXPECT_EQ(item.flags != 0, item.position.y == items.front().position.y);
    }
  }
}

TEST(SoldGoods, MoreSalesTakeMoreOfTheSame) {
  for (int n = 1; n < 30; ++n)
    EXPECT_TRUE(std::ranges::includes(places(sold({0, n - 1})), places(sold({0, n}))));
}

TEST(SoldGoods, WhatIsPromisedIsNeverSoldOut) {
  EXPECT_EQ(sold({0, 1000}, true).items.size(), 1U);
  EXPECT_EQ(sold({1000, 0}, true).items.size(), 1U);
  EXPECT_TRUE(sold({0, 1000}).items.empty());
}

// Pieces of loose goods go from the top: of each layer, only when all higher ones are gone.
TEST(SoldGoods, HeapsAreTakenFromTheTop) {
  const catalog::Catalog& catalog = committed_catalog();
  int heaps = 0;
  for (std::uint32_t row = 0; row < catalog.products.size() && heaps < 25; ++row) {
    if (!scene::lies_in_a_heap(catalog.products[row])) continue;
    ++heaps;
    plan::StockSpec stock;
    stock.out_of_stock = 0;
    const scene::ShelfRoom room{1.2, 0.5, 0.35, assets::ShelfUse::heap};
    scene::FilledBlock block =
        scene::fill_shelf({{row, 6}}, room, stock, catalog, Stream(row)).front();
    const std::size_t full = block.items.size();
    int highest = 0;
    for (const scene::ShelfItem& item : block.items)
      highest = std::max(highest, item.layer);
    std::map<int, std::size_t> of_layer;
    for (const scene::ShelfItem& item : block.items)
      ++of_layer[item.layer];
    take_sold(block, {0, static_cast<int>(full / 3)}, true, false, Stream(2));
    EXPECT_EQ(block.items.size(), full - full / 3);
    int top = 0;
    for (const scene::ShelfItem& item : block.items)
      top = std::max(top, item.layer);
    for (const scene::ShelfItem& item : block.items)
      if (item.layer < top) --of_layer[item.layer];
    for (int layer = 0; layer < top; ++layer)
      EXPECT_EQ(of_layer[layer], 0U) << catalog.products[row].sku << " layer " << layer;
  }
  EXPECT_EQ(heaps, 25);
}

HandLaidShop shop_at(const std::optional<std::string>& time,
                     const std::string& profile = "supermarket-eu") {
  HandLaidShop shop = shop_of(selling_types());
  shop.plan.profile = profile;
  shop.plan.time = time;
  return shop;
}

// Blocks of which something is gone in front or altogether, over all.
double share_with_gaps(const scene::Scene& full, const scene::Scene& shop) {
  double gaps = 0, blocks = 0;
  for (std::size_t f = 0; f < shop.facings.size(); ++f) {
    if (full.facings[f].product_count == 0) continue;
    ++blocks;
    gaps += shop.facings[f].product_count < 0.7 * full.facings[f].product_count ? 1 : 0;
  }
  return gaps / blocks;
}

TEST(StoreTime, BeforeOpeningNothingIsSold) {
  const std::string plain = scene::scene_hash(scene_of(shop_of(selling_types())));
  EXPECT_EQ(scene::scene_hash(scene_of(shop_at("Mon 06:00"))), plain);  // all shelves were filled
  EXPECT_NE(scene::scene_hash(scene_of(shop_at("Mon 18:00"))), plain);
}

TEST(StoreTime, TheSameIsTheSameStore) {
  EXPECT_EQ(scene::scene_hash(scene_of(shop_at("Sat 17:30"))),
            scene::scene_hash(scene_of(shop_at("saturday 17:30"))));
  EXPECT_NE(scene::scene_hash(scene_of(shop_at("Sat 17:30"), 1)),
            scene::scene_hash(scene_of(shop_at("Sat 17:30"), 2)));
}

// Which product stands where, and its tag, are of the plan and the seed; the hour only takes away.
TEST(StoreTime, OnlyRemovesGoods) {
  for (const char* profile : {"supermarket-eu", "discounter", "convenience-us", "kiosk"}) {
    const scene::Scene full = scene_of(shop_at(std::nullopt, profile));
    const scene::Scene evening = scene_of(shop_at("Sat 18:00", profile));
    ASSERT_EQ(evening.facings.size(), full.facings.size());
    ASSERT_EQ(evening.price_labels.size(), full.price_labels.size());
    const auto sku = [](const scene::Scene& s, std::uint32_t row) { return s.catalog[row].sku; };
    for (std::size_t f = 0; f < full.facings.size(); ++f) {
      const scene::Facing &before = full.facings[f], &after = evening.facings[f];
      EXPECT_EQ(sku(evening, after.sku), sku(full, before.sku));
      EXPECT_EQ(
          std::tie(after.shelf, after.x_m, after.width_m, after.facings, after.rows_deep),
          std::tie(before.shelf, before.x_m, before.width_m, before.facings, before.rows_deep));
      EXPECT_LE(after.product_count, before.product_count);
      std::set<std::array<float, 3>> stood;
      for (std::uint32_t i = 0; i < before.product_count; ++i)
        stood.insert(full.products[before.first_product + i].position_m);
      for (std::uint32_t i = 0; i < after.product_count; ++i) {
        const scene::SceneProduct& item = evening.products[after.first_product + i];
        const bool moved = (item.flags & scene::product_out_of_line) != 0;
        EXPECT_TRUE(moved || stood.contains(item.position_m));
      }
    }
    for (std::size_t i = 0; i < full.price_labels.size(); ++i)
      EXPECT_EQ(evening.price_labels[i].price_cents, full.price_labels[i].price_cents);
    EXPECT_LT(evening.products.size(), full.products.size()) << profile;
  }
}

TEST(StoreTime, GapsRiseWithTheHour) {
  const scene::Scene full = scene_of(shop_at(std::nullopt));
  double before = -1;
  for (const char* time : {"Sat 08:00", "Sat 10:00", "Sat 12:30", "Sat 20:00"}) {
    const double gaps = share_with_gaps(full, scene_of(shop_at(time)));
    EXPECT_GT(gaps, before) << time;
    before = gaps;
  }
  EXPECT_LT(share_with_gaps(full, scene_of(shop_at("Mon 08:00"))), 0.02);
  EXPECT_GT(share_with_gaps(full, scene_of(shop_at("Sat 18:00"))), 0.1);
}

double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto ranks = [](const std::vector<double>& values) {
    std::vector<double> sorted = values;
    std::ranges::sort(sorted);
    std::vector<double> places_of;
    for (const double value : values) {  // ties share the mean of their ranks
      const auto [low, high] = std::ranges::equal_range(sorted, value);
      places_of.push_back(static_cast<double>((low - sorted.begin()) + (high - sorted.begin())) /
                          2);
    }
    return places_of;
  };
  const std::vector<double> x = ranks(a), y = ranks(b);
  const double mean = static_cast<double>(x.size()) / 2;
  double xy = 0, xx = 0, yy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - mean) * (y[i] - mean);
    xx += (x[i] - mean) * (x[i] - mean), yy += (y[i] - mean) * (y[i] - mean);
  }
  return xy / std::sqrt(xx * yy);
}

TEST(StoreTime, GapsComeByTurnover) {
  HandLaidShop shop = shop_at("Sat 18:00");
  const scene::Scene full = scene_of(shop_at(std::nullopt)), evening = scene_of(shop);
  const auto time = plan::parse_store_time(*shop.plan.time, "plan.bad_value", "/time");
  ASSERT_TRUE(time.ok());
  const scene::StoreSales sales(shop.plan, *time, committed_catalog());
  std::vector<double> turnover, missing;
  for (std::size_t f = 0; f < full.facings.size(); ++f) {
    const double held = full.facings[f].product_count;
    const catalog::Product& product = full.catalog[full.facings[f].sku];
    if (held == 0) continue;
    turnover.push_back(sales.weekly_units(product, static_cast<int>(held)) / held);
    missing.push_back(1 - evening.facings[f].product_count / held);
  }
  ASSERT_GT(turnover.size(), 300U);
  EXPECT_GT(rank_correlation(turnover, missing), 0.5);
}

TEST(StoreTime, ABadOneIsAnError) {
  const HandLaidShop shop = shop_at("Sat 25:00");
  const auto built = scene::build_scene(shop.layout, shop.plan, committed_catalog(), Seed(1));
  ASSERT_FALSE(built.ok());
  EXPECT_EQ(built.error().code, "plan.bad_value");
  EXPECT_EQ(built.error().where, "plan:/time");
}

}  // namespace
}  // namespace marketgen
