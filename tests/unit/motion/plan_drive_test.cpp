// The room that a robot takes as it drives.
#include "motion/plan_drive.h"

#include <gtest/gtest.h>

#include "support/committed_robot.h"

namespace marketgen {
namespace {

std::vector<double> stowed(const robots::Robot& robot) {
  return robots::with_followers(
      robot, robots::with_posture(*robot.find_posture("stow"), robots::neutral_state(robot)));
}

std::vector<double> with_lift(const robots::Robot& robot, std::vector<double> state, double lift) {
  state[static_cast<std::size_t>(robot.find_dof("lift"))] = lift;
  return state;
}

TEST(PlanDrive, TheEnvelopeFollowsLiftAndArmsAndNotTheBase) {
  const robots::Robot& robot = committed_robot("realman-rm75");
  const std::vector<double> stow = stowed(robot);
  const motion::BaseEnvelope low =
      motion::base_envelope(robot, with_lift(robot, stow, 0.0)).value();
  const motion::BaseEnvelope high =
      motion::base_envelope(robot, with_lift(robot, stow, 0.9)).value();
  EXPECT_GT(low.radius_m, 0.3);                   // the platform is 0.64 m long
  EXPECT_LT(low.radius_m, 0.6);                   // arms within, as the probe found
  EXPECT_NEAR(low.height_m, 1.78, 0.02);          // the data sheet's height: its mast
  EXPECT_GT(high.height_m, low.height_m + 0.05);  // the arms over it
  std::vector<double> driven = stow;
  driven[static_cast<std::size_t>(robot.find_dof("base_x"))] = 5;
  driven[static_cast<std::size_t>(robot.find_dof("base_yaw"))] = 1;
  EXPECT_NEAR(motion::base_envelope(robot, driven)->radius_m, low.radius_m, 1e-9);
  const motion::BaseEnvelope reaching =
      motion::base_envelope(robot, robots::neutral_state(robot)).value();
  EXPECT_NE(reaching.radius_m, low.radius_m);
}

}  // namespace
}  // namespace marketgen
