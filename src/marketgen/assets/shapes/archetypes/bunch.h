// Things sold as a handful: what holds them together.
#pragma once
#include "assets/shapes/archetypes/shell.h"

namespace marketgen::assets {

// A rubber band round stalks that run along Z: an oval ring of those half sizes at height z.
void add_rubber_band(
    PackBuilder& pack, Vec3f color, float z, Vec2f half, float thick, const Placement& place);

// An open rectangular punnet with sloping walls that fills the lower `height` of the pack.
void add_punnet(PackBuilder& pack, std::uint16_t surface, float height);

}  // namespace marketgen::assets
