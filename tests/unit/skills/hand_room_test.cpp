// Room for an open hand: among measured points, bodies and the walls of a basket.
#include "skills/hand_room.h"

#include <gtest/gtest.h>

#include <numbers>

#include "support/committed_robot.h"

namespace marketgen {
namespace {

constexpr double hand_opening_m = 0.06;

robots::GraspTool long_hand() {
  return robots::load_grasp_tool(committed_rows, "panda-long-hand").value();
}
Pose looking_down(Vec3 at) {
  return {at, rotation_about({1, 0, 0}, std::numbers::pi)};
}
motion::GraspSurface cube(float half) {
  assets::ContactPiece piece;
  piece.half_size = {half, half, half};
  return motion::GraspSurface({piece});
}

TEST(HandRoom, IsAsDeepAsThePointsReachIntoTheFingers) {
  const std::vector<robots::ToolSolid> hand = skills::open_hand(long_hand(), hand_opening_m);
  const Pose tip = looking_down({0.5, 0, 0.05});
  EXPECT_EQ(skills::hand_overlap(hand, tip, std::vector<Vec3f>{}), 0);
  const Vec3f inside = to_float(tip * hand.front().tool_from_solid.position);  // of the left pad
  EXPECT_GT(skills::hand_overlap(hand, tip, std::vector<Vec3f>(5, inside)), 0.002);
  EXPECT_EQ(skills::hand_overlap(hand, tip, std::vector<Vec3f>(2, inside)), 0)
      << "two strays count";
  const Pose aside = looking_down({0.5, 0.3, 0.05});
  EXPECT_EQ(skills::hand_overlap(hand, aside, std::vector<Vec3f>(5, inside)), 0);
}

TEST(HandRoom, ABodyAndItsPointsAreInTheWayAlike) {
  const std::vector<robots::ToolSolid> hand = skills::open_hand(long_hand(), hand_opening_m);
  const motion::GraspSurface surface = cube(0.01F);
  const Pose tip = looking_down({0.5, 0, 0.05});
  const Vec3 pad = tip * hand.front().tool_from_solid.position;
  EXPECT_GT(skills::hand_overlap(hand, tip, skills::PlacedBody{&surface, {pad, {}}}), 0.005);
  EXPECT_EQ(
      skills::hand_overlap(hand, tip, skills::PlacedBody{&surface, {pad + Vec3{0, 0, -0.3}, {}}}),
      0);
  // Over the hand, where it comes from: it is met on the way.
  EXPECT_GT(
      skills::hand_overlap(hand, tip, skills::PlacedBody{&surface, {pad + Vec3{0, 0, 0.1}, {}}}),
      0.002);
}

TEST(HandRoom, ABoxReachesIntoACubeByWhatTheyShare) {
  const motion::GraspSurface surface = cube(0.05F);
  const skills::PlacedBody body{&surface, {{1, 0, 0}, {}}};
  EXPECT_NEAR(skills::box_overlap(body, {{1.055, 0, 0}, {}}, {0.01, 0.01, 0.01}), 0.005, 1e-6);
  EXPECT_EQ(skills::box_overlap(body, {{1.065, 0, 0}, {}}, {0.01, 0.01, 0.01}), 0);
}

TEST(HandRoom, WallsStandWhereTheirBasketStands) {
  agent::Workplace place;
  place.walls = {{{{0.15, 0, 0.08}, {}}, {0.005, 0.2, 0.08}}};
  const skills::BasketWalls basket(place);
  const std::vector<robots::ToolSolid> hand = skills::open_hand(long_hand(), hand_opening_m);
  const Pose tip = looking_down({0.65, 0, 0.05});
  EXPECT_TRUE(skills::is_near(hand, tip, basket.at({{0.5, 0, 0}, {}}), 0.002));
  EXPECT_FALSE(skills::is_near(hand, tip, basket.at({{0.9, 0, 0}, {}}), 0.002));
}

}  // namespace
}  // namespace marketgen
