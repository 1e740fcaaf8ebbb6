// Takes the noise out of path-traced light and leaves its edges: the à-trous wavelet filter
// (Dammertz et al., HPG 2010) between pixels that show the same surface, with the light's own
// measured variance deciding what is an edge, as in SVGF (Schied et al., HPG 2017), on small
// patches, as in non-local means (Rousselle et al. 2012). Print and textures are in the albedo,
// which is not filtered.
#pragma once
#include "render/path/path_film.h"

namespace marketgen::render::raytrace {

// Smooths the film's irradiance and gloss in place. `guides` are of the same size. Deterministic
// for any thread count; about 1 s a megapixel on two cores.
void denoise(PathFilm& film, const PictureGuides& guides);

}  // namespace marketgen::render::raytrace
