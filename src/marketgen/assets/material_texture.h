// Tileable colour textures of catalogue materials, drawn by rule.
#pragma once
#include "catalog/rows.h"
#include "geometry/image.h"

namespace marketgen {

// One repeat of the material; covers `material_extent_m` by the same along both axes. Seamless;
// deterministic.
Image draw_material(const MaterialRow& material, int size_px = 512);
// Side of the square that the texture covers, metres: metric UVs are divided by it.
double material_extent_m(const MaterialRow& material);

}  // namespace marketgen
