// Setpoints keep the limits of their joint whatever they are told, and follow what keeps them.
#include "robots/setpoint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/seed.h"

namespace marketgen {
namespace {

constexpr double tick_s = 0.002;
constexpr SetpointLimits of_joint{-1, 1, 2, 10};

TEST(Setpoint, WhatKeepsTheLimitsIsFollowedExactly) {
  Setpoint setpoint;
  for (int i = 1; i <= 2000; ++i) {  // 0.5 sin(2 t): at most 1 a second, 2 a second squared
    const double t = i * tick_s;
    setpoint.follow({0.5 * std::sin(2 * t), std::cos(2 * t)}, of_joint, tick_s);
    ASSERT_NEAR(setpoint.position, 0.5 * std::sin(2 * t), i < 300 ? 0.1 : 1e-9) << t;
  }
}

TEST(Setpoint, AnythingElseIsFollowedWithinTheLimits) {
  Stream draw = Seed(3).stream();
  Setpoint setpoint, wanted;
  for (int i = 0; i < 20000; ++i) {
    if (draw.chance(0.02))
      wanted = {draw.uniform(-1e3, 1e3) * (draw.chance(0.5) ? 1 : 1e-3), draw.uniform(-50, 50)};
    const Setpoint before = setpoint;
    setpoint.follow(wanted, of_joint, tick_s);
    ASSERT_LE(std::abs(setpoint.velocity), of_joint.velocity);
    ASSERT_LE(std::abs(setpoint.velocity - before.velocity),
              of_joint.acceleration * tick_s + 1e-12);
    ASSERT_LE(std::abs(setpoint.position), 1.0);
    ASSERT_NEAR(setpoint.position, before.position + setpoint.velocity * tick_s, 1e-9)
        << "it was stopped by its end at " << before.velocity;
  }
}

TEST(Setpoint, AJumpIsGoneAsFastAsTheLimitsAllowAndNoFarther) {
  Setpoint setpoint;
  double farthest = 0;
  int steps = 0;
  while (std::abs(setpoint.position - 0.8) > 1e-6) {
    setpoint.follow({0.8, 0}, of_joint, tick_s);
    farthest = std::max(farthest, setpoint.position);
    ASSERT_LT(++steps, 1000);
  }
  EXPECT_LT(farthest, 0.8 + 1e-6);
  // 0.2 s to full speed and 0.2 s to stand, 0.4 on the way: another 0.2 s at full speed.
  EXPECT_NEAR(steps * tick_s, 0.6, 0.02);
}

TEST(Setpoint, WhatIsHeldBackDoesNotRunAhead) {
  Setpoint setpoint{0, 1};
  setpoint.keep_near(-0.3, 0.1);
  EXPECT_DOUBLE_EQ(setpoint.position, -0.2);
  EXPECT_EQ(setpoint.velocity, 0);
  setpoint = {0, 1};
  setpoint.keep_near(0.05, 0.1);
  EXPECT_EQ(setpoint.position, 0);
  EXPECT_EQ(setpoint.velocity, 1);
}

}  // namespace
}  // namespace marketgen
