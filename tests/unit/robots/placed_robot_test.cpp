// Robots as people write them: what the text means, and what each fault is told.
#include "robots/placed_robot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/committed_robot.h"

namespace marketgen {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

Result<robots::PlacedRobot> placed(const std::string& text) {
  MARKETGEN_TRY(const robots::RobotSpec spec, robots::parse_robot_spec(text, "--robot " + text));
  return robots::place_robot(committed_rows, spec, "--robot " + text);
}

double value_of(const robots::PlacedRobot& placed, const char* joint) {
  return placed.q[static_cast<std::size_t>(placed.robot.find_dof(joint))];
}

TEST(PlacedRobots, PlaceHeadingAndHeightArePoseOfTheBase) {
  const auto robot = placed("panda@4.2,3.1,90,z=0.9");
  ASSERT_TRUE(robot.ok()) << to_string(robot.error());
  const Vec3 at = robot->world_from_base.position;
  EXPECT_EQ(at.x, 4.2);
  EXPECT_EQ(at.y, 3.1);
  EXPECT_EQ(at.z, 0.9);
  const Vec3 ahead = rotate(robot->world_from_base.rotation, {1, 0, 0});
  EXPECT_NEAR(ahead.x, 0, 1e-12);
  EXPECT_NEAR(ahead.y, 1, 1e-12);  // 90 degrees look north
}

TEST(PlacedRobots, WithoutAPostureTheRowsFirstCounts) {
  const auto robot = placed("panda@1,2");
  ASSERT_TRUE(robot.ok()) << to_string(robot.error());
  EXPECT_NEAR(value_of(*robot, "joint6"), right_angle, 1e-12);  // "ready"
  EXPECT_EQ(yaw_of(robot->world_from_base.rotation), 0);
  const auto arm = placed("rm65-b-v@1,2");  // has none
  ASSERT_TRUE(arm.ok()) << to_string(arm.error());
  for (const double q : arm->q)
    EXPECT_EQ(q, 0);
}

TEST(PlacedRobots, JointsGoOverThePostureAndFollowersFollow) {
  const auto robot =
      placed("realman-rm65@1,2,-30,posture=stow,lift=0.3,left_joint1=45deg,right_joint1=-1.5");
  ASSERT_TRUE(robot.ok()) << to_string(robot.error());
  EXPECT_EQ(value_of(*robot, "lift"), 0.3);
  EXPECT_NEAR(value_of(*robot, "left_joint1"), right_angle / 2, 1e-12);
  EXPECT_EQ(value_of(*robot, "right_joint1"), -1.5);
  EXPECT_NEAR(value_of(*robot, "right_joint2"), 49 * right_angle / 90, 1e-12);  // of "stow"
  const auto open = placed("panda@1,2,finger_joint1=0.04");
  ASSERT_TRUE(open.ok()) << to_string(open.error());
  EXPECT_EQ(value_of(*open, "finger_joint2"), 0.04);
}

TEST(PlacedRobots, ToolsTakeTheirSlots) {
  const auto robot = placed("realman-rm75@1,2,left_tool=suction-cup");
  ASSERT_TRUE(robot.ok()) << to_string(robot.error());
  EXPECT_EQ(robot->robot.tools[0].kind, robots::ToolKind::suction);
  EXPECT_EQ(robot->robot.tools[1].kind, robots::ToolKind::gripper);
}

TEST(PlacedRobots, TheStandCarriesThePandaAtItsHeadPlate) {
  const auto robot = placed("panda-on-stand@1,2");
  ASSERT_TRUE(robot.ok()) << to_string(robot.error());
  const std::vector<Pose> base_from_link = robots::link_poses(robot->robot, robot->q);
  const auto foot = static_cast<std::size_t>(robot->robot.find_link("link0"));
  EXPECT_NEAR(base_from_link[foot].position.z, 0.72, 1e-12);
  EXPECT_NEAR(value_of(*robot, "joint6"), right_angle, 1e-12);
}

struct Fault {
  const char *text, *code, *says;
};

class FaultySpecs : public testing::TestWithParam<Fault> {};

TEST_P(FaultySpecs, AreNamed) {
  const auto robot = placed(GetParam().text);
  ASSERT_FALSE(robot.ok()) << GetParam().text;
  EXPECT_EQ(robot.error().code, GetParam().code) << to_string(robot.error());
  EXPECT_NE(robot.error().message.find(GetParam().says), std::string::npos)
      << to_string(robot.error());
  EXPECT_EQ(robot.error().where, std::string("--robot ") + GetParam().text);
}

INSTANTIATE_TEST_SUITE_P(
    All,
    FaultySpecs,
    testing::Values(
        Fault{"", "robot.bad_spec", "no robot and place"},
        Fault{"panda", "robot.bad_spec", "no robot and place"},
        Fault{"@1,2", "robot.bad_spec", "no robot and place"},
        Fault{"panda@", "robot.bad_spec", "neither a number nor KEY=VALUE"},
        Fault{"panda@1", "robot.bad_spec", "got 1 number;"},
        Fault{"panda@1,2,3,4", "robot.bad_spec", "got 4 numbers"},
        Fault{"panda@1,nan", "robot.bad_spec", "\"nan\" is neither"},
        Fault{"panda@1,2,z=inf", "robot.bad_spec", "no height in metres"},
        Fault{"panda@1,2,north", "robot.bad_spec", "\"north\" is neither"},
        Fault{"panda@1,z=0.9,2", "robot.bad_spec", "place and heading come first"},
        Fault{"panda@1,2,posture=", "robot.bad_spec", "lacks a name or a value"},
        Fault{"panda@1,2,z=0,z=1", "robot.bad_spec", "given twice"},
        Fault{"pnada@1,2", "robot.unknown", "did you mean \"panda\"?"},
        Fault{"spot@1,2", "robot.unknown", "known are: panda, panda-hand"},
        Fault{"panda@1,2,posture=redy", "robot.unknown", "did you mean \"ready\"?"},
        Fault{"panda@1,2,posture=stow", "robot.unknown", "known are: ready"},
        Fault{"rm65-b-v@1,2,posture=stow", "robot.unknown", "it has none"},
        Fault{"panda@1,2,jont4=-1", "robot.unknown", "did you mean \"joint4\"?"},
        Fault{"panda@1,2,gripper=suction-cup", "robot.unknown", "it has: tool"},
        Fault{"panda@1,2,tool=suction-cap", "robot.unknown", "did you mean \"suction-cup\"?"},
        Fault{"panda@1,2,joint4=0.5", "robot.bad_state", "joint \"joint4\" goes from -176 to -4"},
        Fault{"realman-rm65@1,2,lift=1.2", "robot.bad_state", "from 0 to 0.9 m; 1.2 m is outside"},
        Fault{"realman-rm65@1,2,lift=20deg", "robot.bad_state", "give metres, not degrees"},
        Fault{"panda@1,2,finger_joint2=0.01", "robot.bad_state", "copies \"finger_joint1\""}));

}  // namespace
}  // namespace marketgen
