// The Panda's capsules hold the shapes that Franka publishes for it:
// frankaemika/franka_description, robots/common/franka_arm.xacro and
// end_effectors/common/franka_hand.xacro. Planning (its spheres cover the capsules) and physics
// (its geoms are the capsules) follow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "robots/self_collision.h"
#include "support/committed_robot.h"
#include "support/outside_of_link.h"

namespace marketgen {
namespace {

struct PublishedCapsule {
  const char* link;
  robots::Capsule shape;  // link frame
};

constexpr double half_root = 0.70710678118654752;  // link7's are published turned by 45 degrees
// Metres. Left out: the hand's second capsule, which is the room that its fingers sweep.
const std::vector<PublishedCapsule> published{
    {"link0", {{-0.09, 0, 0.06}, {-0.06, 0, 0.06}, 0.06}},
    {"link1", {{0, 0, -0.333}, {0, 0, -0.05}, 0.06}},
    {"link2", {{0, 0, -0.06}, {0, 0, 0.06}, 0.06}},
    {"link3", {{0, 0, -0.22}, {0, 0, -0.07}, 0.06}},
    {"link4", {{0, 0, -0.06}, {0, 0, 0.06}, 0.06}},
    {"link5", {{0, 0, -0.31}, {0, 0, -0.21}, 0.06}},
    {"link5", {{0, 0.08, -0.20}, {0, 0.08, -0.06}, 0.025}},
    {"link6", {{0, 0, -0.07}, {0, 0, 0.01}, 0.05}},
    {"link7", {{0, 0, -0.06}, {0, 0, 0.08}, 0.04}},
    {"link7",
     {{0.055 * half_root, 0.055 * half_root, 0.082},
      {0.065 * half_root, 0.065 * half_root, 0.082},
      0.03}},
    {"hand", {{0, -0.05, 0.04}, {0, 0.05, 0.04}, 0.04}},
};
constexpr double tolerance_m = 0.0002;
// The palm of a hand lies 66 mm from its mount (manual), 14 mm below its published capsule's end:
// what it grasps deeply would meet a shape that is not there.
constexpr double hand_tolerance_m = 0.0061;

std::vector<Vec3> surface_of(const robots::Capsule& capsule) {
  constexpr int around = 24, along = 24, up = 8;
  const Vec3 axis = normalized(capsule.b - capsule.a);
  const Vec3 side = normalized(cross(axis, std::abs(axis.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  const Vec3 other = cross(axis, side);
  std::vector<Vec3> points;
  for (int k = 0; k < around; ++k) {
    const double turn = 2 * std::numbers::pi * k / around;
    const Vec3 out = side * std::cos(turn) + other * std::sin(turn);
    for (int i = 0; i <= along; ++i)
      points.push_back(capsule.a + (capsule.b - capsule.a) * (static_cast<double>(i) / along) +
                       out * capsule.radius);
    for (int i = 1; i <= up; ++i) {
      const double rise = std::numbers::pi / 2 * i / up;
      const Vec3 flat = out * (std::cos(rise) * capsule.radius);
      points.push_back(capsule.a + flat - axis * (std::sin(rise) * capsule.radius));
      points.push_back(capsule.b + flat + axis * (std::sin(rise) * capsule.radius));
    }
  }
  return points;
}

// What reaches over the joint into the link before, about whose axis it is round, is held by that
// one wherever the joint stands.
double outside_of_both(const robots::Robot& robot, std::size_t link, Vec3 p) {
  const double own = outside(robot.links[link], p);
  if (own <= 0 || link == 0 || robot.joints[link - 1].dof < 0) return own;
  const robots::Joint& joint = robot.joints[link - 1];
  double worst = -HUGE_VAL;
  for (int i = 0; i <= 16; ++i) {
    const Pose motion =
        robots::joint_motion(joint, joint.lower + (joint.upper - joint.lower) * i / 16.0);
    worst =
        std::max(worst, outside(robot.links[static_cast<std::size_t>(joint.parent)], motion * p));
  }
  return std::min(own, worst);
}

TEST(FrankaShape, ThePublishedCapsulesLieInsideOurs) {
  const robots::Robot panda = committed_robot("panda");
  const std::vector<Pose> upright =
      robots::link_poses(panda, std::vector<double>(panda.dof_count()));
  for (const PublishedCapsule& capsule : published) {
    const auto link = static_cast<std::size_t>(panda.find_link(capsule.link));
    double worst = -HUGE_VAL;
    for (const Vec3 p : surface_of(capsule.shape)) {
      if ((upright[link] * p).z < 0 && capsule.link == std::string("link1"))
        continue;  // it reaches 60 mm into what the robot stands on
      worst = std::max(worst, outside_of_both(panda, link, p));
    }
    EXPECT_LT(worst, capsule.link == std::string("hand") ? hand_tolerance_m : tolerance_m)
        << capsule.link << " from " << capsule.shape.a.z << " m";
  }
}

TEST(FrankaShape, TheReadyPostureAndItsNeighbourhoodAreFree) {
  const robots::Robot panda = committed_robot("panda");
  std::vector<double> q =
      robots::with_posture(*panda.find_posture("ready"), robots::neutral_state(panda));
  const std::vector<robots::LinkPair> pairs = robots::pairs_that_may_touch(panda);
  EXPECT_FALSE(robots::first_contact(panda, robots::link_poses(panda, q), pairs, 0.01));
  for (std::size_t joint = 0; joint < 7; ++joint) {
    for (const double turn : {-0.5, 0.5}) {
      std::vector<double> turned = q;
      turned[joint] = std::clamp(
          turned[joint] + turn, panda.joint_of_dof(joint).lower, panda.joint_of_dof(joint).upper);
      EXPECT_FALSE(robots::first_contact(panda, robots::link_poses(panda, turned), pairs))
          << joint << " " << turn;
    }
  }
}

// A pair that is never apart is left out of all checks: larger capsules must not do that to one. Of
// link5 and link7 the shapes round the wrist's axes overlap wherever joint6 stands, whose limits
// keep the bodies apart.
TEST(FrankaShape, EveryOtherPairOfLinksThatCouldTouchIsChecked) {
  const robots::Robot panda = committed_robot("panda");
  const std::vector<robots::LinkPair> pairs = robots::pairs_that_may_touch(panda);
  for (int a = 0; a <= 7; ++a) {
    for (int b = a + 2; b <= 7; ++b) {
      const robots::LinkPair pair{panda.find_link("link" + std::to_string(a)),
                                  panda.find_link("link" + std::to_string(b))};
      const bool checked = std::ranges::find(pairs, pair) != pairs.end();
      EXPECT_EQ(checked, a != 5 || b != 7) << "link" << a << " link" << b;
    }
  }
}

}  // namespace
}  // namespace marketgen
