// Packs and what they stand on as an arm planner sees them.
#pragma once
#include <vector>

#include "assets/contact_shape.h"
#include "motion/collision_world.h"

namespace marketgen::motion {

// Each is added to what `obstacles` holds. An ellipsoid is taken for its box.
void add_shape(const assets::ContactShape& shape, Obstacles& obstacles);
// The pieces of a pack that lies so.
void add_pieces(const std::vector<assets::ContactPiece>& pieces,
                const Pose& pose,
                Obstacles& obstacles);

}  // namespace marketgen::motion
