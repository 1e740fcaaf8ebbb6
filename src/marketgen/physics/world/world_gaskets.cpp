// Magnetic gaskets of a World's cooler doors.
#include <algorithm>

#include "physics/world/world_state.h"

namespace marketgen::physics {
namespace {

// mjModel's polynomial of a joint's spring: force -k x - k1 x^2 - k2 x^3, the last of which holds
// doors open (fixture_bodies.h).
double& bend_of(mjModel& m, int joint) {
  return m.jnt_stiffnesspoly[mjNPOLY * joint + 1];
}

// Towards the frame, N m.
double gasket_pull(const scene::SceneJoint& joint, double position) {
  if (position >= double(joint.gasket_reach)) return 0;
  const double left = 1 - std::max(position, 0.0) / double(joint.gasket_reach);
  return double(joint.gasket) * left * left;
}

}  // namespace

void World::State::find_gaskets() {
  for (std::uint32_t row = 0; row < store.joints.size(); ++row) {
    const JointAddress& at = store.joints[row];
    if (at.dof < 0 || scene.joints[row].gasket <= 0) continue;
    const int id = m().dof_jntid[at.dof];
    gaskets.push_back({row, id, m().jnt_stiffness[id], bend_of(m(), id), m().qpos_spring[at.qpos]});
  }
}

void World::State::pull_gaskets() {
  for (const GasketDoor& door : gaskets) {
    const JointAddress& at = store.joints[door.joint];
    const double position = d().qpos[at.qpos], x = position - door.rest;
    const double pull = gasket_pull(scene.joints[door.joint], position);
    if (pull == 0) {
      bend_of(m(), door.id) = door.bend;
      m().jnt_stiffness[door.id] = door.stiffness;
      m().qpos_spring[at.qpos] = door.rest;
      continue;
    }
    constexpr double any_stiffness = 1;  // N m/rad: the rest is put where it pulls right
    bend_of(m(), door.id) = 0;
    m().jnt_stiffness[door.id] = any_stiffness;
    m().qpos_spring[at.qpos] =
        position - (door.stiffness * x + door.bend * x * x * x + pull) / any_stiffness;
  }
}

}  // namespace marketgen::physics
