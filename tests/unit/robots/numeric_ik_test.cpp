// Numeric inverse kinematics: base, lift and arm together reach poses that the robot can take, stay
// within the limits, leave the other joints alone and say how near they came when they cannot.
#include "robots/numeric_ik.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robots/arm_ik.h"
#include "support/committed_robot.h"

namespace marketgen {
namespace {

std::vector<int> dofs_of(const robots::Robot& robot, std::initializer_list<const char*> groups) {
  std::vector<int> dofs;
  for (const char* name : groups) {
    const robots::JointGroup& group = *robot.find_group(name);
    dofs.insert(dofs.end(), group.dofs.begin(), group.dofs.end());
  }
  return dofs;
}

std::vector<double> random_posture(const robots::Robot& robot,
                                   const std::vector<int>& dofs,
                                   Stream& draw) {
  std::vector<double> q = robots::neutral_state(robot);
  for (const int dof : dofs) {
    const robots::Joint& joint = robot.joint_of_dof(static_cast<std::size_t>(dof));
    q[static_cast<std::size_t>(dof)] =
        draw.uniform(std::max(joint.lower, -2.0), std::min(joint.upper, 2.0));
  }
  return q;
}

TEST(NumericIk, BaseLiftAndArmReachPosesTogether) {
  const robots::Robot robot = committed_robot("realman-rm65");
  ASSERT_FALSE(robot.links.empty());
  const std::vector<int> dofs = dofs_of(robot, {"base", "lift", "left_arm"});
  const int tip = robot.find_group("left_arm")->tip;
  const std::vector<double> seed = robots::neutral_state(robot);
  Stream draw = Seed(5).child("numeric").stream();
  for (int i = 0; i < 100; ++i) {
    const Pose goal = robots::frame_pose(robot, random_posture(robot, dofs, draw), tip);
    const auto q = robots::solve_numeric(robot, tip, dofs, goal, seed, Seed(1));
    ASSERT_TRUE(q.ok()) << to_string(q.error());
    EXPECT_LT(largest_difference(robots::frame_pose(robot, *q, tip), goal), 3e-9);
    EXPECT_TRUE(robots::within_limits(robot, *q));
    for (std::size_t dof = 0; dof < seed.size(); ++dof) {
      if (std::find(dofs.begin(), dofs.end(), static_cast<int>(dof)) == dofs.end()) {
        EXPECT_EQ((*q)[dof], seed[dof]);
      }
    }
  }
}

// Two solvers that share nothing agree, pose by pose, on what the arm can reach.
TEST(NumericIk, ReachesExactlyWhatTheAnalyticSolverReaches) {
  const robots::Robot robot = committed_robot("realman-rm65");
  const robots::JointGroup& arm = *robot.find_group("left_arm");
  const auto analytic = robots::make_arm_ik(robot, arm);
  ASSERT_TRUE(analytic.ok()) << to_string(analytic.error());
  const std::vector<double> seed = robots::neutral_state(robot);
  const Pose arm_from_floor =
      inverse(robots::link_poses(robot, seed)[static_cast<std::size_t>(arm.base)]);
  Stream draw = Seed(11).child("two_solvers").stream();
  int reachable = 0;
  for (int i = 0; i < 300; ++i) {
    const Quaternion turn = rotation_about({0, 1, 0}, draw.uniform(0, 3)) *
                            rotation_about({0, 0, 1}, draw.uniform(-3, 3));
    const Pose goal{{draw.uniform(0.3, 1.1), draw.uniform(-0.3, 0.9), draw.uniform(0.3, 1.3)},
                    turn};
    const bool solved = !robots::solve_arm(*analytic, arm_from_floor * goal, 0).empty();
    EXPECT_EQ(robots::solve_numeric(robot, arm.tip, arm.dofs, goal, seed, Seed(1)).ok(), solved);
    reachable += solved ? 1 : 0;
  }
  EXPECT_GT(reachable, 50);
  EXPECT_LT(reachable, 250);
}

TEST(NumericIk, TheSameArgumentsGiveTheSameAnswer) {
  const robots::Robot robot = committed_robot("realman-rm65");
  const std::vector<int> dofs = dofs_of(robot, {"left_arm"});
  const int tip = robot.find_group("left_arm")->tip;
  Stream draw = Seed(6).child("numeric").stream();
  const Pose goal = robots::frame_pose(robot, random_posture(robot, dofs, draw), tip);
  const std::vector<double> seed = robots::neutral_state(robot);
  const auto one = robots::solve_numeric(robot, tip, dofs, goal, seed, Seed(1));
  const auto two = robots::solve_numeric(robot, tip, dofs, goal, seed, Seed(1));
  ASSERT_TRUE(one.ok()) << to_string(one.error());
  ASSERT_TRUE(two.ok());
  EXPECT_EQ(*one, *two);
}

TEST(NumericIk, AFarPoseIsUnreachableForTheArmButNotForTheBase) {
  const robots::Robot robot = committed_robot("realman-rm65");
  const int tip = robot.find_group("left_arm")->tip;
  const std::vector<double> seed = robots::neutral_state(robot);
  const Pose goal{{5, 1, 1}, {}};
  const auto arm =
      robots::solve_numeric(robot, tip, dofs_of(robot, {"left_arm"}), goal, seed, Seed(1));
  ASSERT_FALSE(arm.ok());
  EXPECT_EQ(arm.error().code, "robot.unreachable");
  EXPECT_EQ(arm.error().where, "realman-rm65:left_tool_tcp");
  EXPECT_TRUE(robots::solve_numeric(
                  robot, tip, dofs_of(robot, {"base", "lift", "left_arm"}), goal, seed, Seed(1))
                  .ok());
}

TEST(NumericIk, ABadSeedOrGoalIsNamed) {
  const robots::Robot robot = committed_robot("realman-rm65");
  const std::vector<int> dofs = dofs_of(robot, {"left_arm"});
  const int tip = robot.find_group("left_arm")->tip;
  const auto short_seed = robots::solve_numeric(robot, tip, dofs, {}, {0, 0}, Seed(1));
  ASSERT_FALSE(short_seed.ok());
  EXPECT_EQ(short_seed.error().code, "robot.bad_state");
  const auto nan_goal = robots::solve_numeric(
      robot, tip, dofs, {{std::nan(""), 0, 0}, {}}, robots::neutral_state(robot), Seed(1));
  ASSERT_FALSE(nan_goal.ok());
  EXPECT_EQ(nan_goal.error().code, "robot.unreachable");
}

}  // namespace
}  // namespace marketgen
