// The patterns of materials: what colour each texel has, how high it lies and how rough it is.
//
// One height field lies behind colour, light and normals, so that what looks like a joint is one.
#pragma once
#include "assets/materials/texture_field.h"
#include "catalog/rows.h"

namespace marketgen::assets {

// Fields of one texture, all of one size and seamless along both axes.
struct MaterialLook {
  TextureField mark;       // share of the second colour, 0..1
  TextureField third;      // share of the third colour over both, 0..1
  TextureField light;      // factor on the colour, about 1
  TextureField height_mm;  // relief over any level
  TextureField roughness;  // added to the row's
  TextureField metal;      // factor on the row's metallic, 0..1

  explicit MaterialLook(int size_px)
      : mark(size_px, size_px),
        third(size_px, size_px),
        light(size_px, size_px, 1),
        height_mm(size_px, size_px),
        roughness(size_px, size_px),
        metal(size_px, size_px, 1) {}
};

// Repeats of the pattern's period along the side of the texture.
int periods_in_texture(catalog::MaterialPattern pattern);

// `size_px` texels a side. Deterministic.
MaterialLook material_look(const catalog::MaterialRow& material, int size_px, const Seed& seed);

}  // namespace marketgen::assets
