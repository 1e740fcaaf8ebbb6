#include "layout/layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "io/json.h"
#include "layout/reach.h"
#include "sample_shop.h"

namespace marketgen {
namespace {

layout::Layout lay_out(const plan::Plan& plan) {
  const catalog::Catalog catalog = sample::catalog();
  Result<layout::Layout> layout = layout::make_layout(plan, catalog, Seed(1));
  EXPECT_TRUE(layout.ok()) << (layout.ok() ? "" : to_string(layout.error()));
  return layout.ok() ? *layout : layout::Layout{};
}

std::vector<layout::Fixture> of_kind(const layout::Layout& layout, std::string_view kind) {
  std::vector<layout::Fixture> found;
  std::ranges::copy_if(layout.fixtures, std::back_inserter(found), [&](const layout::Fixture& f) {
    return f.kind == kind;
  });
  return found;
}

TEST(Layout, FootprintSwapsWidthAndDepthWhenTurned) {
  layout::Fixture f = sample::fixture("z/run-1/module-1", "gondola", "z", 5000, 3000, 0, 1000, 400);
  EXPECT_EQ(layout::footprint_of(f), (RectMm{4500, 2800, 5500, 3200}));
  f.yaw_deg = 90;
  EXPECT_EQ(layout::footprint_of(f), (RectMm{4800, 2500, 5200, 3500}));
}

// 12 x 8 m of dairy, multidecks 1250 wide and 1000 deep, aisles of 2.8 m.
TEST(Layout, CabinetsLineTheNorthWallWithTheirFrontsToTheSouth) {
  const layout::Layout layout =
      lay_out(sample::one_zone(12000, 8000, sample::zone("dairy", "dairy", "multideck")));
  int on_north_wall = 0;
  for (const layout::Fixture& f : of_kind(layout, "multideck")) {
    if (f.yaw_deg != 0 || layout::footprint_of(f).y1 != 7980) continue;  // 20 mm off the wall
    ++on_north_wall;
    EXPECT_EQ(f.y_mm, 7980 - 500);
  }
  EXPECT_EQ(on_north_wall, 9);  // 12,000 / 1,250
}

TEST(Layout, ModulesAreNumberedFromTheLeft) {
  const layout::Layout layout =
      lay_out(sample::one_zone(12000, 8000, sample::zone("dairy", "dairy", "multideck")));
  const layout::Fixture* first = layout::find_fixture(layout, "dairy/run-1/module-1");
  const layout::Fixture* second = layout::find_fixture(layout, "dairy/run-1/module-2");
  ASSERT_NE(first, nullptr);
  ASSERT_NE(second, nullptr);
  EXPECT_EQ(first->yaw_deg, 0);
  EXPECT_EQ(second->x_mm - first->x_mm, 1250);
  EXPECT_TRUE(first->run_start);
  EXPECT_FALSE(first->run_end);
  EXPECT_FALSE(second->run_start);
}

// 16 x 14 m: front 4,640 mm, gap 2,400, back from 7,040 to 14,000.
TEST(Layout, GondolasStandAcrossTheTillsAndWallUnitsRoundThem) {
  const layout::Layout layout = lay_out(sample::small_shop());
  for (const layout::Fixture& f : of_kind(layout, "gondola")) {
    EXPECT_EQ(f.yaw_deg, 90) << f.id;
    EXPECT_EQ(f.sides, 2);
  }
  // The goods' floor is 16 m wide; wall units of 500, 20 mm off the wall on both sides, and aisles
  // of 1,800 leave 11,360 mm: five runs of 1,000 stand 1,590 apart, which is within the 15 % that
  // aisles may give up.
  std::set<int> columns;
  for (const layout::Fixture& f : of_kind(layout, "gondola"))
    columns.insert(f.x_mm);
  EXPECT_EQ(columns.size(), 5U);
  EXPECT_GE(of_kind(layout, "wall_unit").size(), 20U);
}

TEST(Layout, LanesPointToTheExitWithAPassageBetween) {
  const std::vector<layout::Fixture> lanes =
      of_kind(lay_out(sample::small_shop()), "checkout_lane");
  ASSERT_EQ(lanes.size(), 2U);
  EXPECT_EQ(lanes[0].yaw_deg, 0);
  EXPECT_EQ(lanes[0].y_mm, lanes[1].y_mm);
  EXPECT_EQ(lanes[1].x_mm - lanes[0].x_mm, 1100 + 1000);
  EXPECT_GE(layout::footprint_of(lanes[0]).y0, 2000);  // the exit's approach stays free
}

TEST(Layout, EndcapsCloseTheRunsTheyBelongTo) {
  plan::Plan plan = sample::small_shop();
  plan.zones[1].fixture.endcaps = plan::Endcaps::both;
  const layout::Layout layout = lay_out(plan);
  const std::vector<layout::Fixture> endcaps = of_kind(layout, "endcap");
  ASSERT_EQ(endcaps.size(), 10U);
  for (const layout::Fixture& endcap : endcaps) {
    int lowest = 100000, highest = 0;
    for (const layout::Fixture& f : layout.fixtures) {
      if (f.run != endcap.endcap_of) continue;
      lowest = std::min(lowest, layout::footprint_of(f).y0);
      highest = std::max(highest, layout::footprint_of(f).y1);
    }
    const bool front = endcap.id.ends_with("endcap-front");
    EXPECT_EQ(front ? layout::footprint_of(endcap).y1 : layout::footprint_of(endcap).y0,
              front ? lowest : highest)
        << endcap.id;
    EXPECT_EQ(endcap.yaw_deg, front ? 0 : 180) << endcap.id;
  }
}

TEST(Layout, LongRunsAreBrokenByCrossAisles) {
  plan::Plan plan = sample::one_zone(12000, 30000, sample::zone("dry", "dry_goods", "gondola"));
  plan.zones[0].fixture.run_max_mm = 8000;
  const layout::Layout layout = lay_out(plan);
  std::map<std::string, int> length;
  for (const layout::Fixture& f : of_kind(layout, "gondola"))
    length[f.run] += f.width_mm;
  ASSERT_FALSE(length.empty());
  for (const auto& [run, mm] : length)
    EXPECT_LE(mm, 8000) << run;
}

TEST(Layout, CountsLimitTheModules) {
  plan::Plan plan = sample::one_zone(12000, 8000, sample::zone("dairy", "dairy", "multideck"));
  plan.zones[0].fixture.count = 4;
  EXPECT_EQ(of_kind(lay_out(plan), "multideck").size(), 4U);
}

TEST(Layout, FixturesKeepOffColumns) {
  plan::Plan plan = sample::small_shop();
  plan.shell.columns = {{8000, 10000, 400}, {4000, 10500, 400}, {12000, 9000, 400}};
  const layout::Layout layout = lay_out(plan);
  for (const layout::Fixture& f : layout.fixtures) {
    for (const plan::Column& c : plan.shell.columns) {
      EXPECT_FALSE(overlap(layout::footprint_of(f),
                           RectMm{c.x_mm - 300, c.y_mm - 300, c.x_mm + 300, c.y_mm + 300}))
          << f.id;
    }
  }
}

TEST(Layout, ASanePlanBreaksNoRule) {
  for (const layout::Violation& v : lay_out(sample::small_shop()).violations)
    ADD_FAILURE() << v.code << ": " << v.message;
}

TEST(Layout, EverythingHangsTogetherForARobot) {
  const plan::Plan plan = sample::small_shop();
  const layout::Layout layout = lay_out(plan);
  const layout::Reach reach = layout::reach_of(
      layout::make_floor(plan.shell), plan.shell, layout.fixtures, layout::robot_width_mm);
  EXPECT_EQ(reach.components.cells.size(), 2U);  // index 0 is unused: one part
}

TEST(Layout, OverridesChangeOnlyWhatTheyName) {
  plan::Plan plan = sample::small_shop();
  const layout::Layout before = lay_out(plan);
  const std::string id = of_kind(before, "gondola").front().id;
  plan.overrides = {{id, "levels", "3"}, {id, "color", "#ff0000"}};
  layout::Layout after = lay_out(plan);
  auto changed = std::ranges::find(after.fixtures, id, &layout::Fixture::id);
  ASSERT_NE(changed, after.fixtures.end());
  EXPECT_EQ(changed->levels, 3);
  EXPECT_EQ(changed->color, "#ff0000");
  *changed = *layout::find_fixture(before, id);
  EXPECT_EQ(io::write_json(after), io::write_json(before));
}

TEST(Layout, OverridesOfNothingAreErrors) {
  const catalog::Catalog catalog = sample::catalog();
  plan::Plan plan = sample::small_shop();
  plan.overrides = {{"goods/run-99/module-1", "levels", "3"}};
  Result<layout::Layout> layout = layout::make_layout(plan, catalog, Seed(1));
  ASSERT_FALSE(layout.ok());
  EXPECT_EQ(layout.error().code, "plan.unknown_reference");
  EXPECT_EQ(layout.error().where, "/overrides/0/fixture");
  plan.overrides = {{"goods/run-1/module-1", "levels", "many"}};
  layout = layout::make_layout(plan, catalog, Seed(1));
  ASSERT_FALSE(layout.ok());
  EXPECT_EQ(layout.error().code, "plan.bad_value");
}

// By how much each fixture of the layout has moved; those that have not are left out.
std::map<std::string, PointMm> shifts(const layout::Layout& before, const layout::Layout& after) {
  std::map<std::string, PointMm> moved;
  for (const layout::Fixture& old : before.fixtures) {
    const layout::Fixture* now = layout::find_fixture(after, old.id);
    if (now == nullptr) {
      ADD_FAILURE() << old.id << " is gone";
      continue;
    }
    const PointMm by{now->x_mm - old.x_mm, now->y_mm - old.y_mm};
    if (by != PointMm{0, 0}) moved[old.id] = by;
  }
  return moved;
}

TEST(Layout, APinnedPlaceMovesTheWholeRunWithItsEndcaps) {
  plan::Plan plan = sample::small_shop();
  plan.zones[1].fixture.endcaps = plan::Endcaps::both;
  const layout::Layout before = lay_out(plan);
  const layout::Fixture pinned = of_kind(before, "gondola").at(1);
  plan.overrides = {{pinned.id, "x_mm", std::to_string(pinned.x_mm + 150)},
                    {pinned.id, "y_mm", std::to_string(pinned.y_mm - 50)}};
  const layout::Layout after = lay_out(plan);
  std::map<std::string, PointMm> run;
  for (const layout::Fixture& f : before.fixtures)
    if (f.run == pinned.run || f.endcap_of == pinned.run) run[f.id] = {150, -50};
  EXPECT_GT(run.size(), 3U) << "modules and two endcaps";
  EXPECT_EQ(shifts(before, after), run);
  EXPECT_NE(io::write_json(after.aisles), io::write_json(before.aisles));
}

TEST(Layout, WhatStandsBackToBackMovesTogether) {
  plan::Plan plan = sample::small_shop();
  plan.zones[1].fixture.kind = "multideck";
  const layout::Layout before = lay_out(plan);
  for (const layout::Fixture& a : before.fixtures) {
    for (const layout::Fixture& b : before.fixtures) {
      const bool behind =
          a.yaw_deg == 90 && b.yaw_deg == 270 && a.y_mm == b.y_mm && a.x_mm - b.x_mm == a.depth_mm;
      if (!behind) continue;
      plan.overrides = {{a.id, "x_mm", std::to_string(a.x_mm + 40)}};
      const auto moved = shifts(before, lay_out(plan));
      EXPECT_TRUE(moved.contains(a.id) && moved.contains(b.id));
      for (const auto& [id, by] : moved)
        EXPECT_TRUE(id.starts_with(a.run + "/") || id.starts_with(b.run + "/")) << id;
      return;
    }
  }
  FAIL() << "no pair stands back to back";
}

TEST(Layout, APinnedPlaceIsHeldAgainstTheRules) {
  plan::Plan plan = sample::small_shop();
  const layout::Fixture pinned = of_kind(lay_out(plan), "gondola").front();
  plan.overrides = {{pinned.id, "x_mm", std::to_string(pinned.x_mm + 1200)}};
  const layout::Layout after = lay_out(plan);
  EXPECT_TRUE(std::ranges::any_of(after.violations, [](const layout::Violation& v) {
    return v.code == "AISLE_TOO_NARROW" || v.code == "FIXTURE_OVERLAP";
  }));
}

TEST(Layout, NothingIsPinnedBesideItsZone) {
  plan::Plan plan = sample::small_shop();
  const layout::Fixture pinned = of_kind(lay_out(plan), "gondola").front();
  plan.overrides = {{pinned.id, "y_mm", "900"}};
  const auto layout = layout::make_layout(plan, sample::catalog(), Seed(1));
  ASSERT_FALSE(layout.ok());
  EXPECT_EQ(layout.error().code, "plan.bad_value");
  EXPECT_EQ(layout.error().where, "/overrides/0/value");
  EXPECT_NE(layout.error().message.find("goods"), std::string::npos);
}

TEST(Layout, NoRoomForAnythingIsAnError) {
  const catalog::Catalog catalog = sample::catalog();
  const plan::Plan plan = sample::one_zone(4000, 4000, sample::zone("back", "backroom", "gondola"));
  const Result<layout::Layout> layout = layout::make_layout(plan, catalog, Seed(1));
  ASSERT_FALSE(layout.ok());
  EXPECT_EQ(layout.error().code, "layout.impossible");
}

TEST(Layout, ReadsBackFromJson) {
  const layout::Layout layout = lay_out(sample::small_shop());
  const Result<layout::Layout> again =
      io::read_json<layout::Layout>(io::write_json(layout), "layout.json");
  ASSERT_TRUE(again.ok()) << to_string(again.error());
  EXPECT_EQ(io::write_json(*again), io::write_json(layout));
}

}  // namespace
}  // namespace marketgen
