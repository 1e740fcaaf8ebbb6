// Capsules: their distances agree with dense sampling, they hold what the links look like, and they
// tell a free posture from a folded one.
#include "robots/self_collision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/seed.h"
#include "robots/numeric_ik.h"
#include "support/committed_robot.h"

namespace marketgen {
namespace {

Vec3 random_point(Stream& draw) {
  return {draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-1, 1)};
}

double sampled_distance(const robots::Capsule& a, const robots::Capsule& b, int steps) {
  double least = HUGE_VAL;
  for (int i = 0; i <= steps; ++i) {
    const Vec3 p = a.a + (a.b - a.a) * (static_cast<double>(i) / steps);
    for (int k = 0; k <= steps; ++k)
      least = std::min(least, length(p - b.a - (b.b - b.a) * (static_cast<double>(k) / steps)));
  }
  return least - a.radius - b.radius;
}

TEST(SelfCollision, CapsuleDistancesAgreeWithDenseSampling) {
  Stream draw = Seed(8).child("capsules").stream();
  for (int i = 0; i < 300; ++i) {
    robots::Capsule a{random_point(draw), random_point(draw), 0.1};
    robots::Capsule b{random_point(draw), random_point(draw), 0.2};
    if (i % 10 == 1) a.b = a.a;                         // a ball
    if (i % 10 == 2) b.b = b.a, a.b = a.a;              // two balls
    if (i % 10 == 3) b.b = b.a + (a.b - a.a);           // parallel
    if (i % 10 == 4) b.a = a.a, b.b = a.a * 2.0 - a.b;  // end to end in one line
    const double sampled = sampled_distance(a, b, 200);
    const double own = robots::distance_between(a, b);
    EXPECT_LE(own, sampled + 1e-12);
    EXPECT_GE(own, sampled - 0.02);  // half a step along each
    EXPECT_NEAR(own, robots::distance_between(b, a), 1e-12);
  }
}

bool touches(const robots::Robot& robot, const std::vector<double>& q) {
  return robots::first_contact(
             robot, robots::link_poses(robot, q), robots::pairs_that_may_touch(robot))
      .has_value();
}
std::string name_of_contact(const robots::Robot& robot, const std::vector<double>& q) {
  const auto pair = robots::first_contact(
      robot, robots::link_poses(robot, q), robots::pairs_that_may_touch(robot));
  if (!pair) return "none";
  return robot.links[static_cast<std::size_t>(pair->a)].name + " " +
         robot.links[static_cast<std::size_t>(pair->b)].name;
}

TEST(SelfCollision, ThePandasReadyPostureIsFreeAndAFoldedOneIsNot) {
  const robots::Robot panda = committed_robot("panda");
  ASSERT_NE(panda.find_posture("ready"), nullptr);
  std::vector<double> q =
      robots::with_posture(*panda.find_posture("ready"), robots::neutral_state(panda));
  EXPECT_EQ(name_of_contact(panda, q), "none");
  q[1] = -1.7, q[3] = -3.05, q[5] = 0.5;  // the hand drawn back into the shoulder
  EXPECT_TRUE(robots::within_limits(panda, q));
  EXPECT_TRUE(touches(panda, q));
}

TEST(SelfCollision, TheStowedDualArmIsFreeAtEveryLift) {
  for (const char* id : {"realman-rm65", "realman-rm75"}) {
    const robots::Robot robot = committed_robot(id);
    ASSERT_NE(robot.find_posture("stow"), nullptr);
    std::vector<double> q =
        robots::with_posture(*robot.find_posture("stow"), robots::neutral_state(robot));
    for (int i = 0; i <= 9; ++i) {
      q[static_cast<std::size_t>(robot.find_dof("lift"))] = 0.1 * i;
      EXPECT_EQ(name_of_contact(robot, q), "none") << id << " at lift " << 0.1 * i;
    }
  }
}

TEST(SelfCollision, ArmsThatReachForOnePointTouchAndArmsApartDoNot) {
  const robots::Robot robot = committed_robot("realman-rm65");
  const Quaternion ahead = rotation_about({0, 1, 0}, std::numbers::pi / 2);  // tool along X
  const auto both_at = [&](double left_y, double right_y) {
    std::vector<double> q =
        robots::with_posture(*robot.find_posture("stow"), robots::neutral_state(robot));
    q[static_cast<std::size_t>(robot.find_dof("lift"))] = 0.4;
    for (const auto& [name, y] : {std::pair{"left_arm", left_y}, std::pair{"right_arm", right_y}}) {
      const robots::JointGroup& arm = *robot.find_group(name);
      const auto solved =
          robots::solve_numeric(robot, arm.tip, arm.dofs, {{0.85, y, 1.1}, ahead}, q, Seed(1));
      EXPECT_TRUE(solved.ok()) << (solved.ok() ? "" : to_string(solved.error()));
      if (solved.ok()) q = *solved;
    }
    return q;
  };
  EXPECT_TRUE(touches(robot, both_at(0, 0)));
  EXPECT_EQ(name_of_contact(robot, both_at(0.3, -0.3)), "none");
}

TEST(SelfCollision, NeighboursFingersAndBoltedLinksAreNoPairs) {
  const robots::Robot panda = committed_robot("panda");
  for (const robots::LinkPair& pair : robots::pairs_that_may_touch(panda)) {
    const std::string names = panda.links[static_cast<std::size_t>(pair.a)].name + " " +
                              panda.links[static_cast<std::size_t>(pair.b)].name;
    EXPECT_NE(names, "link3 link4");
    EXPECT_NE(names, "link7 hand");
    EXPECT_NE(names, "link6 hand");  // one joint between them
    EXPECT_NE(names, "finger_left finger_right");
  }
}

}  // namespace
}  // namespace marketgen
