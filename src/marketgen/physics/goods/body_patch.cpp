#include "physics/goods/body_patch.h"

#include <algorithm>
#include <cmath>

#include "physics/world/fixture_bodies.h"

namespace marketgen::physics {
namespace {

// At rest at `pose`, a soft pack straight.
void put_at_rest(mjData& d, const PoolBody& body, const ShapePose& pose) {
  mju_copy(d.qpos + body.qpos, pose.position, 3);
  mju_copy(d.qpos + body.qpos + 3, pose.rotation, 4);
  mju_zero(d.qpos + body.qpos + 7, body.parts - 1);
  mju_zero(d.qvel + body.dof, body.dofs());
  mju_zero(d.qacc + body.dof, body.dofs());
  mju_zero(d.qacc_warmstart + body.dof, body.dofs());
  mark_wake(d, body);
}

// Takes a sleeping tree out of the ring of those that fell asleep with it.
void sleep_alone(mjData& d, int tree) {
  if (d.tree_asleep[tree] < 0) return;
  int before = tree;
  while (d.tree_asleep[before] != tree)
    before = d.tree_asleep[before];
  d.tree_asleep[before] = d.tree_asleep[tree];
  d.tree_asleep[tree] = tree;
}

}  // namespace

void dress_body(mjModel& m,
                mjData& d,
                const PoolBody& body,
                const mjModel& goods,
                int first_mesh,
                const ShapePose& pose) {
  collide_body(m, body, false);
  copy_tree(m, body.body, goods, first_mesh);
  collide_body(m, body, true);
  put_at_rest(d, body, pose);
}

void collide_body(mjModel& m, const PoolBody& body, bool on) {
  const int type = on ? goods_contact_type : 0, affinity = on ? goods_affinity : 0;
  for (int part = body.body; part < body.body + body.parts; ++part) {
    m.body_contype[part] = type, m.body_conaffinity[part] = affinity;
    const int first = m.body_geomadr[part], count = m.body_geomnum[part];
    std::fill_n(m.geom_contype + first, count, type);
    std::fill_n(m.geom_conaffinity + first, count, affinity);
  }
}

void park_body(mjModel& m, mjData& d, const PoolBody& body) {
  collide_body(m, body, false);
  d.eq_active[body.hook] = false;
  sleep_alone(d, body.tree);
}

void mark_wake(mjData& d, const PoolBody& body) {
  mjtNum& force = d.xfrc_applied[6 * body.body];
  if (force == 0) force = -0.0;
}

void settle_wake(mjData& d, const PoolBody& body) {
  mjtNum& force = d.xfrc_applied[6 * body.body];
  if (force == 0) force = 0.0;
}

Box3 box_of_geom(const mjModel& m, int geom, const mjtNum* position, const mjtNum* rotation) {
  const mjtNum* box = m.geom_aabb + 6 * geom;
  mjtNum middle[3], half[3];
  for (int i = 0; i < 3; ++i) {
    middle[i] = position[i], half[i] = 0;
    for (int j = 0; j < 3; ++j) {
      middle[i] += rotation[3 * i + j] * box[j];
      half[i] += std::abs(rotation[3 * i + j]) * box[3 + j];
    }
  }
  return {vec3_of(middle) - vec3_of(half), vec3_of(middle) + vec3_of(half)};
}

void switch_geom(mjModel& m, int geom, bool on) {
  m.geom_contype[geom] = on ? still_goods_contact_type : 0;
  m.geom_conaffinity[geom] = on ? goods_affinity : 0;
}

void move_geom(mjModel& m, mjData& d, int geom, const ShapePose& pose) {
  mju_copy(m.geom_pos + 3 * geom, pose.position, 3);
  mju_copy(m.geom_quat + 4 * geom, pose.rotation, 4);
  m.geom_sameframe[geom] = mjSAMEFRAME_NONE;
  mju_copy(d.geom_xpos + 3 * geom, pose.position, 3);
  mju_copy(d.geom_xquat + 4 * geom, pose.rotation, 4);
  mju_quat2Mat(d.geom_xmat + 9 * geom, pose.rotation);
}

ShapePose geom_pose(const mjModel& m, int geom) {
  ShapePose pose;
  mju_copy(pose.position, m.geom_pos + 3 * geom, 3);
  mju_copy(pose.rotation, m.geom_quat + 4 * geom, 4);
  return pose;
}

}  // namespace marketgen::physics
