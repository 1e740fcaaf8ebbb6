// What a lens does to light on its way to the film: glare about lamps, and corners that get less.
#pragma once
#include "render/cameras/view.h"
#include "render/path/path_film.h"

namespace marketgen::render::raytrace {

// `light` with the share of `beyond` that a lens scatters, spread widely about where it comes from.
// `beyond` is what of the lamps' light a screen could not show (PathLight::beyond); both are rows
// of `width` pixels. What lands beside the picture is lost.
ColorPlanes with_glare(ColorPlanes light, const ColorPlanes& beyond, int width);

// Share of the light that arrives at a direction which is `cosine` from the lens's axis.
float arriving_share(float cosine);

}  // namespace marketgen::render::raytrace
