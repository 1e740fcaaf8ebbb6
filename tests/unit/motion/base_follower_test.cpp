// The base on its way: at the goal, within the limits of its row, never in motion against somebody.
#include "motion/base_follower.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/committed_robot.h"

namespace marketgen {
namespace {

constexpr double tick = 0.02;

motion::BaseLimits realman_limits() {
  return motion::base_limits(committed_robot("realman-rm75")).value();
}

navigation::FloorPath around_a_shelf() {
  const PolygonMm floor{{0, 0}, {10000, 0}, {10000, 8000}, {0, 8000}};
  const auto graph = navigation::VisibilityGraph::make(floor, {{3000, 0, 4000, 5000}}, 450);
  return graph->shortest_path({1000, 1000}, {8000, 1500}).value();
}

double away(Vec2 a, Vec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

double off_the_path(const navigation::FloorPath& path, Vec2 p) {
  double least = 1e9;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    const Vec2 a{path.points[i][0] * 1e-3, path.points[i][1] * 1e-3};
    const Vec2 b{path.points[i + 1][0] * 1e-3, path.points[i + 1][1] * 1e-3};
    least = std::min(least, away(a, p) + away(p, b) - away(a, b));
  }
  return least;
}

TEST(BaseFollower, LimitsComeFromTheRow) {
  const motion::BaseLimits limits = realman_limits();
  EXPECT_EQ(limits.speed, 1.5);
  EXPECT_EQ(limits.acceleration, 1.0);
  EXPECT_EQ(limits.turn_rate, 1.5);
  EXPECT_EQ(limits.turn_acceleration, 2.0);
  EXPECT_EQ(limits.wheel_track, 0.287);
}

TEST(BaseFollower, ArrivesOnThePathWithinEveryLimit) {
  const navigation::FloorPath path = around_a_shelf();
  ASSERT_GE(path.points.size(), 4U);
  const motion::BaseLimits limits = realman_limits();
  auto follower = motion::BaseFollower::make(path, 2.0, -1.0, limits).value();
  motion::BaseState before = follower.state();
  double fastest = 0, time = 0, turned = 0;
  for (; !follower.done() && time < 120; time += tick) {
    const motion::BaseState now = follower.step(tick);
    EXPECT_LE(now.speed, limits.speed + 1e-12);
    EXPECT_LE(std::abs(now.turn_rate), limits.turn_rate + 1e-12);
    EXPECT_LE(std::abs(now.speed - before.speed), limits.acceleration * tick + 1e-9);
    EXPECT_LE(std::abs(now.turn_rate - before.turn_rate), limits.turn_acceleration * tick + 1e-9);
    EXPECT_LE(off_the_path(path, now.position), 1e-9);
    EXPECT_NEAR(away(now.position, before.position), now.speed * tick, 2e-3 * tick + 1e-9);
    const motion::WheelRates wheels = follower.wheels();
    EXPECT_NEAR((wheels.left + wheels.right) / 2 * limits.wheel_radius, now.speed, 1e-12);
    EXPECT_NEAR((wheels.right - wheels.left) * limits.wheel_radius / limits.wheel_track,
                now.turn_rate,
                1e-12);
    fastest = std::max(fastest, now.speed);
    turned = std::max(turned, std::abs(now.turn_rate));
    before = now;
  }
  EXPECT_TRUE(follower.done());
  EXPECT_LT(away(follower.state().position, {8, 1.5}), 1e-6);
  EXPECT_NEAR(follower.state().heading, -1.0, 1e-9);
  EXPECT_GT(fastest, 1.45);
  EXPECT_GT(turned, 1.0);
  // Not slower than it must be: each leg as a trapezoid, and half a second for each turn's ends.
  EXPECT_LT(time, path.length_m / 1.5 + 1.5 * double(path.points.size() - 1) + 8);
}

TEST(BaseFollower, StopsForSomebodyWhoCrossesAndGoesOn) {
  const navigation::FloorPath path{{{0, 0}, {10000, 0}}, 10};
  auto follower = motion::BaseFollower::make(path, 0, std::nullopt, realman_limits()).value();
  motion::BaseOptions options;
  bool waited = false;
  double nearest = 1e9, time = 0;
  for (; !follower.done() && time < 60; time += tick) {
    // Walks up to the path, stands on it from 5 to 10 s, and on.
    const double y = time < 5 ? -4 + 0.8 * time : time < 10 ? 0 : 0.8 * (time - 10);
    const motion::MovingDisc person{{5, y}, 0.3, 0.8};
    const motion::BaseState& now = follower.step(tick, std::span(&person, 1));
    waited = waited || follower.waits();
    if (now.speed > 0)
      nearest = std::min(nearest, away(now.position, person.position) - 0.3 - options.base_radius);
  }
  EXPECT_TRUE(follower.done());
  EXPECT_TRUE(waited);
  EXPECT_GT(nearest, 0.05);
  EXPECT_GT(time, 10);
}

TEST(BaseFollower, SomebodyWhoStandsStillIsWaitedForAndSomebodyBesideIsPassed) {
  const navigation::FloorPath path{{{0, 0}, {10000, 0}}, 10};
  auto blocked = motion::BaseFollower::make(path, 0, std::nullopt, realman_limits()).value();
  auto passing = motion::BaseFollower::make(path, 0, std::nullopt, realman_limits()).value();
  const motion::MovingDisc ahead{{5, 0.2}, 0.3, 0}, beside{{5, 0.85}, 0.3, 0};
  for (double time = 0; time < 20; time += tick) {
    blocked.step(tick, std::span(&ahead, 1));
    passing.step(tick, std::span(&beside, 1));
  }
  EXPECT_FALSE(blocked.done());
  EXPECT_TRUE(blocked.waits());
  EXPECT_NEAR(away(blocked.state().position, ahead.position), 0.8, 1e-3);  // 0.4 + 0.1 + 0.3
  EXPECT_TRUE(passing.done());
}

TEST(BaseFollower, BadInputIsAnErrorAndADiscAnywhereStopsTheBase) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const navigation::FloorPath path{{{0, 0}, {1000, 0}}, 1};
  const auto code = [](const Result<motion::BaseFollower>& r) {
    return r.ok() ? "ok" : r.error().code;
  };
  motion::BaseLimits none = realman_limits();
  EXPECT_EQ(code(motion::BaseFollower::make({}, 0, std::nullopt, none)),
            "motion.bad_configuration");
  EXPECT_EQ(code(motion::BaseFollower::make(path, nan, std::nullopt, none)),
            "motion.bad_configuration");
  none.acceleration = 0;
  EXPECT_EQ(code(motion::BaseFollower::make(path, 0, std::nullopt, none)), "motion.bad_limits");
  auto panda = committed_robot("panda");
  EXPECT_EQ(motion::base_limits(panda).error().code, "motion.bad_limits");
  auto follower = motion::BaseFollower::make(path, 0, std::nullopt, realman_limits()).value();
  const motion::MovingDisc ghost{{nan, 0}, 0.3, 0};
  for (int i = 0; i < 500; ++i)
    follower.step(tick, std::span(&ghost, 1));
  EXPECT_FALSE(follower.done());
  EXPECT_EQ(follower.state().speed, 0);
  EXPECT_EQ(follower.state().position, (Vec2{0, 0}));
}

}  // namespace
}  // namespace marketgen
