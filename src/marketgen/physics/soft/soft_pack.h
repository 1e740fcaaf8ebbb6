// Bags and pouches as small articulated bodies: two halves of the filled pack on a sprung hinge,
// so that it sags, and a seam that bends, so that it can be pinched.
//
//       +--------+--------+
//       |  base  |  top   |=== flap        "|" in the middle and "=" are the hinges
//       +--------+--------+
//
// At rest the parts make up the row's box: the halves have its full cross-section, the flap ends
// where it ends. Mass is the row's; it is divided so that the middle of mass lies along the pack
// where that of the filled pack does (a pouch is fullest at its foot).
//
// Frame: axes of the product, origin in the middle of the row's box; SI units.
#pragma once
#include <array>
#include <optional>

#include "physics/goods/contact_shape.h"

namespace marketgen::physics {

struct SoftPart {
  Vec3 center, half_size;  // a box along the axes
  double mass_kg = 0;      // spread evenly over it
};

// Sprung towards 0, where the pack is straight.
struct SoftHinge {
  Vec3 at, axis;
  double stiffness_n_m = 0;  // a radian
  double damping_n_m_s = 0;
  double limit_rad = 0;  // to either side
};

struct SoftPack {
  static constexpr int part_count = 3;
  std::array<SoftPart, part_count> parts;        // base, top, flap
  std::array<SoftHinge, part_count - 1> hinges;  // between one part and the next
};

// False: soft_pack_of() would say none. Cheap, unlike that (milliseconds).
bool may_be_soft_pack(const catalog::Product& product);

// None for what is no soft pack: not of film or foil, not soft, or without a seam that sticks out
// at an end other than the one it stands on. Of two such seams the upper or left one is the flap.
// Errors: catalog.bad_row (no mass or size), and as make_product_model.
Result<std::optional<SoftPack>> soft_pack_of(const catalog::Product& product);

// A bag of 2 x 1 x 3 decimetres, bent in the middle of its 28 cm below the flap: what stands for a
// pack that is not known yet.
SoftPack plain_soft_pack();

}  // namespace marketgen::physics
