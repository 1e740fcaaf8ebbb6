// Flat parts: plates with a hole for fingers or a peg, and printed stickers.
#pragma once
#include "assets/shapes/archetypes/pack_builder.h"

namespace marketgen::assets {

// A plate in its own frame: x from the middle, z from its lower edge up, its front at y = 0, its
// back behind it. Rounded corners, bevelled edges, one rounded hole.
struct PlateForm {
  Vec3f size;  // width, thickness, height
  float corner_m = 0;
  Vec2f hole_middle, hole_size;  // x and z
  float hole_corner_m = 0;
};
void add_holed_plate(PackBuilder& pack,
                     const PlateForm& form,
                     std::uint16_t surface,
                     const Placement& place);

// A sticker on a flat place: the panel's print in front (y = 0), `edge` around and behind it.
void add_sticker(PackBuilder& pack,
                 const Panel* panel,
                 Vec3f size,
                 std::uint16_t print,
                 std::uint16_t edge,
                 const Placement& place);

}  // namespace marketgen::assets
