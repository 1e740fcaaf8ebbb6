// Crusts, glazes and doughs of unwrapped bakery goods.
#pragma once
#include "assets/print/pack_art.h"
#include "geometry/image.h"

namespace marketgen::assets {

// Whether the archetype comes from the oven: its colours follow baked_skins.inc, not those of
// fruit.
bool is_baked(const catalog::Product& product);

// As draw_produce_skin. Precondition: is_baked.
Image draw_baked_skin(const PackArt& art, int width_px, int height_px);

}  // namespace marketgen::assets
