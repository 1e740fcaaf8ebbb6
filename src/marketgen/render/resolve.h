// From filtered light to pixels: edges drawn with extra samples, then tone mapping.
#pragma once
#include "geometry/image.h"
#include "render/film.h"
#include "render/sensor_light.h"
#include "render/view.h"

namespace marketgen::raytrace {

// Radiance of every pixel. Where surfaces meet inside a pixel, `edge_samples` more primary rays
// each take the light of the neighbouring pixel that shows the same surface; 0 = none.
Planes3 resolve_edges(const Lighting& lighting,
                      const View& view,
                      const Film& film,
                      unsigned opaque_mask,
                      int edge_samples);

Image develop(const Planes3& radiance, int width, int height, float exposure);

}  // namespace marketgen::raytrace
