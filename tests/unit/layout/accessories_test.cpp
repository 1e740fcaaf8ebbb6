#include "layout/accessories.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "layout/empty_floor.h"
#include "layout/floor_guard.h"
#include "sample_shop.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

// 16 x 14 m of the committed kinds: tills in front, gondolas behind them.
plan::Plan shop() {
  plan::Plan plan = sample::small_shop();
  plan.profile = "supermarket-eu";
  plan.look.fixture = "metal-white";
  return plan;
}

std::vector<layout::Fixture> accessories_in(const layout::Layout& layout) {
  std::vector<layout::Fixture> found = layout.fixtures;
  std::erase_if(found,
                [](const layout::Fixture& f) { return f.run.find("/with/") == std::string::npos; });
  return found;
}

TEST(Accessories, NothingElseMovesForThem) {
  catalog::Catalog bare = committed_catalog();  // without the kinds that only accessories have
  std::erase_if(bare.fixture_kinds, [](const catalog::FixtureKind& kind) {
    return std::ranges::any_of(layout::accessory_rows(), [&](const layout::AccessoryRow& row) {
      return std::ranges::find(row.kinds, std::string_view(kind.kind)) != row.kinds.end();
    });
  });
  const auto with = layout::make_layout(shop(), committed_catalog(), Seed(3));
  const auto without = layout::make_layout(shop(), bare, Seed(3));
  ASSERT_TRUE(with.ok() && without.ok());
  EXPECT_FALSE(accessories_in(*with).empty());
  EXPECT_TRUE(accessories_in(*without).empty());
  for (const layout::Fixture& fixture : without->fixtures) {
    const layout::Fixture* same = layout::find_fixture(*with, fixture.id);
    ASSERT_NE(same, nullptr) << fixture.id;
    EXPECT_EQ(layout::footprint_of(*same), layout::footprint_of(fixture)) << fixture.id;
  }
  EXPECT_EQ(with->fixtures.size(), without->fixtures.size() + accessories_in(*with).size());
  EXPECT_EQ(with->violations.size(), without->violations.size());
}

TEST(Accessories, AntennasLeaveTheWayOutFree) {
  const auto made = layout::make_layout(shop(), committed_catalog(), Seed(1));
  ASSERT_TRUE(made.ok());
  std::vector<RectMm> pair;
  for (const layout::Fixture& fixture : made->fixtures) {
    if (fixture.kind == "antenna-gate-black") pair.push_back(layout::footprint_of(fixture));
  }
  ASSERT_EQ(pair.size(), 2U);
  EXPECT_GE(std::abs(gap_mm(pair[0], pair[1])), 915);  // ADA 2010 403.5.1
}

TEST(Accessories, ACountThatThePlanSaysHolds) {
  plan::Plan plan = shop();
  plan.equipment = {{"antenna-gate-black", 0, std::nullopt}};
  const auto made = layout::make_layout(plan, committed_catalog(), Seed(1));
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(std::ranges::count(made->fixtures, "antenna-gate-black", &layout::Fixture::kind), 0);
}

// A room of 10 x 4 m with a door in the south wall's west half.
layout::Design hall(const plan::Plan& plan, const catalog::Catalog& catalog) {
  return layout::make_design(plan, catalog);
}

layout::Fixture block(int x, int y, int width, int depth) {
  return sample::fixture("hall/with/block-1/module-1", "kiosk", "hall", x, y, 0, width, depth);
}

TEST(FloorGuard, RefusesWhatCutsTheFloorInTwo) {
  const catalog::Catalog catalog = sample::catalog();
  plan::Plan plan = sample::one_zone(10000, 4000, sample::zone("hall", "dry_goods", "gondola"));
  plan.shell.openings.front().center = 0.15;
  const layout::Design design = hall(plan, catalog);
  const layout::FloorGuard guard(design, {});
  EXPECT_TRUE(guard.allows(block(6000, 3600, 1000, 600)));   // 3.1 m are left before it
  EXPECT_FALSE(guard.allows(block(6000, 2400, 600, 3000)));  // 0.9 m south of it, 0.1 m north
}

TEST(EmptyFloor, TheLargestDiscLiesInTheMiddleOfWhatIsFree) {
  const catalog::Catalog catalog = sample::catalog();
  const plan::Plan plan =
      sample::one_zone(10000, 4000, sample::zone("hall", "dry_goods", "gondola"));
  const layout::Design design = hall(plan, catalog);
  layout::EmptyFloor empty(design.floor, {});
  const auto disc = empty.largest_in({0, 0, 10000, 4000});
  ASSERT_TRUE(disc.has_value());
  EXPECT_NEAR(disc->center[1], 2000, 200);
  EXPECT_NEAR(disc->radius_mm, 2000, 200);
  empty.add({4000, 0, 10000, 4000});  // the east is taken
  const auto rest = empty.largest_in({0, 0, 10000, 4000});
  ASSERT_TRUE(rest.has_value());
  EXPECT_NEAR(rest->center[0], 2000, 250);
}

}  // namespace
}  // namespace marketgen
