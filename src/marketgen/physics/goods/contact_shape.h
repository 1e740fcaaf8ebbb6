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
ContactShape contact_shape_of(const ContactPiece& piece);             // the same; not of a hull
ContactShape operator*(const Pose& pose, const ContactShape& shape);  // moved along with its owner

// Half extents of the axis-aligned box around the shape, in its owner's frame.
Vec3 half_extents(const ContactShape& shape);

// ---- Parameters of the simulation. Measured to hold a grasp for 5 s within 0.1 mm. ----

constexpr double time_step_s = 0.002;
constexpr double friction_impedance_ratio = 10;  // MuJoCo's impratio: 1 lets goods creep
constexpr int noslip_iterations = 3;
constexpr double contact_time_s =
    0.005;  // solref of goods: stiff enough for pouches, at least 2 steps
constexpr double torsional_friction_m =
    0.005;  // MuJoCo's default: the radius of a contact patch times friction
constexpr double plain_rolling_friction_m =
    1e-4;  // MuJoCo's default; without effect where nothing rolls

// How one product rubs: MuJoCo's condim and the three friction coefficients.
struct GoodsContact {
  int dimensions;  // 4: normal, two sliding, torsional; 6: two rolling as well
  double sliding, torsional_m, rolling_m;
};
GoodsContact goods_contact_of(const Product& product, const CollisionPrimitive& primitive);

// MuJoCo takes the greater friction of the two in contact. Goods carry theirs (on a painted steel
// shelf); what stands still has the least that a row may have, so that the goods' value decides.
constexpr double still_friction = 0.05;

}  // namespace marketgen
