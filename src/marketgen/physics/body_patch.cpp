#include "physics/body_patch.h"

#include <algorithm>
#include <cmath>

#include "physics/fixture_bodies.h"
#include "physics/soft_body.h"
#include "physics/spec_geoms.h"

namespace marketgen {
namespace {

// Half extents of the box around a shape along its own axes, and the radius of its sphere.
struct Bounds {
  Vec3 half;
  double radius = 0;
};

Bounds bounds_of(const ContactShape& shape) {
  const Vec3& s = shape.size;
  switch (shape.shape) {
    case CollisionShape::box:
      return {s, length(s)};
    case CollisionShape::cylinder:
      return {{s.x, s.x, s.y}, std::sqrt(s.x * s.x + s.y * s.y)};
    default:
      return {s, std::max({s.x, s.y, s.z})};
  }
}

void write(mjtNum* to, Vec3 v) {
  to[0] = v.x, to[1] = v.y, to[2] = v.z;
}

void dress_geom(mjModel& m, int g, const GoodsShape& goods, const Bounds& bounds) {
  m.geom_type[g] = geom_type_of(goods.shape.shape);
  write(m.geom_size + 3 * g, goods.shape.size);
  m.geom_condim[g] = goods.contact.dimensions;
  m.geom_friction[3 * g] = goods.contact.sliding;
  m.geom_friction[3 * g + 1] = goods.contact.torsional_m;
  m.geom_friction[3 * g + 2] = goods.contact.rolling_m;
  m.geom_rbound[g] = bounds.radius;
  write(m.geom_aabb + 6 * g, {});
  write(m.geom_aabb + 6 * g + 3, bounds.half);
}

// Inverse weights are those of a free body in its inertial frame.
void dress_inertia(mjModel& m, const PoolBody& body, const GoodsShape& goods, double radius) {
  const int b = body.body, d = body.dof;
  const double mass = goods.mass_kg;
  const Vec3& inertia = goods.inertia_kg_m2;
  m.body_mass[b] = m.body_subtreemass[b] = mass;
  write(m.body_inertia + 3 * b, inertia);
  const double linear = 1 / mass;
  const double angular = (1 / inertia.x + 1 / inertia.y + 1 / inertia.z) / 3;
  m.body_invweight0[2 * b] = linear, m.body_invweight0[2 * b + 1] = angular;
  for (int i = 0; i < 3; ++i) {
    m.dof_invweight0[d + i] = linear, m.dof_invweight0[d + 3 + i] = angular;
    m.dof_M0[d + i] = mass;
    m.dof_length[d + 3 + i] = radius;
  }
  write(m.dof_M0 + d + 3, inertia);
}

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

void dress_body(
    mjModel& m, mjData& d, const PoolBody& body, const GoodsShape& goods, const ShapePose& pose) {
  const Bounds bounds = bounds_of(goods.shape);
  dress_geom(m, body.geom, goods, bounds);
  dress_inertia(m, body, goods, bounds.radius);
  for (int node = 0; node < m.body_bvhnum[body.body]; ++node) {
    mjtNum* box = m.bvh_aabb + 6 * (m.body_bvhadr[body.body] + node);
    write(box, {});
    write(box + 3, bounds.half);
  }
  collide_body(m, body, true);
  put_at_rest(d, body, pose);
}

void dress_soft_body(
    mjModel& m, mjData& d, const PoolBody& body, const mjModel& pack, const ShapePose& pose) {
  copy_soft_tree(m, body.body, pack);
  collide_body(m, body, true);
  put_at_rest(d, body, pose);
}

void collide_body(mjModel& m, const PoolBody& body, bool on) {
  const int type = on ? goods_contact_type : 0, affinity = on ? goods_affinity : 0;
  for (int part = 0; part < body.parts; ++part) {
    m.geom_contype[body.geom + part] = m.body_contype[body.body + part] = type;
    m.geom_conaffinity[body.geom + part] = m.body_conaffinity[body.body + part] = affinity;
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

}  // namespace marketgen
