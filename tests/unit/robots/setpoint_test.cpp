// Setpoints keep the limits of their joint whatever they are told, and follow what keeps them.
#include "robots/setpoint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/seed.h"

namespace marketgen {
namespace {

constexpr double tick_s = 0.002;
constexpr robots::SetpointLimits of_joint{-1, 1, 2, 10};
// As the Panda's: full acceleration in 2 ms; and one that takes 50 ms to it.
constexpr robots::SetpointLimits quick_joint{-1, 1, 2, 10, 5000}, slow_joint{-1, 1, 2, 10, 200};

TEST(Setpoint, WhatKeepsTheLimitsIsFollowedExactly) {
  robots::Setpoint setpoint;
  for (int i = 1; i <= 2000; ++i) {  // 0.5 sin(2 t): at most 1 a second, 2 a second squared
    const double t = i * tick_s;
    setpoint.follow({0.5 * std::sin(2 * t), std::cos(2 * t)}, of_joint, tick_s);
    ASSERT_NEAR(setpoint.position, 0.5 * std::sin(2 * t), i < 300 ? 0.1 : 1e-9) << t;
  }
}

TEST(Setpoint, AnythingElseIsFollowedWithinTheLimits) {
  Stream draw = Seed(3).stream();
  robots::Setpoint setpoint, wanted;
  for (int i = 0; i < 20000; ++i) {
    if (draw.chance(0.02))
      wanted = {draw.uniform(-1e3, 1e3) * (draw.chance(0.5) ? 1 : 1e-3), draw.uniform(-50, 50)};
    const robots::Setpoint before = setpoint;
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
  robots::Setpoint setpoint;
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
  robots::Setpoint setpoint{0, 1};
  setpoint.keep_near({-0.3, 0}, 0.1);
  EXPECT_DOUBLE_EQ(setpoint.position, -0.2);
  EXPECT_EQ(setpoint.velocity, 0);
  setpoint = {0, 1};
  setpoint.keep_near({0.05, 0}, 0.1);
  EXPECT_EQ(setpoint.position, 0);
  EXPECT_EQ(setpoint.velocity, 1);
}

// A joint that lags at its speed limit is not stopped: it goes on as fast as it does.
TEST(Setpoint, WhatLagsGoesOnAsFastAsItDoes) {
  const auto held = [](double velocity, double joint_velocity) {
    robots::Setpoint setpoint{0, velocity};
    setpoint.keep_near({velocity > 0 ? -0.3 : 0.3, joint_velocity}, 0.1);
    return setpoint.velocity;
  };
  EXPECT_EQ(held(2, 1.9), 1.9);
  EXPECT_EQ(held(-2, -1.9), -1.9);
  EXPECT_EQ(held(2, 3), 2);     // no faster than it was told
  EXPECT_EQ(held(2, -0.5), 0);  // nor backwards
}

void follows_anything_within(const robots::SetpointLimits& limits) {
  Stream draw = Seed(4).stream();
  robots::SmoothSetpoint setpoint;
  robots::Setpoint wanted;
  double before = 0, greatest_jerk = 0;
  for (int i = 0; i < 20000; ++i) {
    if (draw.chance(0.02))
      wanted = {draw.uniform(-1e3, 1e3) * (draw.chance(0.5) ? 1 : 1e-3), draw.uniform(-50, 50)};
    const robots::Setpoint from = setpoint.now();
    setpoint.follow(wanted, limits, tick_s);
    const robots::Setpoint now = setpoint.now();
    ASSERT_LE(std::abs(now.position), 1.0);
    ASSERT_LE(std::abs(now.velocity), limits.velocity + 1e-12);
    ASSERT_LE(std::abs(setpoint.acceleration()), limits.acceleration + 1e-9);
    ASSERT_NEAR(now.velocity - from.velocity, setpoint.acceleration() * tick_s, 1e-12);
    ASSERT_NEAR(now.position, from.position + now.velocity * tick_s, 1e-9);
    greatest_jerk = std::max(greatest_jerk, std::abs(setpoint.acceleration() - before) / tick_s);
    before = setpoint.acceleration();
  }
  EXPECT_LT(greatest_jerk, limits.jerk * (1 + 1e-9));
  EXPECT_GT(greatest_jerk, limits.jerk * 0.9);
}

TEST(SmoothSetpoint, FollowsAnythingWithinTheJerkToo) {
  follows_anything_within(quick_joint);
  follows_anything_within(slow_joint);
}

TEST(SmoothSetpoint, WhatKeepsTheLimitsIsFollowedCloselyAndWithoutLag) {
  robots::SmoothSetpoint quick, slow;
  double farthest_quick = 0, farthest_slow = 0;
  for (int i = 1; i <= 2000; ++i) {
    const double t = i * tick_s;
    const robots::Setpoint wanted{0.5 * std::sin(2 * t), std::cos(2 * t)};
    quick.follow(wanted, quick_joint, tick_s);
    slow.follow(wanted, slow_joint, tick_s);
    if (i < 300) continue;  // it starts at rest
    farthest_quick = std::max(farthest_quick, std::abs(quick.now().position - wanted.position));
    farthest_slow = std::max(farthest_slow, std::abs(slow.now().position - wanted.position));
  }
  EXPECT_LT(farthest_quick, 2e-6);  // at 1 rad/s one step is 2e-3
  EXPECT_LT(farthest_slow, 3e-3);   // half of 2 rad/s^2 over (50 ms)^2
}

TEST(SmoothSetpoint, ComesToRestWhereItIsTold) {
  robots::SmoothSetpoint setpoint;
  for (int i = 0; i < 500; ++i)
    setpoint.follow({0.8, 0}, slow_joint, tick_s);
  EXPECT_NEAR(setpoint.now().position, 0.8, 1e-9);
  EXPECT_NEAR(setpoint.now().velocity, 0, 1e-9);
}

TEST(SmoothSetpoint, OfAJointWithoutAJerkItIsThePlainOne) {
  Stream draw = Seed(5).stream();
  robots::Setpoint plain;
  robots::SmoothSetpoint smooth;
  for (int i = 0; i < 2000; ++i) {
    const robots::Setpoint wanted{draw.uniform(-2, 2), draw.uniform(-3, 3)};
    plain.follow(wanted, of_joint, tick_s);
    smooth.follow(wanted, of_joint, tick_s);
    ASSERT_EQ(smooth.now().position, plain.position);
    ASSERT_EQ(smooth.now().velocity, plain.velocity);
  }
}

TEST(SmoothSetpoint, WhatIsHeldBackGoesOnFromThere) {
  robots::SmoothSetpoint setpoint;
  for (int i = 0; i < 100; ++i)
    setpoint.follow({0.9, 0}, quick_joint, tick_s);
  ASSERT_GT(setpoint.now().velocity, 1);
  setpoint.keep_near({0, 0}, 0.01);
  EXPECT_DOUBLE_EQ(setpoint.now().position, 0.01);
  EXPECT_EQ(setpoint.now().velocity, 0);
  EXPECT_EQ(setpoint.acceleration(), 0);
  setpoint.follow({0.9, 0}, quick_joint, tick_s);
  EXPECT_NEAR(setpoint.now().position, 0.01, 1e-4);
}

}  // namespace
}  // namespace marketgen
