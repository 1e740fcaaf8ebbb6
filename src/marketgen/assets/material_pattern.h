// The patterns of materials: how far each texel has the second colour, and how bright it is.
#pragma once
#include "assets/texture_field.h"
#include "catalog/rows.h"

namespace marketgen {

struct MaterialLook {
  TextureField mark;   // share of the second colour, 0..1
  TextureField light;  // factor on the colour, about 1
};

// Repeats of the pattern's period along the side of the texture.
int periods_in_texture(MaterialPattern pattern);

// Seamless along both axes. `size_px` texels a side.
MaterialLook material_look(const MaterialRow& material, int size_px, const Seed& seed);

}  // namespace marketgen
