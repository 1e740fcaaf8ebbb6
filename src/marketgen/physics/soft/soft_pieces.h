// The contact pieces of a product, cut where a soft pack bends: what the parts of a bag are to a
// gripper, which is aimed at the bag's true shape and not at the row's box.
#pragma once
#include <array>
#include <vector>

#include "assets/product_model.h"
#include "physics/soft/soft_pack.h"

namespace marketgen::physics {

// The corners of a convex piece, frame of the pack.
using PieceCorners = std::vector<Vec3>;

// Those of base, top and flap, which may have none. `middle`: of the row's box, product frame.
// Pieces of less than a millimetre along the pack are left out. A cylinder becomes a prism of 16
// sides.
std::array<std::vector<PieceCorners>, SoftPack::part_count> cut_at_hinges(
    const assets::ProductBody& body, const SoftPack& pack, Vec3 middle);

// The part that has a point of the straight pack: 0 the base, 1 the top, 2 the flap.
int part_at(const SoftPack& pack, Vec3 point);

// Where the part is in the frame of the base when the hinges are bent so: pack_from_pack of what
// was there when it was straight.
Pose bent_part(const SoftPack& pack, int part, const std::array<double, 2>& angles_rad);

}  // namespace marketgen::physics
