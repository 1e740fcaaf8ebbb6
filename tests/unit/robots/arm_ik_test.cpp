// Analytic inverse kinematics: forward kinematics of every solution gives the pose back, the joint
// values that made the pose are among the solutions, and unreachable poses say so.
#include "robots/arm_ik.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/seed.h"
#include "support/committed_robot.h"

namespace marketgen {
namespace {

struct Arm {
  robots::Robot robot;
  robots::ArmIk ik;
};

Arm arm_of(const std::string& id) {
  Arm arm{committed_robot(id), {}};
  if (arm.robot.links.empty()) return arm;
  const auto ik = robots::make_arm_ik(arm.robot, *arm.robot.find_group("arm"));
  EXPECT_TRUE(ik.ok()) << (ik.ok() ? "" : to_string(ik.error()));
  if (ik.ok()) arm.ik = *ik;
  return arm;
}

Pose tip_at(const Arm& arm, const robots::ArmJoints& q) {
  std::vector<double> state = robots::neutral_state(arm.robot);
  for (std::size_t i = 0; i < static_cast<std::size_t>(arm.ik.joints); ++i)
    state[i] = q[i];
  return robots::frame_pose(arm.robot, state, arm.robot.find_group("arm")->tip);
}

double angle_between(double a, double b) {
  return std::abs(std::remainder(a - b, 2 * std::numbers::pi));
}

robots::ArmJoints random_joints(const robots::ArmIk& ik, Stream& draw) {
  robots::ArmJoints q{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(ik.joints); ++i)
    q[i] = draw.uniform(ik.lower[i], ik.upper_limit[i]);
  return q;
}

void expect_round_trips(const std::string& id, int poses) {
  const Arm arm = arm_of(id);
  ASSERT_GT(arm.robot.dof_count(), 0U);
  Stream draw = Seed(1).child("arm_ik", id).stream();
  double worst = 0;
  int reached = 0, found_again = 0;
  for (int i = 0; i < poses; ++i) {
    const robots::ArmJoints q = random_joints(arm.ik, draw);
    const Pose pose = tip_at(arm, q);
    const double redundancy =
        arm.ik.family == robots::ArmFamily::panda ? q[6] : draw.uniform(-3, 3);
    bool same = false;
    const auto solutions = robots::solve_arm(arm.ik, pose, redundancy);
    for (const robots::ArmJoints& s : solutions) {
      worst = std::max(worst, largest_difference(tip_at(arm, s), pose));
      double off = 0;
      for (std::size_t k = 0; k < static_cast<std::size_t>(arm.ik.joints); ++k)
        off = std::max(off, angle_between(s[k], q[k]));
      same = same || off < 1e-6;
    }
    reached += solutions.empty() ? 0 : 1;
    found_again += same ? 1 : 0;
  }
  EXPECT_LT(worst, 1e-9);
  if (arm.ik.family == robots::ArmFamily::rm75) {  // another swivel than the one that made the pose
    EXPECT_GT(reached, poses / 4);
  } else {
    EXPECT_EQ(found_again, poses);
  }
}

TEST(ArmIk, Rm65RoundTrips) {
  expect_round_trips("rm65-b-v", 5000);
}
TEST(ArmIk, Rm75RoundTrips) {
  expect_round_trips("rm75-b", 5000);
}
TEST(ArmIk, PandaRoundTrips) {
  expect_round_trips("panda", 5000);
}

TEST(ArmIk, SevenJointArmsFindRandomPosesAgainBySweeping) {
  for (const char* id : {"rm75-b", "panda"}) {
    const Arm arm = arm_of(id);
    Stream draw = Seed(2).child("sweep", id).stream();
    int reached = 0;
    for (int i = 0; i < 300; ++i) {
      const robots::ArmJoints q = random_joints(arm.ik, draw);
      const auto found = robots::nearest_arm_solution(arm.ik, tip_at(arm, q), q);
      reached += found.ok() ? 1 : 0;
      if (found.ok()) {
        EXPECT_LT(largest_difference(tip_at(arm, *found), tip_at(arm, q)), 1e-9);
      }
    }
    EXPECT_EQ(reached, 300) << id;
  }
}

TEST(ArmIk, SolutionsStayWithinTheLimits) {
  const Arm arm = arm_of("rm65-b-v");
  const auto solutions = robots::solve_arm(arm.ik, tip_at(arm, {0.3, -0.5, 1.2, 0.4, 0.9, 1.0}), 0);
  EXPECT_GE(solutions.size(), 4U);  // joint 6 alone gives two turns of each
  for (const robots::ArmJoints& q : solutions) {
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_GE(q[i], arm.ik.lower[i]);
      EXPECT_LE(q[i], arm.ik.upper_limit[i]);
    }
  }
}

// The seed's own redundancy is tried first: its own pose gives the seed back.
TEST(ArmIk, TheNearestSolutionToAPosturesOwnPoseIsThePosture) {
  for (const char* id : {"rm65-b-v", "rm75-b", "panda"}) {
    const Arm arm = arm_of(id);
    Stream draw = Seed(4).child("own", id).stream();
    for (int i = 0; i < 200; ++i) {
      const robots::ArmJoints q = random_joints(arm.ik, draw);
      const auto found = robots::nearest_arm_solution(arm.ik, tip_at(arm, q), q);
      ASSERT_TRUE(found.ok()) << id;
      for (std::size_t k = 0; k < 7; ++k)
        EXPECT_NEAR((*found)[k], q[k], 1e-6) << id << " joint " << k;
    }
  }
}

TEST(ArmIk, AnArmOfAnotherBuildIsRefused) {  // a Panda with its elbow 10 mm out of the plane
  Arm arm = arm_of("panda");
  arm.robot.joints[3].parent_from_joint.position.y += 0.01;
  const auto ik = robots::make_arm_ik(arm.robot, *arm.robot.find_group("arm"));
  ASSERT_FALSE(ik.ok());
  EXPECT_EQ(ik.error().code, "robot.unknown");
  EXPECT_NE(ik.error().message.find("laid out"), std::string::npos);
}

TEST(ArmIk, ATipOnTheBaseIsRefused) {
  Arm arm = arm_of("rm65-b-v");
  arm.robot.frames.push_back({"bolted", 0, {}});
  robots::JointGroup group = *arm.robot.find_group("arm");
  group.tip = arm.robot.find_frame("bolted");
  EXPECT_FALSE(robots::make_arm_ik(arm.robot, group).ok());
}

TEST(ArmIk, FarAwayPosesAreUnreachable) {
  for (const char* id : {"rm65-b-v", "rm75-b", "panda"}) {
    const Arm arm = arm_of(id);
    const auto found = robots::nearest_arm_solution(arm.ik, {{1.5, 0, 0.5}, {}}, {});
    ASSERT_FALSE(found.ok());
    EXPECT_EQ(found.error().code, "robot.unreachable");
    EXPECT_NE(found.error().message.find("1.500"), std::string::npos);
  }
}

}  // namespace
}  // namespace marketgen
