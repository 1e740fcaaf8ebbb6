// Tileable textures of catalogue materials, drawn by rule: colour, relief, gloss, metal.
#pragma once
#include "catalog/rows.h"
#include "geometry/image.h"

namespace marketgen::assets {

// One repeat of a material, `size_px` a side. Albedo stays within what real surfaces reflect, 0.02
// to 0.9.
struct MaterialMaps {
  Image base_color;  // sRGB
  // Tangent space, as glTF has it: red along the texture's rows, green towards its top, blue out of
  // the surface; 0.5 is zero.
  Image normal;
  Image roughness, metallic;  // one channel, linear
};

// Covers `material_extent_m` by the same. Seamless along both axes; deterministic.
MaterialMaps draw_material_maps(const catalog::MaterialRow& material, int size_px = 512);
// The colour alone.
Image draw_material(const catalog::MaterialRow& material, int size_px = 512);
// Side of the square that the texture covers, metres: metric UVs are divided by it.
double material_extent_m(const catalog::MaterialRow& material);

}  // namespace marketgen::assets
