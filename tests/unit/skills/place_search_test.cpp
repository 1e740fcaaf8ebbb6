// Where an arm puts down what it holds, by what it is told of the counter: bodies, points, areas.
#include "skills/place_search.h"

#include <gtest/gtest.h>

#include <numbers>

#include "skills/hand_reach.h"
#include "support/committed_robot.h"

namespace marketgen {
namespace {

// A box of 6 x 6 x 10 cm in the long hand of a Panda, held in its middle from above.
class PlaceSearch : public testing::Test {
 protected:
  PlaceSearch()
      : robot_(committed_robot("panda", {{"tool", "panda-long-hand"}})),
        tool_(robots::load_grasp_tool(committed_rows, "panda-long-hand").value()),
        arm_(skills::ArmExecutor::make(robot_).value()) {
    product_.archetype = "box";
    product_.size_mm = {60, 60, 100};
    assets::ContactPiece piece;
    piece.center = {0, 0, 0.05F};
    piece.half_size = {0.03F, 0.03F, 0.05F};
    body_.pieces = {piece};
    agent::Observation first;
    for (const int dof : robot_.find_group("arm")->dofs)
      first.position.push_back(robots::neutral_state(robot_)[static_cast<std::size_t>(dof)]);
    first.openings_m = {0.06};
    arm_.start(first);
    const Quaternion down = rotation_about({1, 0, 0}, std::numbers::pi);
    held_ = {&product_, &body_, inverse(Pose{{0, 0, 0.06}, down}), {}, 0.08};
    question_.area = {{0.40, -0.20}, {0.64, 0.20}};
  }

  std::vector<skills::FreePlace> places() const {
    return skills::free_places(tool_, arm_, held_, question_, 4);
  }
  static agent::WorkArea outline(const skills::FreePlace& place) {  // upright
    const Vec3 at = place.base_from_product.position;
    return {{at.x - 0.03, at.y - 0.03}, {at.x + 0.03, at.y + 0.03}};
  }
  // How far a point is outside of a place's pack.
  static double gap(const skills::FreePlace& place, Vec3 point) {
    const agent::WorkArea at = outline(place);
    return std::max({at.low_m[0] - point.x,
                     point.x - at.high_m[0],
                     at.low_m[1] - point.y,
                     point.y - at.high_m[1]});
  }

  robots::Robot robot_;
  robots::GraspTool tool_;
  skills::ArmExecutor arm_;
  catalog::Product product_;
  assets::ProductBody body_;
  skills::HeldPack held_;
  skills::PlaceQuestion question_;
};

TEST_F(PlaceSearch, StandsUprightInTheAreaALittleOverTheCounter) {
  const auto found = places();
  ASSERT_FALSE(found.empty());
  const skills::FreePlace& best = found.front();
  EXPECT_NEAR(best.base_from_product.position.z, skills::let_go_height_m, 1e-6);
  EXPECT_NEAR(rotate(best.base_from_product.rotation, {0, 0, 1}).z, 1, 1e-9);
  EXPECT_GT(outline(best).low_m[0], question_.area.low_m[0]);
  EXPECT_LT(outline(best).high_m[1], question_.area.high_m[1]);
  EXPECT_TRUE(arm_.effort_to(best.base_from_tip).has_value());
}

TEST_F(PlaceSearch, KeepsOffABodyAndOffPointsThatShowIt) {
  const Vec3 middle{0.52, 0, 0.05};
  assets::ContactPiece piece;
  piece.half_size = {0.02F, 0.02F, 0.05F};
  const motion::GraspSurface surface({piece});
  question_.bodies = {{{&surface, {middle, {}}}, {middle, {0.02, 0.02, 0.05}}}};
  const auto off_body = places();
  ASSERT_FALSE(off_body.empty());
  for (const skills::FreePlace& place : off_body)
    EXPECT_GE(gap(place, middle), 0.02 + 0.012 - 1e-9);
  question_.bodies.clear();
  const std::vector<Vec3f> points(5, to_float(middle));
  question_.points = &points;
  const auto off_points = places();
  ASSERT_FALSE(off_points.empty());
  for (const skills::FreePlace& place : off_points)
    EXPECT_GE(gap(place, middle), 0.012 - 1e-9);
}

TEST_F(PlaceSearch, WhatLiesOnTheCounterItselfIsNothing) {
  const auto empty = places();
  const std::vector<Vec3f> noise(50, Vec3f{0.52F, 0, 0.005F});
  question_.points = &noise;
  const auto found = places();
  ASSERT_EQ(found.size(), empty.size());
  EXPECT_EQ(found.front().base_from_product.position.x, empty.front().base_from_product.position.x);
}

TEST_F(PlaceSearch, StaysOutOfAreasThatAreKeptFree) {
  question_.kept_free = {{{0.30, -0.30}, {0.70, 0.05}}};
  const auto found = places();
  ASSERT_FALSE(found.empty());
  for (const skills::FreePlace& place : found)
    EXPECT_GE(outline(place).low_m[1], 0.05);
  question_.kept_free = {{{0, -1}, {1, 1}}};
  EXPECT_TRUE(places().empty());
}

TEST_F(PlaceSearch, WhoIsUnsureKeepsFartherOff) {
  question_.area = {{0.45, -0.037}, {0.55, 0.037}};  // 7 mm on either side of it
  EXPECT_FALSE(places().empty());
  question_.unsure_m = 0.004;
  EXPECT_TRUE(places().empty());
}

TEST_F(PlaceSearch, AreasKeptFreeHoldBasketAndUnloading) {
  agent::Workplace place;
  place.base_from_basket = {{0.5, 0.1, 0}, {}};
  place.inner_half = {0.15, 0.2, 0};
  place.wall_m = 0.01;
  place.unloading = {{0.3, -0.5}, {0.6, -0.2}};
  const auto areas = skills::areas_kept_free(place);
  ASSERT_EQ(areas.size(), 2U);
  EXPECT_NEAR(areas[0].high_m[0], 0.5 + 0.15 + 0.01 + 0.03, 1e-9);
  EXPECT_NEAR(areas[1].low_m[1], -0.5 - 0.02, 1e-9);
}

TEST_F(PlaceSearch, AReachBeginsOverTheRim) {
  const Pose straight{{0.5, 0, 0.03}, rotation_about({1, 0, 0}, std::numbers::pi)};
  EXPECT_NEAR(skills::reach_over_rim(straight, 0.15, 0.06).approach.z, 0.15 + 0.04 - 0.03, 1e-9);
  const Pose high{{0.5, 0, 0.18}, straight.rotation};
  EXPECT_EQ(skills::reach_over_rim(high, 0.15, 0.06).approach.z, 0.08);  // the least
  const std::vector<Pose> both = skills::either_way_round(arm_, straight);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_LE(arm_.effort_to(both[0]).value(), arm_.effort_to(both[1]).value());
}

}  // namespace
}  // namespace marketgen
