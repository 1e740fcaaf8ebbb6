// The primitives with which things meet in MuJoCo, and how they rub: the one description that both
// the simulation and the MJCF file are made from.
#pragma once
#include "assets/product_model.h"
#include "geometry/pose.h"
#include "scene/scene.h"

namespace marketgen {

struct ContactShape {
  CollisionShape shape = CollisionShape::box;
  Pose pose;  // owner_from_shape; a cylinder's axis is Z
  Vec3 size;  // as MuJoCo counts: half extents, or radius, half length and 0
};

ContactShape contact_shape_of(const ScenePart& part);                 // in the fixture frame
ContactShape contact_shape_of(const CollisionPrimitive& primitive);   // in the product frame
ContactShape operator*(const Pose& pose, const ContactShape& shape);  // moved along with its owner

// Half extents of the axis-aligned box around the shape, in its owner's frame.
Vec3 half_extents(const ContactShape& shape);

// ---- Parameters of the simulation. Measured to hold a grasp for 5 s within 0.1 mm. ----

constexpr double time_step_s = 0.002;
constexpr double friction_impedance_ratio = 10;  // MuJoCo's impratio: 1 lets goods creep
constexpr int noslip_iterations = 3;
constexpr double contact_time_s =
    0.005;  // solref of goods: stiff enough for pouches, at least 2 steps
constexpr int contact_dimensions = 4;        // normal, two sliding, one torsional
constexpr int loose_contact_dimensions = 6;  // what can roll has rolling friction too
constexpr double torsional_friction_m =
    0.005;  // MuJoCo's default: the radius of a contact patch times friction
// Rolling resistance of fruit on a rough surface, as a length; apples on wood 1-3 mm (Mohsenin,
// Physical Properties of Plant and Animal Materials, 1986).
constexpr double rolling_friction_m = 0.002;

// MuJoCo takes the greater friction of the two in contact. Goods carry theirs (on a painted steel
// shelf); what stands still has the least that a row may have, so that the goods' value decides.
constexpr double still_friction = 0.05;

}  // namespace marketgen
