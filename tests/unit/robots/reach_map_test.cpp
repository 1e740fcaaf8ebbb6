// Reach maps: the shares of a few cells agree with a solver that shares nothing with the map's, and
// the map is empty where the arm is too short.
#include "robots/reach_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "robots/numeric_ik.h"
#include "support/committed_robot.h"

namespace marketgen {
namespace {

// Of the same orientations, how many damped least squares reach from 21 starts each.
double share_by_descent(const robots::Robot& robot,
                        Vec3 point,
                        const std::vector<Quaternion>& turns) {
  const robots::JointGroup& arm = *robot.find_group("arm");
  int reached = 0;
  for (const Quaternion& turn : turns)
    reached += robots::solve_numeric(
                   robot, arm.tip, arm.dofs, {point, turn}, robots::neutral_state(robot), Seed(1))
                       .ok()
                   ? 1
                   : 0;
  return static_cast<double>(reached) / static_cast<double>(turns.size());
}

// Cells over which the share goes from all to nothing: a row straight ahead at shoulder height.
void expect_agreement(const std::string& id, double tolerance) {
  const robots::Robot robot = committed_robot(id);
  const auto arm = robots::make_arm_ik(robot, *robot.find_group("arm"));
  ASSERT_TRUE(arm.ok()) << to_string(arm.error());
  robots::ReachMapOptions options;
  options.low = {0.2, 0.05, 0.2}, options.high = {1.1, 0.2, 0.35};
  options.cell_m = 0.15;
  options.directions = 10, options.rolls = 2;
  const auto map = robots::make_reach_map(*arm, options);
  ASSERT_TRUE(map.ok()) << to_string(map.error());
  ASSERT_EQ(map->cells, (std::array<int, 3>{6, 1, 1}));
  const std::vector<Quaternion> turns = robots::reach_orientations(10, 2);
  float most = 0, least = 1;
  for (int x = 0; x < 6; ++x) {
    const float share = map->share(x, 0, 0);
    EXPECT_NEAR(share, share_by_descent(robot, map->center(x, 0, 0), turns), tolerance)
        << id << " cell " << x;
    EXPECT_EQ(share, map->share_at(map->center(x, 0, 0)));
    most = std::max(most, share), least = std::min(least, share);
  }
  EXPECT_GT(most, 0.4F) << id;
  EXPECT_LT(least, 0.2F) << id;
}

TEST(ReachMap, AgreesWithASolverThatSharesNothingWithIt) {
  expect_agreement("rm65-b-v", 1e-6);
  expect_agreement("rm75-b", 0.051);  // one of 20: a sweep misses windows narrower than its step
  expect_agreement("panda", 0.051);
}

TEST(ReachMap, OrientationsAreSpreadEvenly) {
  const std::vector<Quaternion> turns = robots::reach_orientations(200, 3);
  ASSERT_EQ(turns.size(), 600U);
  Vec3 sum{};
  std::array<int, 8> octants{};
  for (const Quaternion& turn : turns) {
    const Vec3 z = rotate(turn, {0, 0, 1});
    EXPECT_NEAR(length(z), 1, 1e-12);
    sum += z;
    octants[static_cast<std::size_t>((z.x > 0) + 2 * (z.y > 0) + 4 * (z.z > 0))] += 1;
  }
  EXPECT_LT(length(sum) / 600, 0.01);
  for (const int count : octants)
    EXPECT_NEAR(count, 75, 9);
}

TEST(ReachMap, IsEmptyBeyondTheArmAndFullerNearTheShoulder) {
  const robots::Robot robot = committed_robot("rm65-b-v");
  const auto arm = robots::make_arm_ik(robot, *robot.find_group("arm"));
  robots::ReachMapOptions options;
  options.directions = 12, options.rolls = 1;
  const auto map = robots::make_reach_map(*arm, options);
  ASSERT_TRUE(map.ok()) << to_string(map.error());
  EXPECT_EQ(map->cells, (std::array<int, 3>{20, 20, 20}));
  for (int z = 0; z < 20; ++z) {
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 20; ++x) {
        const double far = length(map->center(x, y, z) - Vec3{0, 0, 0.2405});
        if (far > 0.256 + 0.21 + 0.1668) {
          EXPECT_EQ(map->share(x, y, z), 0);
        }
      }
    }
  }
  EXPECT_GT(map->share_at({0.35, 0, 0.25}), 0.5F);
  EXPECT_EQ(map->share_at({0, 0, 5}), 0);
  const ThreadLimit one(1);
  const auto again = robots::make_reach_map(*arm, options);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->shares, map->shares);
}

TEST(ReachMap, BadOptionsAreNamed) {
  const robots::Robot robot = committed_robot("rm65-b-v");
  const auto arm = robots::make_arm_ik(robot, *robot.find_group("arm"));
  robots::ReachMapOptions empty, coarse, fine, endless;
  empty.high = empty.low;
  coarse.cell_m = 0;
  fine.cell_m = 1e-3;
  endless.high.x = HUGE_VAL;
  for (const robots::ReachMapOptions& options : {empty, coarse, fine, endless}) {
    const auto map = robots::make_reach_map(*arm, options);
    ASSERT_FALSE(map.ok());
    EXPECT_EQ(map.error().code, "robot.bad_state");
  }
}

}  // namespace
}  // namespace marketgen
