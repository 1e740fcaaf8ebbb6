#include "layout/floor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "layout/zone_ground.h"
#include "sample_shop.h"

namespace marketgen {
namespace {

const PolygonMm l_shape{{0, 0}, {12000, 0}, {12000, 6000}, {8000, 6000}, {8000, 10000}, {0, 10000}};

plan::Shell l_shell() {
  plan::Shell shell;
  shell.width_mm = 12000;
  shell.depth_mm = 10000;
  shell.outline_mm = l_shape;
  return shell;
}

TEST(Floor, ApproachIsTwoMetresDeepAndHalfAMetreWider) {
  plan::Shell shell;
  shell.width_mm = 20000;
  shell.depth_mm = 10000;
  shell.openings = {sample::door("in", plan::OpeningKind::entrance, plan::Wall::south, 0.25, 1800),
                    sample::door("dock", plan::OpeningKind::service, plan::Wall::east, 0.5, 2000)};
  const layout::Floor floor = layout::make_floor(shell);
  EXPECT_EQ(floor.doorways[0].approach, (RectMm{3600, 0, 6400, 2000}));
  EXPECT_EQ(floor.doorways[1].approach, (RectMm{18000, 3500, 20000, 6500}));
  EXPECT_EQ(floor.doorways[0].threshold, (PointMm{5000, 0}));
}

TEST(Floor, WindowsNeedNoApproach) {
  plan::Shell shell;
  shell.openings = {sample::door("w", plan::OpeningKind::window, plan::Wall::north, 0.5)};
  EXPECT_TRUE(layout::make_floor(shell).doorways[0].approach.empty());
}

TEST(Floor, WhatAnLShapeLacksIsOutside) {
  const layout::Floor floor = layout::make_floor(l_shell());
  double outside_m2 = 0;
  for (const RectMm& rect : floor.outside)
    outside_m2 += rect.area_m2();
  EXPECT_DOUBLE_EQ(outside_m2, 16.0);
  EXPECT_TRUE(layout::on_floor(floor, {0, 0, 12000, 6000}));
  EXPECT_FALSE(layout::on_floor(floor, {7000, 5000, 9000, 7000}));
}

TEST(Floor, SlantedWallsAreSteppedInward) {  // a triangle cut off the north-east corner
  plan::Shell shell;
  shell.width_mm = 10000;
  shell.depth_mm = 10000;
  shell.outline_mm = PolygonMm{{0, 0}, {10000, 0}, {10000, 6000}, {6000, 10000}, {0, 10000}};
  const layout::Floor floor = layout::make_floor(shell);
  EXPECT_TRUE(layout::on_floor(floor, {0, 0, 10000, 6000}));
  EXPECT_FALSE(layout::on_floor(floor, {8000, 8000, 8100, 8100}));
  EXPECT_TRUE(layout::on_floor(floor, {7000, 8000, 7700, 8200}));
}

TEST(ZoneGround, PiecesAvoidWhatIsNotFloor) {
  plan::Plan plan = sample::one_zone(12000, 10000, sample::zone("all", "dry_goods", "gondola"));
  plan.shell = l_shell();
  const std::vector<layout::Ground> grounds =
      layout::zone_grounds(plan, layout::make_floor(plan.shell));
  ASSERT_EQ(grounds.size(), 2U);
  EXPECT_EQ(grounds[0].rect, (RectMm{0, 0, 8000, 10000}));
  EXPECT_EQ(grounds[1].rect, (RectMm{8000, 0, 12000, 6000}));
  EXPECT_TRUE(grounds[1].touches_wall(layout::Side::north));
  EXPECT_FALSE(grounds[1].touches_wall(layout::Side::west));
}

TEST(ZoneGround, WallsReachOverHalfTheGapToTheNextZone) {
  plan::Plan plan = sample::one_zone(12000, 6000, sample::zone("a", "dry_goods", "gondola"));
  plan.zones.push_back(sample::zone("b", "snacks", "gondola"));
  plan.nodes = {sample::cut("root", plan::Axis::x, 0.5, 2000, "l", "r"),
                sample::leaf("l", "a"),
                sample::leaf("r", "b")};
  const std::vector<layout::Ground> grounds =
      layout::zone_grounds(plan, layout::make_floor(plan.shell));
  ASSERT_EQ(grounds.size(), 2U);
  EXPECT_EQ(grounds[0].rect, (RectMm{0, 0, 5000, 6000}));
  EXPECT_EQ(grounds[0].gap_mm[layout::index_of(layout::Side::east)], 2000);
  EXPECT_EQ(grounds[0].walls[layout::index_of(layout::Side::north)],
            (std::vector<layout::Span>{{0, 6000}}));
  EXPECT_EQ(grounds[1].walls[layout::index_of(layout::Side::north)],
            (std::vector<layout::Span>{{6000, 12000}}));
}

TEST(ZoneGround, PolygonIsClippedToTheOutline) {
  const PolygonMm polygon =
      layout::zone_polygon({6000, 4000, 12000, 10000}, layout::make_floor(l_shell()));
  EXPECT_DOUBLE_EQ(area_m2(polygon), 6 * 2 + 2 * 4.0);
}

// A star whose hundred slanted walls all stand at other heights: millions of steps.
TEST(Floor, ARoomOfTooManySlantedWallsIsRefused) {
  plan::Shell shell;
  shell.width_mm = shell.depth_mm = 200'000;
  PolygonMm star;
  for (int i = 0; i < 196; ++i) {
    const double angle = 2 * std::numbers::pi * i / 196 + 0.01, r = i % 2 == 0 ? 99'000 : 30'000;
    star.push_back({100'000 + static_cast<int>(r * std::cos(angle)),
                    100'000 + static_cast<int>(r * std::sin(angle))});
  }
  shell.outline_mm = star;
  const auto possible = layout::check_floor(shell);
  ASSERT_FALSE(possible.ok());
  EXPECT_EQ(possible.error().code, "plan.bad_shell");
  EXPECT_NE(possible.error().message.find("fewer corners"), std::string::npos);
}

TEST(Floor, ARoundRoomIsNot) {
  plan::Shell shell;
  shell.width_mm = shell.depth_mm = 60'000;
  PolygonMm round;
  for (int i = 0; i < 40; ++i) {
    const double angle = 2 * std::numbers::pi * i / 40;
    round.push_back({30'000 + static_cast<int>(30'000 * std::cos(angle)),
                     30'000 + static_cast<int>(30'000 * std::sin(angle))});
  }
  shell.outline_mm = round;
  EXPECT_TRUE(layout::check_floor(shell).ok());
  EXPECT_LT(layout::make_floor(shell).outside.size(), layout::max_pieces_outside);
}

}  // namespace
}  // namespace marketgen
