// What executors do when a protective stop has broken off their motion.
#include "skills/retrace.h"

#include <gtest/gtest.h>

#include <array>

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

// An arm that has been told to go 6 cm up.
class RisingArm : public ::testing::Test {
 protected:
  RisingArm() {
    const std::vector<double> posture =
        robots::with_posture(robot_.postures.front(), robots::neutral_state(robot_));
    for (const int dof : robot_.find_group("arm")->dofs)
      now.position.push_back(posture[static_cast<std::size_t>(dof)]);
    now.openings_m = {0.04};
    now.external_force_n = {0};
    arm.start(now);
    begin = arm.tip();
    Pose up = begin;
    up.position.z += 0.06;
    arm.set_subtask(agent::Subtask::lift);
    EXPECT_TRUE(arm.straight({}, up, 0.04, 20).ok());
  }

  robots::Robot robot_ = committed_robot("panda");
  skills::ArmExecutor arm = skills::ArmExecutor::make(robot_).value();
  agent::Observation now;
  Pose begin;
};

TEST_F(RisingArm, ThatMeetsSomethingAtItsGuardGoesBackATenthOfASecond) {
  arm.guard(20);
  arm.wait(1, 0, 20);
  now.external_force_n = {19};
  std::vector<std::vector<double>> told;
  for (int i = 0; i < 8; ++i)
    told.push_back(arm.next(now).position);
  EXPECT_FALSE(arm.take_touch());
  now.external_force_n = {21};
  EXPECT_EQ(arm.next(now).position, told[7]);
  EXPECT_EQ(arm.next(now).position, told[6]);
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(arm.next(now).position, told[6]);
  EXPECT_TRUE(arm.idle()) << "what was queued behind goes on";
  EXPECT_FALSE(arm.take_stop());
  EXPECT_TRUE(arm.take_touch());
  EXPECT_FALSE(arm.take_touch()) << "it says so twice";
  EXPECT_LT(arm.tip().position.z, begin.position.z + 0.05);
}

TEST_F(RisingArm, WithoutAGuardGoesOn) {
  now.external_force_n = {99};
  while (!arm.idle())
    arm.next(now);
  EXPECT_FALSE(arm.take_touch());
  EXPECT_NEAR(arm.tip().position.z, begin.position.z + 0.06, 1e-3);
}

TEST_F(RisingArm, FeelsItsWayToWhatItReachesGuarded) {
  Pose up = begin;
  up.position.z += 0.06;
  skills::ReachRequest request{up, {0, 0, 0.04}, 0.04};
  std::array<int, 2> steps{};
  for (const bool guarded : {false, true}) {
    arm.start(now);
    request.max_force_n = guarded ? 20 : 0;
    ASSERT_TRUE(arm.reach({}, request, Seed(1)).ok());
    for (; !arm.idle(); arm.next(now))
      ++steps[guarded ? 1 : 0];
    EXPECT_FALSE(arm.take_touch());
    EXPECT_LT(length(arm.tip().position - up.position), 1e-3);
  }
  EXPECT_GT(steps[1], steps[0] + 5) << "its last stretch is no slower";
  arm.start(now);
  ASSERT_TRUE(arm.reach({}, request, Seed(1)).ok());
  arm.next(now);
  now.external_force_n = {99};
  while (!arm.idle())
    arm.next(now);
  EXPECT_TRUE(arm.take_touch());
}

TEST_F(RisingArm, ThatWasStoppedGoesBackAndForgetsTheRest) {
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

TEST_F(RisingArm, SaysWhatItsStepsAreFor) {
  arm.set_subtask(agent::Subtask::place);
  arm.wait(0.1, 0.04, 20);
  std::vector<agent::Subtask> said;
  const auto step = [&] {
    arm.next(now);
    if (said.empty() || said.back() != arm.subtask()) said.push_back(arm.subtask());
  };
  while (!arm.idle())
    step();
  step();
  using enum agent::Subtask;
  EXPECT_EQ(said, (std::vector{lift, place, none}));
  now.stopped = true;
  step();
  now.stopped = false;
  for (step(); !arm.idle();)
    step();
  step();
  EXPECT_EQ(said, (std::vector{lift, place, none, recover, none}));
}

TEST(Retrace, ABodyThatWasStoppedDrivesBack) {
  const robots::Robot& robot = committed_robot("realman-rm75");
  const int lift = robot.find_dof("lift");
  skills::BodyExecutor body(robot, {lift});
  agent::Observation now;
  now.position = {0.3};
  now.openings_m = {0.06, 0.06};
  body.start(now);
  body.set_subtask(agent::Subtask::drive);
  ASSERT_TRUE(body.drive_straight(1, 0.2).ok());
  double driven = 0;
  for (int i = 0; i < 12; ++i)
    driven += body.next(now).drive_m_s;
  EXPECT_GT(driven, 0);
  agent::Action action = body.next(now);
  EXPECT_EQ(body.subtask(), agent::Subtask::drive);
  driven += action.drive_m_s;
  now.stopped = true;
  action = body.next(now);
  EXPECT_EQ(action.drive_m_s, 0);
  EXPECT_EQ(body.subtask(), agent::Subtask::recover);
  now.stopped = false;
  for (int i = 0; i < 20 && (i == 0 || !body.idle()); ++i) {
    action = body.next(now);
    driven += action.drive_m_s;
    EXPECT_EQ(body.subtask(), agent::Subtask::recover);
  }
  EXPECT_TRUE(body.idle());
  EXPECT_TRUE(body.take_stop());
  EXPECT_NEAR(driven, 0, 1e-9);
}

// An arm of a body on its way, and what it does when so much presses on one of its arms.
TEST(BodyExecutor, AWayThatIsFeltEndsAtAContactAndWhatIsBehindItGoesOn) {
  const robots::Robot& robot = committed_robot("realman-rm75");
  const std::vector<int>& arm = robot.find_group("left_arm")->dofs;
  const motion::Configuration from(arm.size(), 0.0), to(arm.size(), 0.2);
  const std::vector<motion::MotionLimits> limits(arm.size(), {0.4, 1, 10});
  const auto way = motion::timed_path({from, to}, limits);
  ASSERT_TRUE(way.ok());
  ASSERT_EQ(robot.contact_limits.size(), 2U);
  skills::BodyExecutor body(robot, arm);
  agent::Observation now;
  now.position = from;
  now.openings_m = {0.06, 0.06};
  // Which of the two readings is the left arm's, the body finds by the limits' links.
  std::array<double, 2> shares{};
  for (std::size_t pressed : {0U, 1U}) {
    now.external_force_n = {0, 0};
    body.start(now);
    body.feel(arm, *way, 20);
    body.grip(0, {0.08});
    body.wait(0.1);
    agent::Action action;
    for (int i = 0; i < 4; ++i)
      action = body.next(now);
    const std::vector<double> there = action.position;
    now.external_force_n[pressed] = 21;
    action = body.next(now);
    const bool ended = action.position == there;
    now.external_force_n = {0, 0};
    while (!body.idle())
      action = body.next(now);
    EXPECT_EQ(action.tools.front().opening_m, 0.08) << "what was queued behind is forgotten";
    EXPECT_FALSE(body.take_stop());
    shares[pressed] = body.felt_share();
    EXPECT_EQ(action.position == to, !ended);
    if (ended) {
      EXPECT_EQ(action.position, there) << "it went on";
      EXPECT_NEAR(shares[pressed], 0.2 / way->duration_s(), 1e-9);
    } else {
      EXPECT_EQ(shares[pressed], 1);
    }
  }
  EXPECT_NE(shares[0], shares[1]) << "one of the arms is the one that moves";
}

}  // namespace
}  // namespace marketgen
