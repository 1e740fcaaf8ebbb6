#include "motion/joint_trajectory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/seed.h"

namespace marketgen {
namespace {

// The Panda's published limits.
std::vector<motion::MotionLimits> panda_limits() {
  const double velocity[] = {2.175, 2.175, 2.175, 2.175, 2.61, 2.61, 2.61};
  const double acceleration[] = {15, 7.5, 10, 12.5, 15, 20, 20};
  const double jerk[] = {7500, 3750, 5000, 6250, 7500, 10000, 10000};
  std::vector<motion::MotionLimits> limits;
  for (int j = 0; j < 7; ++j)
    limits.push_back({velocity[j], acceleration[j], jerk[j]});
  return limits;
}

// Largest share of each limit that is used, by differences of what at() says.
motion::MotionLimits worst_use(const motion::JointTrajectory& t,
                               const std::vector<motion::MotionLimits>& limits,
                               double dt) {
  motion::MotionLimits most{0, 0, 0};
  const int steps = static_cast<int>(t.duration_s() / dt) + 2;
  motion::TrajectoryState before = t.at(0);
  for (int k = 1; k <= steps; ++k) {
    const motion::TrajectoryState now = t.at(k * dt);
    for (std::size_t j = 0; j < limits.size(); ++j) {
      const double v = (now.position[j] - before.position[j]) / dt;
      const double a = (now.velocity[j] - before.velocity[j]) / dt;
      const double jerk = (now.acceleration[j] - before.acceleration[j]) / dt;
      most.velocity = std::max(most.velocity, std::abs(v) / limits[j].velocity);
      most.acceleration = std::max(most.acceleration, std::abs(a) / limits[j].acceleration);
      most.jerk = std::max(most.jerk, std::abs(jerk) / limits[j].jerk);
      // What is said of velocity and acceleration is what the positions do.
      EXPECT_NEAR(v, (now.velocity[j] + before.velocity[j]) / 2, limits[j].jerk * dt * dt);
      EXPECT_NEAR(a, (now.acceleration[j] + before.acceleration[j]) / 2, limits[j].jerk * dt);
    }
    before = now;
  }
  return most;
}

TEST(SCurve, KnownDurations) {
  // All seven pieces: v 1, a 2, j 8: 0.25 s of each jerk, 0.25 s steady, so 0.75 s to full speed
  // over 0.375 m; 2 m take 2 * 0.75 + 1.25 s.
  EXPECT_NEAR(motion::SCurve(2, {1, 2, 8}).duration_s(), 2.75, 1e-12);
  // Never at full acceleration: v 1, j 1, a 10: 1 s of each jerk, 1 m each way; 3 m take 4 + 1 s.
  EXPECT_NEAR(motion::SCurve(3, {1, 10, 1}).duration_s(), 5, 1e-12);
  // Jerk alone: 4 cbrt(d / (2 j)).
  EXPECT_NEAR(motion::SCurve(0.002, {10, 10, 1}).duration_s(), 4 * std::cbrt(0.001), 1e-12);
  EXPECT_EQ(motion::SCurve(0, {1, 1, 1}).duration_s(), 0);
}

TEST(SCurve, LimitsAreKeptAndSomeLimitIsAlwaysReached) {
  Stream draw = Seed(3).child("curves").stream();
  for (int i = 0; i < 300; ++i) {
    const double distance = std::exp(draw.uniform(-6, 3));
    const motion::MotionLimits limits{std::exp(draw.uniform(-3, 3)),
                                      std::exp(draw.uniform(-3, 3)),
                                      std::exp(draw.uniform(-3, 5))};
    const motion::SCurve curve(distance, limits);
    const double whole = curve.duration_s();
    motion::MotionState before = curve.at(0);
    constexpr int steps = 400;
    double fastest = 0, strongest = 0;
    for (int k = 1; k <= steps; ++k) {
      const motion::MotionState now = curve.at(whole * k / steps);
      EXPECT_GE(now.position, before.position - 1e-12);
      EXPECT_LE(now.velocity, limits.velocity * (1 + 1e-9));
      EXPECT_LE(std::abs(now.acceleration), limits.acceleration * (1 + 1e-9));
      EXPECT_LE(std::abs(now.acceleration - before.acceleration),
                limits.jerk * whole / steps * (1 + 1e-6));
      fastest = std::max(fastest, now.velocity);
      strongest = std::max(strongest, now.acceleration);
      before = now;
    }
    EXPECT_NEAR(curve.at(whole * (1 - 1e-9)).position, distance, 1e-6 * distance);
    EXPECT_NEAR(curve.at(whole / 2).position, distance / 2, 1e-9 * distance);
    EXPECT_TRUE(fastest > 0.99 * limits.velocity || strongest > 0.97 * limits.acceleration ||
                std::abs(whole - 4 * std::cbrt(distance / (2 * limits.jerk))) < 1e-9 * whole);
  }
}

TEST(JointTrajectory, StraightPiecesKeepEveryLimitAndThePath) {
  Stream draw = Seed(8).child("paths").stream();
  const std::vector<motion::MotionLimits> limits = panda_limits();
  for (int i = 0; i < 5; ++i) {
    motion::JointPath path;
    for (int k = 0; k < 4; ++k) {
      path.emplace_back();
      for (int j = 0; j < 7; ++j)
        path.back().push_back(draw.uniform(-2, 2));
    }
    const auto timed = motion::timed_path(path, limits);
    ASSERT_TRUE(timed.ok());
    const motion::MotionLimits use = worst_use(*timed, limits, 1e-4);
    EXPECT_LE(use.velocity, 1 + 1e-6);
    EXPECT_LE(use.acceleration, 1 + 1e-6);
    EXPECT_LE(use.jerk, 1 + 1e-6);
    EXPECT_GT(use.velocity, 0.99);
    EXPECT_EQ(timed->at(-1).position, path.front());
    for (std::size_t j = 0; j < 7; ++j)
      EXPECT_NEAR(timed->at(1e9).position[j], path.back()[j], 1e-12);
    // Every place lies on one of the pieces.
    for (double t = 0; t < timed->duration_s(); t += 0.01) {
      const motion::Configuration q = timed->at(t).position;
      double off = 1e9;
      for (std::size_t k = 0; k + 1 < path.size(); ++k)
        off = std::min(off,
                       motion::distance(path[k], q) + motion::distance(q, path[k + 1]) -
                           motion::distance(path[k], path[k + 1]));
      EXPECT_LT(off, 1e-9);
    }
  }
}

TEST(JointTrajectory, ACurveIsRunThroughWithoutAStop) {
  motion::JointPath knots;
  for (int k = 0; k <= 40; ++k)
    knots.push_back({std::sin(0.05 * k), std::cos(0.05 * k), 0.02 * k});
  const std::vector<motion::MotionLimits> limits{{2, 10, 500}, {2, 10, 500}, {2, 10, 500}};
  const auto timed = motion::timed_curve(knots, limits);
  ASSERT_TRUE(timed.ok());
  const motion::MotionLimits use = worst_use(*timed, limits, 1e-4);
  EXPECT_LE(use.velocity, 1 + 1e-6);
  EXPECT_LE(use.acceleration, 1 + 1e-4);
  EXPECT_LE(use.jerk, 1 + 1e-3);
  double slowest = 1e9;
  for (double t = 0.3 * timed->duration_s(); t < 0.7 * timed->duration_s(); t += 0.001)
    slowest = std::min(slowest, timed->at(t).velocity[2]);
  EXPECT_GT(slowest, 0.1);
}

TEST(JointTrajectory, AppendedMotionsFollowOneAnother) {
  const std::vector<motion::MotionLimits> limits{{1, 2, 8}};
  auto first = motion::timed_path({{0}, {2}}, limits);
  const auto second = motion::timed_path({{2}, {1}}, limits);
  ASSERT_TRUE(first.ok() && second.ok());
  const double sum = first->duration_s() + second->duration_s();
  first->append(*second);
  EXPECT_NEAR(first->duration_s(), sum, 1e-12);
  EXPECT_NEAR(first->at(2.75).position[0], 2, 1e-12);
  EXPECT_NEAR(first->at(sum).position[0], 1, 1e-12);
}

TEST(JointTrajectory, BadInputIsAnError) {
  const std::vector<motion::MotionLimits> one{{1, 1, 1}};
  const auto code = [](const Result<motion::JointTrajectory>& r) {
    return r.ok() ? "ok" : r.error().code;
  };
  EXPECT_EQ(code(motion::timed_path({}, one)), "motion.bad_configuration");
  EXPECT_EQ(code(motion::timed_path({{0}, {0, 1}}, one)), "motion.bad_configuration");
  EXPECT_EQ(code(motion::timed_path({{0}, {std::numeric_limits<double>::quiet_NaN()}}, one)),
            "motion.bad_configuration");
  EXPECT_EQ(code(motion::timed_path({{0}, {1}}, {{1, 0, 1}})), "motion.bad_limits");
  EXPECT_EQ(code(motion::timed_path({{0, 0}, {1, 1}}, one)), "motion.bad_limits");
  const auto still = motion::timed_path({{3}}, one);
  ASSERT_TRUE(still.ok());
  EXPECT_EQ(still->duration_s(), 0);
  EXPECT_EQ(still->at(1).position[0], 3);
}

}  // namespace
}  // namespace marketgen
