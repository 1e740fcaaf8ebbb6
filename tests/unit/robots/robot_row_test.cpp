// The robots' rows: they load, their joints stand where the published tables put them, and their
// limits are the published ones.
#include "robots/robot_row.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "support/committed_robot.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

constexpr double degree = std::numbers::pi / 180;

void expect_near(Vec3 a, Vec3 b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(RobotRows, EveryRowLoads) {
  const auto ids = robots::robot_ids(committed_rows);
  ASSERT_TRUE(ids.ok());
  EXPECT_EQ(ids->size(), 11U);
  for (const std::string& id : *ids)
    EXPECT_FALSE(committed_robot(id).links.empty()) << id;
}

// q = 0: the arm stands straight up, the flange 88 mm ahead and hanging down; published table.
TEST(RobotRows, PandaAtZeroIsWhereItsTableSays) {
  const robots::Robot panda = committed_robot("panda");
  ASSERT_EQ(panda.dof_count(), 9U);
  const Pose flange = robots::frame_pose(panda, std::vector<double>(9), panda.find_frame("flange"));
  expect_near(flange.position, {0.088, 0, 0.333 + 0.316 + 0.384 - 0.107}, 1e-12);
  expect_near(rotate(flange.rotation, {0, 0, 1}), {0, 0, -1}, 1e-12);
  const Pose tcp = robots::frame_pose(panda, std::vector<double>(9), panda.find_frame("tcp"));
  expect_near(tcp.position, {0.088, 0, 0.926 - 0.1034}, 1e-12);
}

TEST(RobotRows, PandaHasThePublishedLimitsAndMasses) {
  const robots::Robot panda = committed_robot("panda");
  const robots::Joint& fourth = panda.joint_of_dof(3);
  EXPECT_EQ(fourth.lower, -3.0718);
  EXPECT_EQ(fourth.upper, -0.0698);
  EXPECT_EQ(fourth.acceleration, 12.5);
  EXPECT_EQ(fourth.jerk, 6250);
  EXPECT_EQ(fourth.effort, 87);
  double arm = 0;
  for (int k = 1; k <= 7; ++k)
    arm += panda.links[static_cast<std::size_t>(panda.find_link("link" + std::to_string(k)))].mass;
  EXPECT_NEAR(arm, 4.971 + .647 + 3.229 + 3.588 + 1.226 + 1.667 + .736, 0.003);
}

// RM65 straight up: 240.5 + 256 + 210 + 166.8 mm; RM75: 240.5 + 256 + 210 + 144 mm.
TEST(RobotRows, RealmanArmsStandStraightAtZero) {
  const robots::Robot six = committed_robot("rm65-b-v");
  const Pose top = robots::frame_pose(six, std::vector<double>(6), six.find_frame("flange"));
  expect_near(top.position, {0, 0, 0.8733}, 1e-12);
  const robots::Robot seven = committed_robot("rm75-b");
  const Pose tip = robots::frame_pose(seven, std::vector<double>(7), seven.find_frame("flange"));
  expect_near(tip.position, {0, 0, 0.8505}, 1e-12);
  EXPECT_NEAR(seven.joint_of_dof(3).upper, 135 * degree, 1e-15);
  EXPECT_NEAR(six.joint_of_dof(5).lower, -360 * degree, 1e-15);
}

TEST(RobotRows, DualArmShouldersAreWhereTheDataSheetPutsThem) {
  const robots::Robot robot = committed_robot("realman-rm65");
  std::vector<double> q(robot.dof_count());
  q[static_cast<std::size_t>(robot.find_dof("lift"))] = 0.4;
  const std::vector<Pose> poses = robots::link_poses(robot, q);
  const auto at = [&](const char* link) {
    return poses[static_cast<std::size_t>(robot.find_link(link))];
  };
  expect_near(at("left_link1").position, {0.223, 0.222, 1.13}, 1e-6);
  expect_near(at("right_link1").position, {0.223, -0.222, 1.13}, 1e-6);
  expect_near(at("head").position, {0.14, 0, 1.70}, 1e-12);  // the head does not ride the lift
}

TEST(RobotRows, DualArmWeighsWhatTheDataSheetSays) {  // 157 kg, arms but no tools
  for (const char* id : {"realman-rm65"}) {
    const robots::Robot robot = committed_robot(id);
    double mass = 0;
    for (const robots::Link& link : robot.links) {
      if (link.name.find("tool") == std::string::npos) mass += link.mass;
    }
    EXPECT_NEAR(mass, 157, 0.05);
  }
}

TEST(RobotRows, AToolMovesTheTipOfItsArm) {
  const robots::Robot robot = committed_robot("realman-rm75", {{"left_tool", "suction-cup"}});
  const robots::JointGroup* left = robot.find_group("left_arm");
  ASSERT_NE(left, nullptr);
  EXPECT_EQ(left->dofs.size(), 7U);
  EXPECT_EQ(left->tip, robot.find_frame("left_tool_tcp"));
  ASSERT_EQ(robot.tools.size(), 2U);
  EXPECT_EQ(robot.tools[0].kind, robots::ToolKind::suction);
  EXPECT_EQ(robot.tools[1].kind, robots::ToolKind::gripper);
  EXPECT_EQ(robot.find_dof("left_tool_finger_joint1"), -1);
  EXPECT_GE(robot.find_dof("right_tool_finger_joint1"), 0);
}

TEST(RobotRows, UnknownNamesAreErrorsThatListTheKnownOnes) {
  const auto robot = robots::load_robot(committed_rows, "pandas");
  ASSERT_FALSE(robot.ok());
  EXPECT_EQ(robot.error().code, "robot.unknown");
  EXPECT_NE(robot.error().message.find("panda-hand"), std::string::npos);
  const auto slot =
      robots::load_robot(committed_rows, "realman-rm65", {{"third_tool", "suction-cup"}});
  ASSERT_FALSE(slot.ok());
  EXPECT_NE(slot.error().message.find("left_tool"), std::string::npos);
}

// A row of one's own lies anywhere, and carries rows of ours.
TEST(RobotRows, AFileOfOnesOwnIsARowToo) {
  const ScratchFolder scratch;
  const std::filesystem::path cart = scratch.path() / "cart.json";
  std::ofstream(cart) << R"({"schema": "market-robot/1", "id": "cart", "name": "Cart",
      "links": [{"name": "deck", "mass": 20, "inertia": {"xx": 1, "yy": 1, "zz": 1}}],
      "frames": [{"name": "top", "link": "deck", "xyz": [0, 0, 0.4]}],
      "parts": [{"row": "panda", "at": "top"}]})";
  const auto robot = robots::load_robot(committed_rows, cart.string());
  ASSERT_TRUE(robot.ok()) << to_string(robot.error());
  EXPECT_EQ(robot->name, "cart");
  EXPECT_GE(robot->find_dof("joint7"), 0);
  std::filesystem::rename(cart, scratch.path() / "car.json");
  const auto renamed = robots::load_robot(committed_rows, (scratch.path() / "car.json").string());
  ASSERT_FALSE(renamed.ok());
  EXPECT_EQ(renamed.error().code, "robot.bad_file");
  EXPECT_FALSE(robots::load_robot(committed_rows, cart.string()).ok());
}

TEST(RobotRows, SpheresCoverEveryCapsule) {  // points on each capsule's surface lie in some sphere
  const robots::Robot robot = committed_robot("realman-rm65");
  for (const robots::Link& link : robot.links) {
    for (const robots::Capsule& c : link.capsules) {
      for (int i = 0; i <= 20; ++i) {
        const Vec3 on_axis = c.a + (c.b - c.a) * (i / 20.0);
        for (const Vec3 out : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}}) {
          const Vec3 along = normalized(c.b - c.a);
          const Vec3 across = normalized(out - along * dot(out, along));
          const Vec3 p = on_axis + across * c.radius;
          bool covered = false;
          for (const robots::Sphere& s : link.spheres)
            covered = covered || length(p - s.center) <= s.radius + 1e-9;
          EXPECT_TRUE(covered) << link.name;
        }
      }
    }
  }
}

TEST(RobotStates, BadStatesAreNamed) {
  const robots::Robot panda = committed_robot("panda");
  std::vector<double> q = robots::neutral_state(panda);
  EXPECT_TRUE(robots::check_state(panda, q).ok());
  EXPECT_EQ(q[3], -0.0698);
  q[2] = std::nan("");
  ASSERT_FALSE(robots::check_state(panda, q).ok());
  EXPECT_EQ(robots::check_state(panda, q).error().where, "panda:joint3");
  q[2] = 3;
  EXPECT_EQ(robots::check_state(panda, q).error().code, "robot.bad_state");
  q.pop_back();
  EXPECT_FALSE(robots::check_state(panda, q).ok());
}

}  // namespace
}  // namespace marketgen
