// Worlds of a few goods, and what the tests of World ask of them.
#pragma once
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>

#include "physics/world/world.h"
#include "unit/physics/shelf_places.h"

namespace marketgen {

constexpr float can_height = 0.115F, can_pitch = 0.071F;  // 66 mm wide, 5 mm apart
constexpr int second = 500;                               // steps

inline physics::World made(const scene::Scene& scene, physics::WorldOptions options = {}) {
  Result<physics::World> world = physics::World::create(scene, std::move(options));
  if (!world.ok()) fatal(to_string(world.error()).c_str());
  return std::move(world).value();
}

inline void run(physics::World& world, int steps) {
  const Result<void> done = world.step(steps);
  ASSERT_TRUE(done.ok()) << to_string(done.error());
}

inline double distance(const Pose& a, const Pose& b) {
  return length(a.position - b.position);
}

inline int count(const std::vector<physics::WorldEvent>& events, physics::EventKind kind) {
  return static_cast<int>(std::ranges::count(events, kind, &physics::WorldEvent::kind));
}

inline HandMadeScene row_of_cans(int cans) {
  HandMadeScene shop;
  for (int i = 0; i < cans; ++i)
    shop.add(can, {2.6F + can_pitch * static_cast<float>(i), on_shelf_y, lower});
  return shop;
}

inline physics::WorldOptions with_finger() {
  physics::WorldOptions options;
  options.add_actors = [](mjSpec_& spec) -> Result<void> {
    mjsBody* finger = mjs_addBody(mjs_findBody(&spec, "world"), nullptr);
    mjs_setName(finger->element, "finger");
    finger->mocap = 1;
    finger->pos[2] = 2;
    mjsGeom* tip = mjs_addGeom(finger, nullptr);
    tip->type = mjGEOM_SPHERE;
    tip->size[0] = 0.01;
    return {};
  };
  return options;
}

// A flap or a belt under one can, in a fixture of its own.
inline scene::Scene with_joint(HandMadeScene& shop, assets::JointKind kind) {
  scene::Scene& scene = shop.scene;
  scene::SceneJoint joint;
  joint.name = "moving";
  joint.kind = kind;
  joint.lower = -0.5F, joint.upper = 0.5F;
  joint.rotation_wxyz = {0.70710678F, 0, 0.70710678F, 0};  // axis along X
  joint.mass_kg = 2;
  joint.damping = 1;
  scene.fixtures[0].joint_count = 1;
  scene.joints.push_back(joint);
  scene::ScenePart part;
  part.unit = kind == assets::JointKind::belt ? assets::UnitKind::belt : assets::UnitKind::drawer;
  part.position_m = {0, -1.5F, 0.5F};
  part.half_size_m = {0.6F, 0.2F, 0.02F};
  part.joint = 0;
  scene.parts.push_back(part);
  ++scene.fixtures[0].part_count;
  shop.add(can, {3, HandMadeScene::shelf_y_m - 1.5F, 0.52F});
  return scene;
}

}  // namespace marketgen
