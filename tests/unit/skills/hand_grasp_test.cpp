// What a grasp is worth and how hard it is held.
#include "skills/hand_grasp.h"

#include <gtest/gtest.h>

#include <numbers>

namespace marketgen {
namespace {

struct Pack {
  catalog::Product product;
  assets::ProductBody body;
  skills::LyingPack lying() const { return {product, body, 0.6, {{0.5, 0, 0}, {}}}; }
};

motion::GraspCandidate from_above(double tilt) {
  motion::GraspCandidate candidate;
  candidate.grasp = {{{0, 0, 0}, rotation_about({1, 0, 0}, std::numbers::pi + tilt)}, 0.05, 10};
  candidate.clearance_m = 0.01;
  candidate.score = 0.5;
  return candidate;
}

TEST(HandGrasp, RoomFirmnessAndTiltAreWeighed) {
  const Pack pack;
  // 30 of its firmness and 1000 of its room.
  EXPECT_NEAR(skills::lifting_grasp(pack.lying(), from_above(0)).score, 15 + 10, 1e-9);
  const double leans = std::numbers::pi / 6;
  EXPECT_NEAR(skills::lifting_grasp(pack.lying(), from_above(leans)).score, 25 - 0.2 * 30, 1e-6);
  motion::GraspCandidate off = from_above(0);
  off.grasp.product_from_tool.position = {0.02, 0, 0};
  EXPECT_NEAR(skills::lifting_grasp(pack.lying(), off).score, 25 - 250 * 0.02, 1e-9);
}

TEST(HandGrasp, WhatIsInTheWayCostsUpToItsBound) {
  EXPECT_EQ(skills::overlap_cost(0), 0);
  EXPECT_NEAR(skills::overlap_cost(0.005), 15, 1e-9);
  EXPECT_EQ(skills::overlap_cost(0.015), skills::overlap_cost(1));
}

TEST(HandGrasp, ForcesAreTwiceWhatIsNeededWithinBounds) {
  const Pack pack;
  EXPECT_EQ(skills::lifting_grasp(pack.lying(), from_above(0)).force_n, 30);  // not below
  motion::GraspCandidate heavy = from_above(0);
  heavy.grasp.force_n = 50;
  EXPECT_EQ(skills::lifting_grasp(pack.lying(), heavy).force_n, 60);
  EXPECT_EQ(skills::carrying_grasp({}, from_above(0), 70).force_n, 20);
  EXPECT_EQ(skills::carrying_grasp({}, heavy, 70).force_n, 70);  // as far as the tool can
}

TEST(HandGrasp, TiltIsFromStraightDown) {
  EXPECT_NEAR(skills::tilt_deg(rotation_about({1, 0, 0}, std::numbers::pi)), 0, 1e-6);
  EXPECT_NEAR(skills::tilt_deg({}), 180, 1e-6);
  EXPECT_NEAR(skills::tilt_deg(rotation_about({0, 1, 0}, std::numbers::pi / 2)), 90, 1e-6);
}

}  // namespace
}  // namespace marketgen
