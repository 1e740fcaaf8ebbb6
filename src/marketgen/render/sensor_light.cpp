#include "render/sensor_light.h"

#include <algorithm>
#include <cmath>

#include "render/shading_math.h"

namespace marketgen::raytrace {
namespace {

// Relief changes the light on a surface within these bounds, once it turns by about 2 degrees.
constexpr float darkest_relief = 0.3F, brightest_relief = 1.8F, least_turn = 6e-4F;

}  // namespace

float relief_shade(const Lighting& lighting, const Surface& surface) {
  if (dot(surface.relief_normal, surface.normal) > 1 - least_turn) return 1;
  const float shade = lighting.field.tilt(place_of(surface), surface.normal, surface.relief_normal);
  return std::clamp(shade, darkest_relief, brightest_relief);
}

Vec3f stored_radiance(const Lighting& lighting,
                      const Surface& surface,
                      Vec3f direction,
                      Lamps lamps) {
  const Place place = place_of(surface);
  Vec3f radiance = surface.diffuse() * lighting.field.at(place, surface.normal) * inverse_pi;
  if (surface.metallic > 0) {
    radiance += surface.albedo * surface.metallic *
                lighting.field.at(place, mirrored(direction, surface.normal)) * inverse_pi;
  }
  if (lamps == Lamps::seen || surface.light < 0) radiance += surface.emission;
  return radiance;
}

}  // namespace marketgen::raytrace
