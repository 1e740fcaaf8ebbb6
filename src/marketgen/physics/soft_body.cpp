#include "physics/soft_body.h"

#include <algorithm>
#include <cmath>

#include "physics/spec_geoms.h"

namespace marketgen {
namespace {

constexpr std::array<const char*, SoftPack::part_count> part_suffix = {"", "-top", "-flap"};
// On a shelf that is tilted by 8 degrees bags bend by 0.054.
constexpr double straight_rad = 0.07;
constexpr int free_dofs = 6;
constexpr int soft_dofs = free_dofs + SoftPack::part_count - 1;

void write3(double* to, Vec3 v) {
  to[0] = v.x, to[1] = v.y, to[2] = v.z;
}

void add_hinge(mjsBody* body, const SoftHinge& hinge) {
  mjsJoint* joint = mjs_addJoint(body, nullptr);
  joint->type = mjJNT_HINGE;
  write3(joint->axis, hinge.axis);
  joint->stiffness[0] = hinge.stiffness_n_m;
  joint->damping[0] = hinge.damping_n_m_s;
  joint->limited = mjLIMITED_TRUE;
  joint->range[0] = -hinge.limit_rad, joint->range[1] = hinge.limit_rad;
}

// `count` rows of `width` numbers of one field.
template <class T>
void copy_rows(T* to, int row, const T* from, int from_row, int count, int width = 1) {
  std::copy_n(from + from_row * width, count * width, to + row * width);
}

void copy_bodies(mjModel& to, int at, const mjModel& from) {
  constexpr int n = SoftPack::part_count, first = 1;  // behind the world
  copy_rows(to.body_sameframe, at, from.body_sameframe, first, n);
  copy_rows(to.body_pos, at, from.body_pos, first, n, 3);
  copy_rows(to.body_ipos, at, from.body_ipos, first, n, 3);
  copy_rows(to.body_iquat, at, from.body_iquat, first, n, 4);
  copy_rows(to.body_mass, at, from.body_mass, first, n);
  copy_rows(to.body_subtreemass, at, from.body_subtreemass, first, n);
  copy_rows(to.body_inertia, at, from.body_inertia, first, n, 3);
  copy_rows(to.body_invweight0, at, from.body_invweight0, first, n, 2);
  for (int i = 0; i < n; ++i)
    copy_rows(
        to.bvh_aabb, to.body_bvhadr[at + i], from.bvh_aabb, from.body_bvhadr[first + i], 1, 6);
}

void copy_joints(mjModel& to, int at, const mjModel& from) {
  constexpr int n = SoftPack::part_count;  // the free joint and the hinges
  copy_rows(to.jnt_axis, at, from.jnt_axis, 0, n, 3);
  copy_rows(to.jnt_stiffness, at, from.jnt_stiffness, 0, n);
  copy_rows(to.jnt_range, at, from.jnt_range, 0, n, 2);
}

void copy_dofs(mjModel& to, int at, const mjModel& from) {
  copy_rows(to.dof_damping, at, from.dof_damping, 0, soft_dofs);
  copy_rows(to.dof_invweight0, at, from.dof_invweight0, 0, soft_dofs);
  copy_rows(to.dof_M0, at, from.dof_M0, 0, soft_dofs);
  copy_rows(to.dof_length, at, from.dof_length, 0, soft_dofs);
}

void copy_geoms(mjModel& to, int at, const mjModel& from) {
  constexpr int n = SoftPack::part_count;
  copy_rows(to.geom_size, at, from.geom_size, 0, n, 3);
  copy_rows(to.geom_aabb, at, from.geom_aabb, 0, n, 6);
  copy_rows(to.geom_rbound, at, from.geom_rbound, 0, n);
  copy_rows(to.geom_pos, at, from.geom_pos, 0, n, 3);
  copy_rows(to.geom_quat, at, from.geom_quat, 0, n, 4);
  copy_rows(to.geom_sameframe, at, from.geom_sameframe, 0, n);
  copy_rows(to.geom_condim, at, from.geom_condim, 0, n);
  copy_rows(to.geom_friction, at, from.geom_friction, 0, n, 3);
}

}  // namespace

SoftElements add_soft_body(mjsBody* parent, const SoftPack& pack, const std::string& name) {
  SoftElements made{};
  Vec3 frame;  // of the body, in the pack's frame: the middle, then the hinges
  for (std::size_t i = 0; i < pack.parts.size(); ++i) {
    const SoftPart& part = pack.parts[i];
    mjsBody* body = mjs_addBody(i == 0 ? parent : made.bodies[i - 1], nullptr);
    mjs_setName(body->element, (name + part_suffix[i]).c_str());
    if (i == 0) {
      mjs_addFreeJoint(body)->align = mjALIGNFREE_FALSE;
    } else {
      const SoftHinge& hinge = pack.hinges[i - 1];
      write3(body->pos, hinge.at - frame);
      frame = hinge.at;
      add_hinge(body, hinge);
    }
    made.bodies[i] = body;
    made.geoms[i] =
        add_shape(body, {CollisionShape::box, {part.center - frame, {}}, part.half_size});
    made.geoms[i]->mass = part.mass_kg;
  }
  return made;
}

Result<MujocoModel> soft_model(const SoftPack& pack,
                               const GoodsContact& contact,
                               const std::string& where) {
  const MujocoSpec spec(mj_makeSpec(), mj_deleteSpec);
  spec->compiler.degree = false;
  for (mjsGeom* geom : add_soft_body(mjs_findBody(spec.get(), "world"), pack, "pack").geoms)
    set_goods_contact(geom, contact);
  return compile(*spec, where);
}

void copy_soft_tree(mjModel& to, int body, const mjModel& from) {
  copy_bodies(to, body, from);
  copy_joints(to, to.body_jntadr[body], from);
  copy_dofs(to, to.body_dofadr[body], from);
  copy_geoms(to, to.body_geomadr[body], from);
}

double soft_reach_m(const mjModel& m, int body) {
  double to_hinge = 0, reach = 0;
  for (int part = body; part < body + SoftPack::part_count; ++part) {
    const int geom = m.body_geomadr[part];
    if (part > body) to_hinge += mju_norm3(m.body_pos + 3 * part);
    reach = std::max(reach, to_hinge + mju_norm3(m.geom_pos + 3 * geom) + m.geom_rbound[geom]);
  }
  return reach;
}

bool lies_in_its_box(const mjModel& m, const mjData& d, int body) {
  const auto angle = [&](int part) { return std::abs(d.qpos[m.jnt_qposadr[m.body_jntadr[part]]]); };
  const int top = body + 1, flap = body + 2;
  const double flap_length =
      2 * mju_norm3(m.geom_pos + 3 * m.body_geomadr[flap]);  // from its hinge
  const mjtNum* half = m.geom_size + 3 * m.body_geomadr[top];
  return angle(top) < straight_rad &&
         flap_length * std::sin(angle(flap)) < std::min({half[0], half[1], half[2]});
}

}  // namespace marketgen
