#include "layout/staff_floor.h"

#include <gtest/gtest.h>

#include "sample_shop.h"

namespace marketgen {
namespace {

layout::Fixture standing(std::string kind, int yaw_deg) {
  layout::Fixture fixture;
  fixture.id = "zone/" + kind;
  fixture.kind = std::move(kind);
  fixture.x_mm = 5000, fixture.y_mm = 4000, fixture.yaw_deg = yaw_deg;
  fixture.width_mm = 2000, fixture.depth_mm = 800;
  return fixture;
}

TEST(StaffFloor, LiesBehindCountersAndDesksAlone) {
  catalog::Catalog catalog = sample::catalog();
  catalog.fixture_kinds.push_back(sample::kind("serve_over", {1250}, 1100, 1250, 1));
  layout::Layout layout;
  layout.fixtures = {standing("serve_over", 0),  // faces south: staff stands north of it
                     standing("kiosk", 90),      // faces east: staff stands west of it
                     standing("gondola", 0),     // nobody stands behind shelves
                     standing("no-such-kind", 0)};
  const std::vector<layout::StaffFloor> floors = layout::staff_floor(layout, catalog);
  ASSERT_EQ(floors.size(), 2U);
  EXPECT_EQ(floors[0].of, "zone/serve_over");
  EXPECT_EQ(bounds_of(floors[0].polygon_mm), (RectMm{4000, 4400, 6000, 5400}));
  EXPECT_EQ(floors[1].of, "zone/kiosk");
  EXPECT_EQ(bounds_of(floors[1].polygon_mm), (RectMm{3800, 3000, 4600, 5000}));
}

TEST(StaffFloor, BackRoomsAreTheStaffs) {
  layout::Layout layout;
  const PolygonMm corner{{0, 0}, {3000, 0}, {3000, 2000}, {0, 2000}};
  layout.zones = {{"stock", "backroom", "", corner, 6}, {"shop", "snacks", "", corner, 6}};
  const std::vector<layout::StaffFloor> floors = layout::staff_floor(layout, sample::catalog());
  ASSERT_EQ(floors.size(), 1U);
  EXPECT_EQ(floors[0].of, "stock");
  EXPECT_EQ(floors[0].polygon_mm, corner);
}

}  // namespace
}  // namespace marketgen
