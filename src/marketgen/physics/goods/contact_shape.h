// How the primitives with which things meet in MuJoCo rub: the one description that both the
// simulation and the MJCF file are made from.
#pragma once
#include "assets/contact_shape.h"
#include "scene/scene.h"

namespace marketgen::physics {

assets::ContactShape contact_shape_of(const scene::ScenePart& part);  // in the fixture frame

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
GoodsContact goods_contact_of(const catalog::Product& product,
                              const assets::CollisionPrimitive& primitive);

// MuJoCo takes the greater friction of the two in contact. Goods carry theirs (on a painted steel
// shelf); what stands still has the least that a row may have, so that the goods' value decides.
constexpr double still_friction = 0.05;

}  // namespace marketgen::physics
