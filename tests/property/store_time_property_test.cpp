// Shops of every kind by chance, over a Saturday: goods go, nothing else changes, and what is left
// stands as firmly as before.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "audit/audit.h"
#include "layout/layout.h"
#include "physics/settle/settle.h"
#include "scene/scene.h"
#include "support/hand_laid_shop.h"
#include "support/number_of_cases.h"
#include "support/random_plan.h"

namespace marketgen {
namespace {

constexpr std::array times{"Sat 06:00", "Sat 11:00", "Sat 12:30"};  // nothing is filled in between

struct Shop {
  plan::Plan plan;
  layout::Layout layout;
};

std::optional<Shop> random_shop(std::size_t number) {
  Shop shop{RandomPlan(number).make(), {}};
  if (shop.plan.shell.width_mm > 30'000 || shop.plan.shell.depth_mm > 30'000) return std::nullopt;
  auto layout = layout::make_layout(shop.plan, committed_catalog(), Seed(number));
  if (!layout.ok()) return std::nullopt;
  shop.layout = std::move(layout).value();
  return shop;
}

scene::Scene scene_at(const Shop& shop, const std::string& time) {
  plan::Plan plan = shop.plan;
  plan.time = time;
  auto scene = scene::build_scene(shop.layout, plan, committed_catalog(), Seed(5));
  if (!scene.ok()) fatal(to_string(scene.error()).c_str());
  return std::move(scene).value();
}

// Which product stands where, in how many facings, and what its tag says.
auto planogram_of(const scene::Scene& scene) {
  std::vector<std::tuple<std::uint32_t, std::string, float, float, int, int, int>> rows;
  for (const scene::Facing& f : scene.facings)
    rows.emplace_back(
        f.shelf, scene.catalog[f.sku].sku, f.x_m, f.width_m, f.facings, f.rows_deep, f.stack);
  std::vector<std::tuple<float, std::string, std::uint32_t, std::uint32_t>> tags;
  for (const scene::PriceLabel& l : scene.price_labels)
    tags.emplace_back(l.x_m, scene.catalog[l.sku].sku, l.price_cents, l.promotion);
  return std::pair(rows, tags);
}

// Columns of packs, by the whole millimetre along their shelf: how many there are in each.
std::map<std::pair<std::uint32_t, long>, int> units_of(const scene::Scene& scene) {
  std::map<std::pair<std::uint32_t, long>, int> units;
  for (const scene::SceneProduct& item : scene.products) {
    const scene::Facing& facing = scene.facings[item.facing];
    const Vec3 on_shelf = inverse(scene::world_from_shelf(scene, facing.shelf)) *
                          scene::world_from_product(item).position;
    ++units[{item.facing, std::lround(on_shelf.x * 1000)}];
  }
  return units;
}

void expect_clean(const scene::Scene& scene, const scene::Scene& full) {
  const auto now = audit::audit_store(scene, committed_catalog(), {});
  const auto before = audit::audit_store(full, committed_catalog(), {});
  ASSERT_TRUE(now.ok() && before.ok());
  EXPECT_EQ(now->metrics.OOB, 0U);
  EXPECT_LE(now->metrics.COL, before->metrics.COL + 1e-9);
}

TEST(StoreTimeProperty, AHourTakesGoodsAwayAndChangesNothingElse) {
  const std::size_t shops = number_of_cases("MARKETGEN_PROPERTY_SCENES", 12);
  std::size_t made = 0, sold = 0;
  for (std::size_t i = 0; made < shops && i < 20 * shops; ++i) {
    const std::optional<Shop> shop = random_shop(i);
    if (!shop) continue;
    ++made;
    SCOPED_TRACE("plan " + std::to_string(i) + ", " + shop->plan.profile);
    const scene::Scene full = scene_at(*shop, times[0]);
    const auto planogram = planogram_of(full);
    auto before = units_of(full);
    for (std::size_t k = 1; k < times.size(); ++k) {
      const scene::Scene now = scene_at(*shop, times[k]);
      EXPECT_TRUE(planogram_of(now) == planogram);
      const auto units = units_of(now);
      for (const auto& [column, count] : units)
        EXPECT_LE(count, before.contains(column) ? before.at(column) : 0);
      sold += now.products.size() < full.products.size() ? 1 : 0;
      expect_clean(now, full);
      before = units;
    }
  }
  EXPECT_EQ(made, shops);
  EXPECT_GT(sold, shops);
}

// Wherever shoppers came by, the untidiest: nothing stands in another thing or reaches out.
TEST(StoreTimeProperty, WhatShoppersLeftOutOfLineHasRoom) {
  HandLaidShop shop = shop_of(selling_types());
  for (plan::Zone& zone : shop.plan.zones)
    zone.stock.jitter = 1;
  const scene::Scene full = scene_at({shop.plan, shop.layout}, times[0]);
  const scene::Scene evening = scene_at({shop.plan, shop.layout}, "Sat 18:00");
  const auto moved = std::ranges::count_if(evening.products, [](const scene::SceneProduct& item) {
    return (item.flags & scene::product_out_of_line) != 0;
  });
  EXPECT_GT(moved, 100);
  expect_clean(evening, full);
}

// What lies on something that is gone would fall, and what leans could: goods are let go, and stay.
TEST(SlowStoreTimeProperty, WhatIsLeftStandsWhenLetGo) {
  physics::SettleOptions options;
  options.region_m = {0, 0, 60, 10};
  options.max_products = 100;
  options.settle_s = 0.5, options.watch_s = 0.5;
  for (const char* type : {"produce", "canned", "dairy", "snacks"}) {
    SCOPED_TRACE(type);
    HandLaidShop shop = shop_of({type});
    shop.plan.zones.front().stock.jitter = 1;
    const scene::Scene full = scene_at({shop.plan, shop.layout}, times[0]);
    const scene::Scene evening = scene_at({shop.plan, shop.layout}, "Sat 18:00");
    ASSERT_LT(evening.products.size(), full.products.size());
    const auto before = physics::settle(full, options), after = physics::settle(evening, options);
    ASSERT_TRUE(before.ok() && after.ok());
    EXPECT_LT(after->median_drift_m, 0.005);
    EXPECT_GE(after->share_below_5_cm, before->share_below_5_cm - 0.02);
  }
}

}  // namespace
}  // namespace marketgen
