#include "motion/rrt_connect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace marketgen {
namespace {

// A unit square with a wall at x 0.5 that has a gap near the top, in steps of a thousandth.
motion::ConfigurationSpace walled_square(double gap) {
  motion::ConfigurationSpace space{{0, 0}, {1, 1}, {}, {}};
  space.free = [gap](std::span<const double> q) {
    return std::abs(q[0] - 0.5) > 0.05 || q[1] > 1 - gap;
  };
  space.motion_free = [free = space.free](std::span<const double> a, std::span<const double> b) {
    const int steps = 1 + static_cast<int>(motion::distance(a, b) / 1e-3);
    for (int k = 0; k <= steps; ++k) {
      const double share = double(k) / steps;
      const double q[2] = {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
      if (!free(q)) return false;
    }
    return true;
  };
  return space;
}

std::string code_of(const Result<motion::JointPath>& result) {
  return result.ok() ? "ok" : result.error().code;
}

TEST(RrtConnect, AFreeMotionIsTheWholePath) {
  const auto path = motion::rrt_connect(walled_square(0.1), {0.1, 0.1}, {{0.4, 0.9}}, Seed(1));
  ASSERT_TRUE(path.ok());
  EXPECT_EQ(*path, (motion::JointPath{{0.1, 0.1}, {0.4, 0.9}}));
}

TEST(RrtConnect, FindsTheGapAndShortcutsNearlyToTheBestPath) {
  const motion::ConfigurationSpace space = walled_square(0.1);
  const double best = 2 * std::hypot(0.35, 0.8) + 0.1;  // by both corners of the gap
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto path = motion::rrt_connect(space, {0.1, 0.1}, {{0.9, 0.1}}, Seed(seed));
    ASSERT_TRUE(path.ok());
    const motion::JointPath shorter = motion::shortcut(space, *path, Seed(seed), 200);
    EXPECT_EQ(shorter.front(), (motion::Configuration{0.1, 0.1}));
    EXPECT_EQ(shorter.back(), (motion::Configuration{0.9, 0.1}));
    for (std::size_t i = 0; i + 1 < shorter.size(); ++i)
      EXPECT_TRUE(space.motion_free(shorter[i], shorter[i + 1]));
    EXPECT_LE(motion::length_of(shorter), motion::length_of(*path) + 1e-12);
    EXPECT_GE(motion::length_of(shorter), best - 1e-2);
    EXPECT_LE(motion::length_of(shorter), 1.1 * best) << "seed " << seed;
  }
}

TEST(RrtConnect, TakesTheGoalThatCanBeReached) {
  const motion::ConfigurationSpace shut = walled_square(0);
  const auto path =
      motion::rrt_connect(shut, {0.1, 0.1}, {{0.5, 0.5}, {0.9, 0.1}, {0.3, 0.8}}, Seed(1));
  ASSERT_TRUE(path.ok());
  EXPECT_EQ(path->back(), (motion::Configuration{0.3, 0.8}));
}

TEST(RrtConnect, BadQuestionsAreErrors) {
  const motion::ConfigurationSpace space = walled_square(0.1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code_of(motion::rrt_connect(space, {0.5, 0.1}, {{0.9, 0.1}}, Seed(1))),
            "motion.start_in_collision");
  EXPECT_EQ(code_of(motion::rrt_connect(space, {0.1, 0.1}, {{0.5, 0.1}, {0.5, 0.2}}, Seed(1))),
            "motion.goal_in_collision");
  EXPECT_EQ(code_of(motion::rrt_connect(space, {0.1, nan}, {{0.9, 0.1}}, Seed(1))),
            "motion.bad_configuration");
  EXPECT_EQ(code_of(motion::rrt_connect(space, {0.1, 0.1}, {{0.9, 1.1}}, Seed(1))),
            "motion.bad_configuration");
  EXPECT_EQ(code_of(motion::rrt_connect(space, {0.1}, {{0.9, 0.1}}, Seed(1))),
            "motion.bad_configuration");
  EXPECT_EQ(code_of(motion::rrt_connect(space, {0.1, 0.1}, {}, Seed(1))),
            "motion.goal_in_collision");
}

TEST(RrtConnect, AShutWallEndsAtTheLimit) {
  motion::RrtOptions options;
  options.max_iterations = 2000;
  EXPECT_EQ(
      code_of(motion::rrt_connect(walled_square(0), {0.1, 0.1}, {{0.9, 0.1}}, Seed(1), options)),
      "motion.no_path");
  options.max_iterations = 1'000'000;
  options.max_nodes = 100;
  EXPECT_EQ(
      code_of(motion::rrt_connect(walled_square(0), {0.1, 0.1}, {{0.9, 0.1}}, Seed(1), options)),
      "motion.no_path");
}

TEST(RrtConnect, TheSeedAloneDecides) {
  const motion::ConfigurationSpace space = walled_square(0.05);
  const auto once = motion::rrt_connect(space, {0.1, 0.1}, {{0.9, 0.1}}, Seed(4));
  const auto again = motion::rrt_connect(space, {0.1, 0.1}, {{0.9, 0.1}}, Seed(4));
  const auto other = motion::rrt_connect(space, {0.1, 0.1}, {{0.9, 0.1}}, Seed(5));
  ASSERT_TRUE(once.ok() && again.ok() && other.ok());
  EXPECT_EQ(*once, *again);
  EXPECT_NE(*once, *other);
}

}  // namespace
}  // namespace marketgen
