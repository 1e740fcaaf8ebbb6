// Our contact shapes as geoms of a MuJoCo specification: what the settling check and the World
// share.
#pragma once
#include "physics/goods/contact_shape.h"
#include "physics/mujoco_guard.h"

namespace marketgen::physics {

mjtGeom geom_type_of(assets::CollisionShape shape);
void set_pose(double position[3], double rotation[4], const Pose& pose);

// Time step, cone, solver and sleep. What is slower than `sleep_below_m_s` (or radians a second
// times its radius) for ten steps goes to sleep.
void set_contact_options(mjSpec& spec, double sleep_below_m_s);

// A geom that stands still: least friction, stiff.
mjsGeom* add_shape(mjsBody* body, const assets::ContactShape& shape);
// The plane z = 0 without end, of the same kind.
mjsGeom* add_floor(mjsBody* world);
void set_goods_contact(mjsGeom* geom, const GoodsContact& contact);

}  // namespace marketgen::physics
