#include "motion/rrt_connect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace marketgen {
namespace {

// A unit square with a wall at x 0.5 that has a gap near the top, in steps of a thousandth.
ConfigurationSpace walled_square(double gap) {
  ConfigurationSpace space{{0, 0}, {1, 1}, {}, {}};
  space.free = [gap](std::span<const double> q) {
    return std::abs(q[0] - 0.5) > 0.05 || q[1] > 1 - gap;
  };
  space.motion_free = [free = space.free](std::span<const double> a, std::span<const double> b) {
    const int steps = 1 + static_cast<int>(distance(a, b) / 1e-3);
    for (int k = 0; k <= steps; ++k) {
      const double share = double(k) / steps;
      const double q[2] = {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
      if (!free(q)) return false;
    }
    return true;
  };
  return space;
}

std::string code_of(const Result<JointPath>& result) {
  return result.ok() ? "ok" : result.error().code;
}

TEST(RrtConnect, AFreeMotionIsTheWholePath) {
  const auto path = rrt_connect(walled_square(0.1), {0.1, 0.1}, {{0.4, 0.9}}, Seed(1));
  ASSERT_TRUE(path.ok());
  EXPECT_EQ(*path, (JointPath{{0.1, 0.1}, {0.4, 0.9}}));
}

TEST(RrtConnect, FindsTheGapAndShortcutsNearlyToTheBestPath) {
  const ConfigurationSpace space = walled_square(0.1);
  const double best = 2 * std::hypot(0.35, 0.8) + 0.1;  // by both corners of the gap
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto path = rrt_connect(space, {0.1, 0.1}, {{0.9, 0.1}}, Seed(seed));
    ASSERT_TRUE(path.ok());
    const JointPath shorter = shortcut(space, *path, Seed(seed), 200);
    EXPECT_EQ(shorter.front(), (Configuration{0.1, 0.1}));
    EXPECT_EQ(shorter.back(), (Configuration{0.9, 0.1}));
    for (std::size_t i = 0; i + 1 < shorter.size(); ++i)
      EXPECT_TRUE(space.motion_free(shorter[i], shorter[i + 1]));
    EXPECT_LE(length_of(shorter), length_of(*path) + 1e-12);
    EXPECT_GE(length_of(shorter), best - 1e-2);
    EXPECT_LE(length_of(shorter), 1.1 * best) << "seed " << seed;
  }
}

TEST(RrtConnect, TakesTheGoalThatCanBeReached) {
  const ConfigurationSpace shut = walled_square(0);
  const auto path = rrt_connect(shut, {0.1, 0.1}, {{0.5, 0.5}, {0.9, 0.1}, {0.3, 0.8}}, Seed(1));
  ASSERT_TRUE(path.ok());
  EXPECT_EQ(path->back(), (Configuration{0.3, 0.8}));
}

TEST(RrtConnect, BadQuestionsAreErrors) {
  const ConfigurationSpace space = walled_square(0.1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code_of(rrt_connect(space, {0.5, 0.1}, {{0.9, 0.1}}, Seed(1))),
            "motion.start_in_collision");
  EXPECT_EQ(code_of(rrt_connect(space, {0.1, 0.1}, {{0.5, 0.1}, {0.5, 0.2}}, Seed(1))),
            "motion.goal_in_collision");
  EXPECT_EQ(code_of(rrt_connect(space, {0.1, nan}, {{0.9, 0.1}}, Seed(1))),
            "motion.bad_configuration");
  EXPECT_EQ(code_of(rrt_connect(space, {0.1, 0.1}, {{0.9, 1.1}}, Seed(1))),
            "motion.bad_configuration");
  EXPECT_EQ(code_of(rrt_connect(space, {0.1}, {{0.9, 0.1}}, Seed(1))), "motion.bad_configuration");
  EXPECT_EQ(code_of(rrt_connect(space, {0.1, 0.1}, {}, Seed(1))), "motion.goal_in_collision");
}

TEST(RrtConnect, AShutWallEndsAtTheLimit) {
  RrtOptions options;
  options.max_iterations = 2000;
  EXPECT_EQ(code_of(rrt_connect(walled_square(0), {0.1, 0.1}, {{0.9, 0.1}}, Seed(1), options)),
            "motion.no_path");
  options.max_iterations = 1'000'000;
  options.max_nodes = 100;
  EXPECT_EQ(code_of(rrt_connect(walled_square(0), {0.1, 0.1}, {{0.9, 0.1}}, Seed(1), options)),
            "motion.no_path");
}

TEST(RrtConnect, TheSeedAloneDecides) {
  const ConfigurationSpace space = walled_square(0.05);
  const auto once = rrt_connect(space, {0.1, 0.1}, {{0.9, 0.1}}, Seed(4));
  const auto again = rrt_connect(space, {0.1, 0.1}, {{0.9, 0.1}}, Seed(4));
  const auto other = rrt_connect(space, {0.1, 0.1}, {{0.9, 0.1}}, Seed(5));
  ASSERT_TRUE(once.ok() && again.ok() && other.ok());
  EXPECT_EQ(*once, *again);
  EXPECT_NE(*once, *other);
}

}  // namespace
}  // namespace marketgen
