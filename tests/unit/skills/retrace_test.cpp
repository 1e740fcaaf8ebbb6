// What executors do when a protective stop has broken off their motion.
#include "skills/retrace.h"

#include <gtest/gtest.h>

#include "skills/arm_executor.h"
#include "skills/body_executor.h"
#include "support/committed_robot.h"

namespace marketgen {
namespace {

agent::Observation observed(bool stopped) {
  agent::Observation now;
  now.stopped = stopped;
  return now;
}

TEST(Retrace, GoesBackTheLastSecondWithItsBaseTheOtherWay) {
  skills::Retrace retrace;
  retrace.start();
  for (int i = 0; i < 30; ++i) {
    EXPECT_FALSE(retrace.begins(observed(false)));
    retrace.tell({{1.0 * i}, 0.1 * i, -0.2});
  }
  EXPECT_FALSE(retrace.begins(observed(true)));
  EXPECT_FALSE(retrace.goes_back());
  ASSERT_TRUE(retrace.begins(observed(false)));
  for (int i = 29; i >= 10; --i) {
    ASSERT_TRUE(retrace.goes_back());
    const auto step = retrace.back();
    ASSERT_TRUE(step.has_value());
    EXPECT_EQ(step->position.front(), i);
    EXPECT_NEAR(step->drive_m_s, -0.1 * i, 1e-12);
    EXPECT_EQ(step->turn_rad_s, 0.2);
  }
  EXPECT_FALSE(retrace.back().has_value());
  EXPECT_FALSE(retrace.goes_back());
}

TEST(Retrace, AnArmThatWasStoppedGoesBackAndForgetsTheRest) {
  const robots::Robot robot = committed_robot("panda");
  skills::ArmExecutor arm = skills::ArmExecutor::make(robot).value();
  agent::Observation now;
  for (const int dof : robot.find_group("arm")->dofs)
    now.position.push_back(robots::with_posture(
        robot.postures.front(), robots::neutral_state(robot))[static_cast<std::size_t>(dof)]);
  now.openings_m = {0.04};
  arm.start(now);
  const Pose begin = arm.tip();
  Pose up = begin;
  up.position.z += 0.06;
  ASSERT_TRUE(arm.straight({}, up, 0.04, 20).ok());
  for (int i = 0; i < 8; ++i)
    arm.next(now);
  ASSERT_FALSE(arm.idle());
  now.stopped = true;
  const std::vector<double> held = arm.next(now).position;
  for (int i = 0; i < 10; ++i)
    EXPECT_EQ(arm.next(now).position, held) << "a stopped arm was told to go on";
  now.stopped = false;
  int steps = 0;
  for (arm.next(now); !arm.idle(); arm.next(now))
    ASSERT_LT(++steps, 10);
  EXPECT_TRUE(arm.take_stop());
  EXPECT_FALSE(arm.take_stop()) << "it says so twice";
  EXPECT_LT(length(arm.tip().position - begin.position), 0.005) << "it did not go back";
}

TEST(Retrace, ABodyThatWasStoppedDrivesBack) {
  const robots::Robot& robot = committed_robot("realman-rm75");
  const int lift = robot.find_dof("lift");
  skills::BodyExecutor body(robot, {lift});
  agent::Observation now;
  now.position = {0.3};
  now.openings_m = {0.06, 0.06};
  body.start(now);
  ASSERT_TRUE(body.drive_straight(1, 0.2).ok());
  double driven = 0;
  for (int i = 0; i < 12; ++i)
    driven += body.next(now).drive_m_s;
  EXPECT_GT(driven, 0);
  now.stopped = true;
  EXPECT_EQ(body.next(now).drive_m_s, 0);
  now.stopped = false;
  for (int i = 0; i < 20 && (i == 0 || !body.idle()); ++i)
    driven += body.next(now).drive_m_s;
  EXPECT_TRUE(body.idle());
  EXPECT_TRUE(body.take_stop());
  EXPECT_NEAR(driven, 0, 1e-9);
}

}  // namespace
}  // namespace marketgen
