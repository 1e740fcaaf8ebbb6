#include "render/light/stored_light.h"

#include "render/shading_math.h"

namespace marketgen::render::raytrace {
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

}  // namespace marketgen::render::raytrace
