#include "physics/goods/slot.h"

#include <algorithm>

namespace marketgen::physics {
namespace {

constexpr int first = 1;  // body of `from`, behind the world

// `count` rows of `width` numbers of one field.
template <class T>
void copy_rows(T* to, int row, const T* from, int from_row, int count, int width = 1) {
  std::copy_n(from + from_row * width, count * width, to + row * width);
}

void copy_bodies(mjModel& to, int at, const mjModel& from, int n) {
  copy_rows(to.body_sameframe, at, from.body_sameframe, first, n);
  copy_rows(to.body_pos, at, from.body_pos, first, n, 3);
  copy_rows(to.body_ipos, at, from.body_ipos, first, n, 3);
  copy_rows(to.body_iquat, at, from.body_iquat, first, n, 4);
  copy_rows(to.body_mass, at, from.body_mass, first, n);
  copy_rows(to.body_subtreemass, at, from.body_subtreemass, first, n);
  copy_rows(to.body_inertia, at, from.body_inertia, first, n, 3);
  copy_rows(to.body_invweight0, at, from.body_invweight0, first, n, 2);
}

void copy_joints(mjModel& to, int at, const mjModel& from) {
  const auto n = static_cast<int>(from.njnt);
  copy_rows(to.jnt_axis, at, from.jnt_axis, 0, n, 3);
  copy_rows(to.jnt_stiffness, at, from.jnt_stiffness, 0, n);
  copy_rows(to.jnt_range, at, from.jnt_range, 0, n, 2);
}

void copy_dofs(mjModel& to, int at, const mjModel& from) {
  const auto n = static_cast<int>(from.nv);
  copy_rows(to.dof_damping, at, from.dof_damping, 0, n);
  copy_rows(to.dof_invweight0, at, from.dof_invweight0, 0, n);
  copy_rows(to.dof_M0, at, from.dof_M0, 0, n);
  copy_rows(to.dof_length, at, from.dof_length, 0, n);
}

void copy_geoms(mjModel& to, int at, const mjModel& from, int from_at, int n, int first_mesh) {
  copy_rows(to.geom_type, at, from.geom_type, from_at, n);
  copy_rows(to.geom_size, at, from.geom_size, from_at, n, 3);
  copy_rows(to.geom_aabb, at, from.geom_aabb, from_at, n, 6);
  copy_rows(to.geom_rbound, at, from.geom_rbound, from_at, n);
  copy_rows(to.geom_pos, at, from.geom_pos, from_at, n, 3);
  copy_rows(to.geom_quat, at, from.geom_quat, from_at, n, 4);
  copy_rows(to.geom_sameframe, at, from.geom_sameframe, from_at, n);
  copy_rows(to.geom_condim, at, from.geom_condim, from_at, n);
  copy_rows(to.geom_friction, at, from.geom_friction, from_at, n, 3);
  for (int i = 0; i < n; ++i) {
    const int mesh = from.geom_dataid[from_at + i];
    to.geom_dataid[at + i] = mesh < 0 ? -1 : first_mesh + mesh;
  }
}

// The tree of boxes over the geoms of one body.
void copy_boxes(mjModel& to, int body, const mjModel& from, int from_body) {
  const int at = to.body_bvhadr[body], from_at = from.body_bvhadr[from_body];
  const int n = from.body_bvhnum[from_body];
  to.body_bvhnum[body] = n;
  copy_rows(to.bvh_depth, at, from.bvh_depth, from_at, n);
  copy_rows(to.bvh_child, at, from.bvh_child, from_at, n, 2);
  copy_rows(to.bvh_aabb, at, from.bvh_aabb, from_at, n, 6);
  for (int i = 0; i < n; ++i) {
    const int geom = from.bvh_nodeid[from_at + i];
    to.bvh_nodeid[at + i] =
        geom < 0 ? -1 : to.body_geomadr[body] + geom - from.body_geomadr[from_body];
  }
}

}  // namespace

void copy_tree(mjModel& to, int body, const mjModel& from, int first_mesh) {
  const auto bodies = static_cast<int>(from.nbody) - first;
  copy_bodies(to, body, from, bodies);
  copy_joints(to, to.body_jntadr[body], from);
  copy_dofs(to, to.body_dofadr[body], from);
  for (int i = 0; i < bodies; ++i) {
    const int b = body + i, from_b = first + i;
    to.body_geomnum[b] = from.body_geomnum[from_b];
    copy_geoms(to,
               to.body_geomadr[b],
               from,
               from.body_geomadr[from_b],
               from.body_geomnum[from_b],
               first_mesh);
    copy_boxes(to, b, from, from_b);
  }
}

void scale_mass(mjModel& model, double factor) {
  const auto scale = [](mjtNum* values, mjtSize count, double by) {
    for (mjtSize i = 0; i < count; ++i)
      values[i] *= by;
  };
  scale(model.body_mass, model.nbody, factor);
  scale(model.body_subtreemass, model.nbody, factor);
  scale(model.body_inertia, 3 * model.nbody, factor);
  scale(model.body_invweight0, 2 * model.nbody, 1 / factor);
  scale(model.dof_invweight0, model.nv, 1 / factor);
  scale(model.dof_M0, model.nv, factor);
}

}  // namespace marketgen::physics
