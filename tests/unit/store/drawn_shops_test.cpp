// Shops in rooms that were drawn, of any shape and with columns: planned without breaking a hard
// rule.
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "store/design.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

struct Room {
  const char* name;
  PolygonMm outline;
};

const std::vector<Room> rooms = {
    {"L", {{0, 0}, {30000, 0}, {30000, 11000}, {17000, 11000}, {17000, 20000}, {0, 20000}}},
    {"T",
     {{0, 0},
      {30000, 0},
      {30000, 10000},
      {22000, 10000},
      {22000, 20000},
      {8000, 20000},
      {8000, 10000},
      {0, 10000}}},
    {"U",
     {{0, 0},
      {30000, 0},
      {30000, 20000},
      {20000, 20000},
      {20000, 12000},
      {10000, 12000},
      {10000, 20000},
      {0, 20000}}},
    {"chamfered", {{0, 0}, {30000, 0}, {30000, 15000}, {25000, 20000}, {0, 20000}}},
    {"trapezoid", {{0, 0}, {30000, 0}, {26000, 20000}, {4000, 20000}}},
    {"small L", {{0, 0}, {14000, 0}, {14000, 6000}, {8000, 6000}, {8000, 12000}, {0, 12000}}},
};

intake::Brief brief_of(const Room& room, double entrance) {
  intake::Brief brief;
  brief.prompt = "a supermarket with dairy at the back";
  brief.floor_plan = std::string(room.name) + ".dxf";
  plan::Shell shell;
  const RectMm box = bounds_of(room.outline);
  shell.width_mm = box.x1;
  shell.depth_mm = box.y1;
  shell.outline_mm = room.outline;
  shell.openings = {{"entrance", plan::OpeningKind::entrance, plan::Wall::south, entrance, 2000}};
  constexpr int grid_mm = 6000, half_mm = 900;
  for (int x = grid_mm; x < box.x1; x += grid_mm) {
    for (int y = grid_mm; y < box.y1; y += grid_mm) {
      const auto on_floor = [&](int dx, int dy) {
        return contains(room.outline, PointMm{x + dx, y + dy});
      };
      if (on_floor(-half_mm, -half_mm) && on_floor(half_mm, half_mm) &&
          on_floor(half_mm, -half_mm) && on_floor(-half_mm, half_mm))
        shell.columns.push_back({x, y, 400});
    }
  }
  brief.shell = shell;
  return brief;
}

TEST(DrawnShops, KeepTheHardRulesInRoomsOfAnyShape) {
  for (const Room& room : rooms) {
    for (const double entrance : {0.2, 0.5, 0.8}) {
      const auto designed =
          store::design_store(brief_of(room, entrance), committed_catalog(), Seed(1));
      ASSERT_TRUE(designed.ok()) << room.name << ": " << to_string(designed.error());
      std::string faults;
      for (const layout::Violation& v : designed->layout.violations)
        if (v.severity == layout::Severity::hard) faults += "\n  " + v.code + ": " + v.message;
      EXPECT_EQ(faults, "") << room.name << ", entrance at " << entrance;
      fmt::print("{} {}: {} zones, {} fixtures, {:.2f} of the floor a fixture, {} soft\n",
                 room.name,
                 entrance,
                 designed->repaired.plan.zones.size(),
                 designed->layout.fixtures.size(),
                 static_cast<double>(designed->layout.fixtures.size()) / area_m2(room.outline),
                 designed->layout.violations.size());
      EXPECT_GE(static_cast<double>(designed->layout.fixtures.size()), area_m2(room.outline) / 12)
          << room.name;
    }
  }
}

}  // namespace
}  // namespace marketgen
