// URDF: a small robot reads as it is written, and every fault is named with its line or part.
#include "robots/urdf.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

std::string link(const std::string& name, const std::string& mass = "1") {
  return "<link name=\"" + name + "\"><inertial><mass value=\"" + mass +
         "\"/><inertia ixx=\"0.1\" iyy=\"0.1\" izz=\"0.1\"/></inertial></link>\n";
}
std::string joint(const std::string& name, const std::string& parent, const std::string& child) {
  return "<joint name=\"" + name + "\" type=\"continuous\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/></joint>\n";
}
Result<robots::UrdfRobot> read(const std::string& body) {
  return robots::read_urdf("<robot name=\"r\">\n" + body + "</robot>", "r.urdf", ".");
}

void expect_fault(const std::string& body, const std::string& where, const std::string& message) {
  const auto result = read(body);
  ASSERT_FALSE(result.ok()) << message;
  EXPECT_EQ(result.error().code, "robot.bad_file");
  EXPECT_NE(result.error().where.find(where), std::string::npos) << to_string(result.error());
  EXPECT_NE(result.error().message.find(message), std::string::npos) << to_string(result.error());
}

TEST(Urdf, ReadsLinksJointsAndLimits) {
  const auto result =
      read(link("a") + link("b") +
           "<joint name=\"j\" type=\"prismatic\"><parent link=\"a\"/>"
           "<child link=\"b\"/><origin xyz=\"1 2 3\" rpy=\"0 0 1.5707963267948966\"/>"
           "<axis xyz=\"0 0 2\"/><limit lower=\"-1\" upper=\"2\" effort=\"5\" "
           "velocity=\"0\"/></joint>");
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  const robots::Robot& robot = result->robot;
  ASSERT_EQ(robot.dof_count(), 1U);
  const robots::Joint& slide = robot.joint_of_dof(0);
  EXPECT_EQ(slide.lower, -1);
  EXPECT_EQ(slide.effort, 5);
  EXPECT_EQ(slide.velocity, robots::Joint::unlimited);
  EXPECT_EQ(slide.axis, (Vec3{0, 0, 1}));
  const Pose b = robots::link_poses(robot, std::vector<double>{0.5})[1];
  EXPECT_NEAR(b.position.z, 3.5, 1e-12);
  EXPECT_NEAR(rotate(b.rotation, {1, 0, 0}).y, 1, 1e-12);
}

TEST(Urdf, ATurnedInertiaIsGivenInTheLinksAxes) {  // a rod along X, turned to lie along Y
  const auto result = read(
      "<link name=\"rod\"><inertial><origin rpy=\"0 0 1.5707963267948966\"/><mass value=\"1\"/>"
      "<inertia ixx=\"0.1\" iyy=\"0.5\" izz=\"0.5\"/></inertial></link>");
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_NEAR(result->robot.links[0].inertia.xx, 0.5, 1e-12);
  EXPECT_NEAR(result->robot.links[0].inertia.yy, 0.1, 1e-12);
}

TEST(Urdf, AMimicFollowsItsLeaderWithRatioAndOffset) {
  const auto slide = [](const std::string& name,
                        const std::string& child,
                        const std::string& mimic) {
    return "<joint name=\"" + name + "\" type=\"prismatic\"><parent link=\"a\"/><child link=\"" +
           child + "\"/><limit lower=\"-1\" upper=\"1\"/>" + mimic + "</joint>";
  };
  const std::string links = link("a") + link("b") + link("c") + link("d");
  const std::string follower =
      slide("k", "c", "<mimic joint=\"j\" multiplier=\"-2\" offset=\"0.1\"/>");
  const auto result = read(links + slide("j", "b", "") + follower + slide("l", "d", ""));
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  const std::vector<double> q = robots::with_followers(result->robot, {0.3, 0, 0.7});
  EXPECT_NEAR(q[1], -0.5, 1e-12);
  EXPECT_EQ(q[2], 0.7);
  expect_fault(links + slide("j", "b", "") + follower + slide("l", "d", "<mimic joint=\"k\"/>"),
               "joint \"l\"",
               "follows another");
}

TEST(Urdf, AMissingMeshIsAWarning) {
  const auto result = read(
      "<link name=\"a\"><visual><geometry><mesh filename=\"package://x/none.stl\"/>"
      "</geometry></visual></link>");
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  ASSERT_EQ(result->warnings.size(), 1U);
  EXPECT_NE(result->warnings[0].find("r.urdf:2"), std::string::npos);
}

TEST(Urdf, FaultsAreNamed) {
  expect_fault("<link name=\"a\"", "r.urdf:", "not XML");
  expect_fault("", "r.urdf", "no link");
  expect_fault(link("a", "-1"), "link \"a\"", "negative");
  expect_fault(link("a", "nan"), "r.urdf:2", "finite");
  expect_fault("<link name=\"a\"><inertial><mass value=\"1\"/></inertial></link>",
               "r.urdf:2",
               "no <inertia>");
  expect_fault(link("a") + link("a"), "link \"a\"", "two links");
  expect_fault(link("a") + link("b"), "link \"b\"", "one root");
  expect_fault(link("a") + joint("j", "a", "c"), "joint \"j\"", "no link \"c\"");
  expect_fault(
      link("a") + link("b") + joint("j", "a", "b") + joint("k", "b", "a"), "r.urdf", "cycle");
  expect_fault(link("r") + link("a") + link("b") + joint("j", "a", "b") + joint("k", "b", "a"),
               "link \"a\"",
               "cycle");
  expect_fault(link("a") + link("b") + link("c") + joint("j", "a", "c") + joint("k", "b", "c"),
               "joint \"k\"",
               "already has a parent");
  expect_fault(link("a") + link("b") +
                   "<joint name=\"j\" type=\"revolute\"><parent link=\"a\"/><child link=\"b\"/>"
                   "</joint>",
               "r.urdf:4",
               "no <limit>");
  expect_fault(link("a") + link("b") +
                   "<joint name=\"j\" type=\"floating\"><parent link=\"a\"/><child link=\"b\"/>"
                   "</joint>",
               "r.urdf:4",
               "not supported");
  expect_fault(
      "<link name=\"a\"><inertial><mass value=\"1\"/>"
      "<inertia ixx=\"1\" iyy=\"1\" izz=\"5\"/></inertial></link>",
      "link \"a\"",
      "no body has this inertia");
}

}  // namespace
}  // namespace marketgen
