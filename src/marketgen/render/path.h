// Path tracing: diffuse and GGX surfaces, thin glass, lamps by multiple importance sampling,
// Russian roulette.
#pragma once
#include <cstdint>

#include "render/sensor_light.h"
#include "render/view.h"

namespace marketgen::raytrace {

// Sums over samples of one pixel, split for the filter.
struct PathSums {
  Vec3f albedo;   // of the first rough surface
  Vec3f diffuse;  // light that left it diffusely
  Vec3f other;    // everything else: mirrored, emitted, reflected by glass
};

// One path through point (x, y) of the picture, `number` its index among the pixel's samples. Adds
// to `sums`.
void add_path(const Lighting& lighting,
              const View& view,
              int x,
              int y,
              std::uint32_t number,
              unsigned camera_mask,
              PathSums& sums);

}  // namespace marketgen::raytrace
