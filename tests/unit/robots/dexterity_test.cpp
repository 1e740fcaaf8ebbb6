// How well a tool can be moved from a posture: not at all one way with the wrist or the elbow
// stretched, freely with both bent.
#include "robots/dexterity.h"

#include <gtest/gtest.h>

#include "support/committed_robot.h"

namespace marketgen {
namespace {

class LeftArm : public testing::Test {
 protected:
  double gain_at(std::initializer_list<double> q) const {
    return robots::min_gain(robot_, state(q), arm_.tip, arm_.dofs);
  }
  std::vector<double> state(std::initializer_list<double> q) const {
    std::vector<double> made = robots::neutral_state(robot_);
    std::size_t j = 0;
    for (const double value : q)
      made[static_cast<std::size_t>(arm_.dofs[j++])] = value;
    return made;
  }
  robots::Robot robot_ = committed_robot("realman-rm75");
  robots::JointGroup arm_ = *robot_.find_group("left_arm");
};

TEST_F(LeftArm, AStretchedArmCannotMoveAlongItself) {
  EXPECT_LT(gain_at({0, 0, 0, 0, 0, 0, 0}), 1e-6);
  EXPECT_LT(gain_at({0.3, 0.8, 0.2, 0, 0.4, 0.9, 0.1}), 1e-6) << "its elbow alone";
}

TEST_F(LeftArm, ABentOneMovesEveryWay) {
  EXPECT_GT(gain_at({0.3, 0.8, 0.2, 1.4, 0.4, 0.9, 0.1}), 0.05);
}

TEST_F(LeftArm, TheNearestLimitCounts) {
  const auto dof = static_cast<std::size_t>(arm_.dofs[3]);
  const robots::Joint& elbow = robot_.joint_of_dof(dof);
  std::vector<double> q = state({0.3, 0.8, 0.2, 1.4, 0.4, 0.9, 0.1});
  q[dof] = elbow.upper - 0.1;
  EXPECT_NEAR(robots::min_room(robot_, q, arm_.dofs), 0.1, 1e-12);
  q[dof] = elbow.upper + 0.2;
  EXPECT_NEAR(robots::min_room(robot_, q, arm_.dofs), -0.2, 1e-12);
}

}  // namespace
}  // namespace marketgen
