// How often the oracle tries, and what it does not try again.
#include "oracle/oracle_tries.h"

#include <gtest/gtest.h>

#include <numbers>

namespace marketgen {
namespace {

TEST(OracleTries, AnItemIsTakenThreeTimesWhereItLies) {
  oracle::OracleTries tries;
  for (int i = 1; i <= 3; ++i) {
    EXPECT_TRUE(tries.may_take(5));
    EXPECT_EQ(tries.take(5), i);
  }
  EXPECT_FALSE(tries.may_take(5));
  EXPECT_TRUE(tries.may_take(6));
  tries.put_down(5);
  EXPECT_TRUE(tries.may_take(5));
}

TEST(OracleTries, WhatIsKnockedOutAgainAndAgainIsGivenUp) {
  oracle::OracleTries tries;
  int takes = 0;
  while (tries.may_take(1) && takes < 100) {
    tries.take(1);
    tries.put_down(1);
    ++takes;
  }
  EXPECT_EQ(takes, 6);
}

TEST(OracleTries, TheSameGraspIsTheOneNearByEitherWayRound) {
  oracle::OracleTries tries;
  const Pose grasp{{0.01, 0, 0.05}, rotation_about({1, 0, 0}, std::numbers::pi)};
  tries.fail(2, grasp);
  EXPECT_TRUE(tries.failed_before(2, grasp));
  EXPECT_TRUE(
      tries.failed_before(2, grasp * Pose{{}, rotation_about({0, 0, 1}, std::numbers::pi)}));
  EXPECT_FALSE(tries.failed_before(3, grasp));
  EXPECT_FALSE(tries.failed_before(2, Pose{{0.03, 0, 0}, {}} * grasp));
  const Pose turned = grasp * Pose{{}, rotation_about({0, 0, 1}, 0.6)};
  EXPECT_FALSE(tries.failed_before(2, turned));
  EXPECT_TRUE(tries.failed_before(2, turned, robots::ToolKind::suction));
}

}  // namespace
}  // namespace marketgen
