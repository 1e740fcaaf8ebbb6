// What products earn, and how many packs of them a shelf takes.
#include "scene/shelf_worth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "hand_made_stock.h"
#include "scene/demand.h"
#include "scene/sales.h"
#include "scene/shelf_fill.h"
#include "scene_of.h"

namespace marketgen {
namespace {

TEST(Margins, EveryCategoryHasOne) {
  std::set<std::string_view> known;
  for (const scene::Margin& row : scene::margins()) {
    EXPECT_TRUE(known.insert(row.category).second) << row.category;
    EXPECT_GT(row.share, 0.1);
    EXPECT_LT(row.share, 0.6);
  }
  for (const scene::SalesRate& rate : scene::sales_rates())
    EXPECT_TRUE(known.contains(rate.category)) << rate.category;
}

TEST(Margins, AreOfCategoryAndBrand) {
  catalog::Product tin = stock_row("a", "food_tin", {75, 75, 110}, 0.4), bread = tin, other = tin;
  bread.category = "bakery";
  other.brand = "Anda";
  EXPECT_NEAR(scene::margin_of(bread, "") / scene::margin_of(tin, ""), 0.45 / 0.27, 1e-12);
  EXPECT_NE(scene::margin_of(other, ""), scene::margin_of(tin, ""));
  EXPECT_NEAR(scene::margin_of(tin, "Fonda"), 0.27 * 1.3, 1e-12);  // the shop's own
  EXPECT_GT(scene::margin_of(tin, "Fonda"), scene::margin_of(tin, "Anda"));
  tin.sku = "b";
  EXPECT_EQ(scene::margin_of(tin, ""),
            scene::margin_of(stock_row("a", "can", {60, 60, 100}, 1), ""));
}

TEST(Cases, AreWhatOnePersonLifts) {
  EXPECT_EQ(scene::case_packs(stock_row("tin", "food_tin", {75, 75, 110}, 0.45)), 24);
  EXPECT_EQ(scene::case_packs(stock_row("milk", "brick_carton", {75, 95, 200}, 1.05)), 12);
  EXPECT_EQ(scene::case_packs(stock_row("water", "water_bottle", {90, 90, 320}, 2.05)), 6);
  EXPECT_EQ(scene::case_packs(stock_row("cereals", "box", {190, 70, 290}, 0.5)), 10);
  EXPECT_EQ(scene::case_packs(stock_row("paper", "soft_pack", {400, 300, 450}, 1.5)), 1);
}

TEST(LeastPacks, AreACaseOrWhatIsSoldBetweenFillings) {
  catalog::Product tin = stock_row("tin", "food_tin", {75, 75, 110}, 0.45);
  EXPECT_EQ(scene::min_packs(tin, 0), 24);
  double demand = 0;
  for (int i = 0; i < 500 && demand < 8; ++i) {  // one that many ask for
    tin.sku = "tin-" + std::to_string(i);
    demand = scene::demand_of(tin);
  }
  ASSERT_GE(demand, 8);
  // Tins last 40 days on the mean and are filled every third day at most.
  EXPECT_EQ(scene::min_packs(tin, 100), static_cast<int>(std::ceil(2 * 3 * 100 / 40.0 * demand)));
}

struct Room {
  double with_a_case = 0, blocks = 0;
};

// Of the blocks of shelves on which goods stand, those that take a whole case.
Room room_in(plan::BlockPattern block) {
  HandLaidShop shop = shop_of({"beverages", "canned", "snacks", "household"});
  for (plan::Zone& zone : shop.plan.zones)
    zone.stock.block = block;
  const scene::Scene scene = scene_of(shop);
  std::map<std::uint32_t, std::pair<int, int>> packs;  // by SKU: what shelves take, a case
  for (const scene::Facing& facing : scene.facings) {
    const layout::Fixture& fixture = scene.layout.fixtures[scene.shelves[facing.shelf].fixture];
    if (fixture.kind != "gondola" || !fixture.endcap_of.empty()) continue;
    auto& [held, of_case] = packs[facing.sku];
    held += facing.facings * facing.rows_deep * facing.stack;
    of_case = scene::case_packs(*committed_catalog().product(scene.catalog[facing.sku].sku));
  }
  Room room;
  for (const auto& [sku, has] : packs) {
    room.with_a_case += has.first >= has.second ? 1 : 0;
    ++room.blocks;
  }
  return room;
}

TEST(LeastPacks, HaveRoomInColumnsOfBrands) {
  const Room columns = room_in(plan::BlockPattern::brand_columns),
             plain = room_in(plan::BlockPattern::brand_vertical);
  ASSERT_GT(columns.blocks, 100);
  const double share = columns.with_a_case / columns.blocks;
  EXPECT_GT(share, 0.75);
  EXPECT_GT(share, plain.with_a_case / plain.blocks);
}

}  // namespace
}  // namespace marketgen
