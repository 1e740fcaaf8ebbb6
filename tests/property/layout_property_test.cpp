// 200 random plans: whatever the division of the floor, nothing overlaps, nothing stands outside or
// in a doorway, and the same plan gives the same layout twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/seed.h"
#include "catalog/catalog.h"
#include "io/json.h"
#include "layout/floor.h"
#include "layout/layout.h"
#include "layout/reach.h"
#include "support/committed_catalog.h"
#include "support/random_plan.h"

namespace marketgen {
namespace {

// What a wall carries hangs over what stands before it: a mirror over shelves.
bool hangs_over(const layout::Fixture& upper, const layout::Fixture& lower) {
  return committed_catalog().fixture_kind(upper.kind)->mount == catalog::FixtureMount::wall &&
         upper.base_mm >= lower.height_mm;
}

void expect_sound(const layout::Layout& layout, const plan::Plan& plan, std::uint64_t seed) {
  const layout::Floor floor = layout::make_floor(plan.shell);
  std::vector<RectMm> rects;
  for (const layout::Fixture& fixture : layout.fixtures) {
    rects.push_back(layout::footprint_of(fixture));
    EXPECT_TRUE(layout::on_floor(floor, rects.back()))
        << "seed " << seed << ": " << fixture.id << " is outside";
    for (const layout::Doorway& door : floor.doorways) {
      EXPECT_FALSE(overlap(rects.back(), door.approach))
          << "seed " << seed << ": " << fixture.id << " blocks a door";
    }
    for (const RectMm& column : floor.columns) {
      EXPECT_FALSE(overlap(rects.back(), column))
          << "seed " << seed << ": " << fixture.id << " stands in a column";
    }
  }
  for (std::size_t i = 0; i < rects.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const bool apart = hangs_over(layout.fixtures[i], layout.fixtures[k]) ||
                         hangs_over(layout.fixtures[k], layout.fixtures[i]);
      EXPECT_FALSE(!apart && overlap(rects[i], rects[k]))
          << "seed " << seed << ": " << layout.fixtures[i].id << " and " << layout.fixtures[k].id
          << " overlap";
    }
  }
}

void expect_sorted_ids(const layout::Layout& layout, std::uint64_t seed) {
  for (std::size_t i = 1; i < layout.fixtures.size(); ++i) {
    EXPECT_LT(layout.fixtures[i - 1].id, layout.fixtures[i].id) << "seed " << seed;
  }
  for (std::size_t i = 1; i < layout.aisles.size(); ++i) {
    EXPECT_LT(layout.aisles[i - 1].id, layout.aisles[i].id) << "seed " << seed;
  }
}

// Rules that layouts keep by construction, however odd the plan. The others may need repair_plan.
bool kept_by_construction(const std::string& code) {
  const std::vector<std::string> kept{"AISLE_TOO_NARROW",
                                      "EXIT_BLOCKED",
                                      "DOOR_SWING_BLOCKED",
                                      "FIXTURE_OUTSIDE",
                                      "FIXTURE_OVERLAP",
                                      "WHEELCHAIR_ROUTE",
                                      "ZONE_UNREACHABLE",
                                      "LANE_TOO_NARROW"};
  return std::ranges::find(kept, code) != kept.end();
}

TEST(LayoutProperty, RandomPlansGiveSoundLayouts) {
  constexpr int plans = 200;
  int laid_out = 0;
  for (std::uint64_t seed = 0; seed < plans; ++seed) {
    const plan::Plan plan = RandomPlan(seed).make();
    const Result<void> valid = plan::validate_plan(plan, "random plan", committed_catalog());
    ASSERT_TRUE(valid.ok()) << "seed " << seed << ": " << to_string(valid.error());
    const Result<layout::Layout> layout =
        layout::make_layout(plan, committed_catalog(), Seed(seed));
    if (!layout.ok()) {
      EXPECT_EQ(layout.error().code, "layout.impossible") << seed;
      continue;
    }
    ++laid_out;
    expect_sound(*layout, plan, seed);
    expect_sorted_ids(*layout, seed);
    for (const layout::Violation& v : layout->violations) {
      EXPECT_FALSE(kept_by_construction(v.code))
          << "seed " << seed << ": " << v.code << " " << v.where << ": " << v.message;
    }
  }
  EXPECT_GE(laid_out, 95 * plans / 100) << "an impossible plan is the exception: none was, of 200";
}

TEST(LayoutProperty, TheSamePlanGivesTheSameLayout) {
  int laid_out = 0;
  for (std::uint64_t seed = 0; seed < 15; ++seed) {
    const plan::Plan plan = RandomPlan(seed).make();
    const Result<layout::Layout> a = layout::make_layout(plan, committed_catalog(), Seed(seed));
    const Result<layout::Layout> b = layout::make_layout(plan, committed_catalog(), Seed(seed));
    ASSERT_EQ(a.ok(), b.ok());
    if (!a.ok()) continue;
    ++laid_out;
    EXPECT_EQ(io::write_json(*a), io::write_json(*b)) << "seed " << seed;
  }
  EXPECT_GE(laid_out, 14);
}

TEST(LayoutProperty, FreeFloorHangsTogether) {
  int laid_out = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const plan::Plan plan = RandomPlan(seed).make();
    const Result<layout::Layout> layout =
        layout::make_layout(plan, committed_catalog(), Seed(seed));
    if (!layout.ok()) continue;
    ++laid_out;
    const layout::Reach reach = layout::reach_of(
        layout::make_floor(plan.shell), plan.shell, layout->fixtures, layout::robot_width_mm);
    int cut_off = 0;
    for (std::size_t label = 1; label < reach.components.cells.size(); ++label) {
      if (static_cast<int>(label) != reach.from_entrance) cut_off += reach.components.cells[label];
    }
    EXPECT_LE(cut_off, 16) << "seed " << seed;  // 0.04 m2: rounding of the grid
  }
  EXPECT_GE(laid_out, 38);
}

}  // namespace
}  // namespace marketgen
