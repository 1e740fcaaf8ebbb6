// What the standing check accepts, MuJoCo must: the robot's capsules beside the parts of every
// fixture row, as they touch in a World.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "collect/standing_robot.h"
#include "geometry/box_extents.h"
#include "layout/layout.h"
#include "physics/goods/contact_shape.h"
#include "physics/goods/spec_geoms.h"
#include "robots/robot_row.h"
#include "scene/fixture_stage.h"
#include "support/committed_catalog.h"
#include "support/committed_robot.h"

namespace marketgen {
namespace {

using Spec = std::unique_ptr<mjSpec, decltype(&mj_deleteSpec)>;
using Model = std::unique_ptr<mjModel, decltype(&mj_deleteModel)>;
using Data = std::unique_ptr<mjData, decltype(&mj_deleteData)>;

constexpr int fixture_bit = 1, robot_bit = 2;

// A fixture that stands still and a robot in one posture that may be put anywhere.
class Beside {
 public:
  Beside(const scene::Scene& scene, const robots::PlacedRobot& placed) {
    const Spec spec(mj_makeSpec(), mj_deleteSpec);
    mjsBody* world = mjs_findBody(spec.get(), "world");
    for (const scene::ScenePart& part : scene.parts) {
      mjsGeom* geom = physics::add_shape(
          world, scene::world_from_fixture(scene, part.fixture) * physics::contact_shape_of(part));
      geom->contype = fixture_bit, geom->conaffinity = robot_bit;
    }
    mjsBody* body = mjs_addBody(world, nullptr);
    mjs_addFreeJoint(body);  // MuJoCo knows no contact between mocap bodies and what stands still
    const std::vector<Pose> poses = robots::link_poses(placed.robot, placed.q);
    for (std::size_t link = 0; link < poses.size(); ++link) {
      for (const robots::Capsule& capsule : placed.robot.links[link].capsules)
        add_capsule(body, poses[link], capsule);
    }
    model_.reset(mj_compile(spec.get(), nullptr));
    if (model_ == nullptr) fatal(mjs_getError(spec.get()));
    data_.reset(mj_makeData(model_.get()));
  }

  // How deep robot and fixture are in one another, metres.
  double depth_at(const Pose& world_from_base) {
    const Vec3 at = world_from_base.position;
    const Quaternion turn = world_from_base.rotation;
    const mjtNum qpos[7] = {at.x, at.y, at.z, turn.w, turn.x, turn.y, turn.z};
    mju_copy(data_->qpos, qpos, 7);
    mj_forward(model_.get(), data_.get());
    double depth = 0;
    for (int i = 0; i < data_->ncon; ++i)
      depth = std::max(depth, -data_->contact[i].dist);
    return depth;
  }

 private:
  static void add_capsule(mjsBody* body,
                          const Pose& body_from_link,
                          const robots::Capsule& capsule) {
    mjsGeom* geom = mjs_addGeom(body, nullptr);
    const Vec3 a = body_from_link * capsule.a, b = body_from_link * capsule.b;
    const bool ball = length(b - a) < 1e-9;
    geom->type = ball ? mjGEOM_SPHERE : mjGEOM_CAPSULE;
    geom->size[0] = capsule.radius;
    const double ends[6] = {a.x, a.y, a.z, b.x, b.y, b.z};
    if (ball)
      std::copy_n(ends, 3, geom->pos);
    else
      std::copy_n(ends, 6, geom->fromto);
    geom->contype = robot_bit, geom->conaffinity = fixture_bit;
  }

  Model model_{nullptr, mj_deleteModel};
  Data data_{nullptr, mj_deleteData};
};

robots::PlacedRobot robot_in_store() {
  const std::string text = "realman-rm65@1,1,90";
  const robots::RobotSpec spec = robots::parse_robot_spec(text, text).value();
  return robots::place_robot(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data", spec, text)
      .value();
}

// South of a fixture whose front is at `front_y`, looking north, turned by `turn_deg`.
struct Approach {
  double x = 0, front_y = 0, turn_deg = 0;

  Pose at(double away_m) const {
    const double half = (90 + turn_deg) * std::numbers::pi / 360;
    return {{x, front_y - away_m, 0}, {std::cos(half), 0, 0, std::sin(half)}};
  }
};

// The nearest place that the check accepts, to 1 mm; -1: none up to 1 m.
double nearest_accepted(const scene::Scene& scene,
                        robots::PlacedRobot& placed,
                        const Approach& approach) {
  const auto accepts = [&](double away_m) {
    placed.world_from_base = approach.at(away_m);
    return collect::check_standing(scene, {&placed, 1}).ok();
  };
  double blocked = 0, clear = 1;
  if (accepts(blocked) || !accepts(clear)) return -1;
  while (clear - blocked > 0.001) {
    const double middle = (blocked + clear) / 2;
    (accepts(middle) ? clear : blocked) = middle;
  }
  return clear;
}

TEST(StandingBodies, WhatTheCheckAcceptsTouchesNoFixture) {
  robots::PlacedRobot placed = robot_in_store();
  int approached = 0;
  for (const catalog::FixtureKind& kind : committed_catalog().fixture_kinds) {
    const scene::Scene scene = scene::stage_fixture(kind, committed_catalog()).value();
    const RectMm footprint = layout::footprint_of(scene.layout.fixtures[0]);
    const double front = footprint.y0 * 1e-3, left = footprint.x0 * 1e-3;
    Beside beside(scene, placed);
    for (const Approach& approach :
         {Approach{(left + footprint.x1 * 1e-3) / 2, front, 0}, Approach{left, front, -40}}) {
      const double away = nearest_accepted(scene, placed, approach);
      if (away < 0) continue;  // it hangs over the robot
      ++approached;
      for (const double more : {0.0, 0.002, 0.02}) {
        EXPECT_LT(beside.depth_at(approach.at(away + more)), 1e-4)
            << kind.kind << ", " << away + more << " m before it, turned " << approach.turn_deg;
      }
      EXPECT_GT(beside.depth_at(approach.at(away - 0.05)), 0.005)
          << kind.kind << ": the check keeps off what is not there";
    }
  }
  EXPECT_GT(approached, 150);
}

// The ground that drives keep off is the fixtures' footprint: nothing that a joint does not move
// stands out of it.
TEST(StandingBodies, FixturesLieWithinTheirFootprint) {
  constexpr double spare_m = 0.0015;
  for (const catalog::FixtureKind& kind : committed_catalog().fixture_kinds) {
    const scene::Scene scene = scene::stage_fixture(kind, committed_catalog()).value();
    const RectMm footprint = layout::footprint_of(scene.layout.fixtures[0]);
    for (const scene::ScenePart& part : scene.parts) {
      const Pose pose =
          scene::world_from_fixture(scene, part.fixture) * scene::fixture_from_part(part);
      const auto& [hx, hy, hz] = part.half_size_m;
      const Vec3 half = box_half_extents(pose.rotation, {hx, hy, hz});
      const std::string what = kind.kind + " " + std::string(name_of(part.unit));
      EXPECT_GE(pose.position.x - half.x, footprint.x0 * 1e-3 - spare_m) << what;
      EXPECT_LE(pose.position.x + half.x, footprint.x1 * 1e-3 + spare_m) << what;
      EXPECT_GE(pose.position.y - half.y, footprint.y0 * 1e-3 - spare_m) << what;
      EXPECT_LE(pose.position.y + half.y, footprint.y1 * 1e-3 + spare_m) << what;
    }
  }
}

}  // namespace
}  // namespace marketgen
