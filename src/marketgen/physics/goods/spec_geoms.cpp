#include "physics/goods/spec_geoms.h"

#include <algorithm>

#include "base/gravity.h"

namespace marketgen::physics {

mjtGeom geom_type_of(assets::CollisionShape shape) {
  switch (shape) {
    case assets::CollisionShape::box:
      return mjGEOM_BOX;
    case assets::CollisionShape::cylinder:
      return mjGEOM_CYLINDER;
    default:
      return mjGEOM_ELLIPSOID;
  }
}

void set_pose(double position[3], double rotation[4], const Pose& pose) {
  const double p[3] = {pose.position.x, pose.position.y, pose.position.z};
  const double q[4] = {pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z};
  std::copy(p, p + 3, position);
  std::copy(q, q + 4, rotation);
}

void set_contact_options(mjSpec& spec, double sleep_below_m_s) {
  mjOption& option = spec.option;
  option.timestep = time_step_s;
  option.gravity[2] = -standard_gravity;
  option.integrator = mjINT_IMPLICITFAST;
  option.cone = mjCONE_ELLIPTIC;
  option.impratio = friction_impedance_ratio;
  option.noslip_iterations = noslip_iterations;
  option.enableflags |= mjENBL_SLEEP;
  option.sleep_tolerance = sleep_below_m_s;
}

namespace {

mjsGeom* add_still(mjsBody* body, mjtGeom type) {
  mjsGeom* geom = mjs_addGeom(body, nullptr);
  geom->type = type;
  geom->friction[0] = still_friction;
  geom->solref[0] = contact_time_s;
  return geom;
}

}  // namespace

mjsGeom* add_shape(mjsBody* body, const assets::ContactShape& shape) {
  mjsGeom* geom = add_still(body, geom_type_of(shape.shape));
  const double size[3] = {shape.size.x, shape.size.y, shape.size.z};
  std::copy(size, size + 3, geom->size);
  set_pose(geom->pos, geom->quat, shape.pose);
  return geom;
}

mjsGeom* add_floor(mjsBody* world) {
  mjsGeom* floor = add_still(world, mjGEOM_PLANE);
  floor->size[2] = 1;  // as a viewer draws its grid
  return floor;
}

void set_goods_contact(mjsGeom* geom, const GoodsContact& contact) {
  geom->condim = contact.dimensions;
  const double friction[3] = {contact.sliding, contact.torsional_m, contact.rolling_m};
  std::copy(friction, friction + 3, geom->friction);
}

}  // namespace marketgen::physics
