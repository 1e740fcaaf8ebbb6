#include "render/film.h"

#include "render/shading_math.h"

namespace marketgen::raytrace {
namespace {

std::size_t pixels(int w, int h) {
  return static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
}

}  // namespace

Film::Film(int w, int h)
    : width(w),
      height(h),
      position(pixels(w, h)),
      normal(pixels(w, h)),
      depth(pixels(w, h)),
      instance(pixels(w, h)),
      material(pixels(w, h)),
      matter(pixels(w, h)),
      albedo(pixels(w, h)),
      irradiance(pixels(w, h)),
      reflectance(pixels(w, h)),
      gloss(pixels(w, h)),
      emission(pixels(w, h)),
      transmittance(pixels(w, h)),
      overlay(pixels(w, h)) {}

Vec3f Film::radiance(std::size_t i) const {
  const Vec3f behind = albedo.at(i) * irradiance.at(i) * inverse_pi +
                       reflectance.at(i) * gloss.at(i) + emission.at(i);
  return transmittance.at(i) * behind + overlay.at(i);
}

}  // namespace marketgen::raytrace
