// Driving through a shop: as wide as the robot is, past everything that stands in its way.
#include "collect/drive_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/scene.h"
#include "support/committed_robot.h"
#include "support/hand_laid_shop.h"

namespace marketgen {
namespace {

constexpr double drive_tick = 0.02;

scene::Scene shop_scene() {
  const HandLaidShop shop = shop_of({"canned", "dairy", "beverages", "household"});
  return scene::build_scene(shop.layout, shop.plan, committed_catalog(), Seed(2)).value();
}

std::vector<double> stowed(const robots::Robot& robot) {
  return robots::with_followers(
      robot, robots::with_posture(*robot.find_posture("stow"), robots::neutral_state(robot)));
}

// Least distance on the floor from a point to any part of a fixture.
double nearest_part(const scene::Scene& scene, Vec2 at) {
  double least = 1e9;
  for (const scene::ScenePart& part : scene.parts) {
    const Pose pose =
        scene::world_from_fixture(scene, part.fixture) * scene::fixture_from_part(part);
    const Vec3 local = inverse(pose) * Vec3{at.x, at.y, pose.position.z};
    const double x = std::max(0.0, std::abs(local.x) - part.half_size_m[0]);
    const double y = std::max(0.0, std::abs(local.y) - part.half_size_m[1]);
    least = std::min(least, std::hypot(x, y));
  }
  return least;
}

TEST(DriveGraph, DrivesRoundTheShelvesAndTouchesNone) {
  const scene::Scene scene = shop_scene();
  const robots::Robot& robot = committed_robot("realman-rm75");
  const std::vector<double> state = stowed(robot);
  const motion::BaseEnvelope envelope = motion::base_envelope(robot, state).value();
  const navigation::VisibilityGraph graph = collect::drive_graph(scene, envelope).value();
  const motion::FloorPlace from{{1.0, 1.0}, 0.3}, to{{16.0, 9.0}, -2.0};
  motion::DrivePlan plan = motion::plan_drive(graph, robot, state, from, to).value();
  EXPECT_GT(plan.path.length_m, std::hypot(15.0, 8.0) - 1e-6);
  double time = 0, nearest = 1e9;
  for (; !plan.follower.done() && time < 120; time += drive_tick)
    nearest = std::min(nearest, nearest_part(scene, plan.follower.step(drive_tick).position));
  EXPECT_TRUE(plan.follower.done());
  EXPECT_GE(nearest, envelope.radius_m);
  EXPECT_LT(nearest, envelope.radius_m + 0.2);  // it went round something
  EXPECT_NEAR(plan.follower.state().position.x, to.position.x, 1e-3);
  EXPECT_NEAR(plan.follower.state().heading, to.heading, 1e-9);
}

TEST(DriveGraph, WhatHangsOverTheRobotIsNoObstacle) {
  const robots::Robot& robot = committed_robot("realman-rm75");
  const motion::BaseEnvelope envelope = motion::base_envelope(robot, stowed(robot)).value();
  scene::Scene scene = shop_scene();
  const PointMm middle = layout::footprint_of(scene.layout.fixtures[0]).center();
  EXPECT_FALSE(collect::drive_graph(scene, envelope)->space().free(middle));
  scene.fixtures[0].position_m[2] += static_cast<float>(envelope.height_m) + 0.1F;
  EXPECT_TRUE(collect::drive_graph(scene, envelope)->space().free(middle));
}

TEST(DriveGraph, BadInput) {
  const scene::Scene scene = shop_scene();
  const robots::Robot& robot = committed_robot("realman-rm75");
  const std::vector<double> state = stowed(robot);
  const navigation::VisibilityGraph graph =
      collect::drive_graph(scene, motion::base_envelope(robot, state).value()).value();
  const auto code = [&](const motion::FloorPlace& from, const motion::FloorPlace& to) {
    const auto plan = motion::plan_drive(graph, robot, state, from, to);
    return plan.ok() ? std::string("no error") : plan.error().code;
  };
  const motion::FloorPlace good{{1, 1}, 0};
  EXPECT_EQ(code({{std::numeric_limits<double>::quiet_NaN(), 1}, 0}, good),
            "motion.bad_configuration");
  EXPECT_EQ(code(good, {{-5, 1}, 0}), "motion.outside_floor");
  const PointMm inside = layout::footprint_of(scene.layout.fixtures[0]).center();
  EXPECT_EQ(code(good, {{inside[0] * 1e-3, inside[1] * 1e-3}, 0}), "motion.base_blocked");
  const robots::Robot& panda = committed_robot("panda");
  const auto fixed = motion::base_envelope(panda, robots::neutral_state(panda));
  ASSERT_FALSE(fixed.ok());
  EXPECT_EQ(fixed.error().code, "motion.bad_limits");
  EXPECT_FALSE(motion::base_envelope(robot, std::vector<double>{1, 2}).ok());
}

}  // namespace
}  // namespace marketgen
