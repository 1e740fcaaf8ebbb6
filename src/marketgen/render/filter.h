// Edge-aware smoothing of noisy light: the à-trous wavelet filter (Dammertz et al., HPG 2010),
// guided by geometry and by the light's own noise as in SVGF (Schied et al., HPG 2017). Albedo is
// not in it, so print and textures stay sharp.
#pragma once
#include "render/film.h"

namespace marketgen::raytrace {

struct FilterSettings {
  int passes = 4;             // reach: 2 * (2^passes - 1) pixels
  float noise_tolerance = 4;  // differences of this many standard deviations are edges
  bool same_material_only = false;
};

// Cuts every pixel down to the third brightest of the eight around it: single bright samples go,
// lines and areas stay.
void remove_sparkles(const Film& film, Planes3& light);

// Smooths `light` in place.
void smooth(const Film& film, Planes3& light, const FilterSettings& settings);

}  // namespace marketgen::raytrace
