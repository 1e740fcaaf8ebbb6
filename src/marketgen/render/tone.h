// From radiance to what a screen shows: exposure, the AgX film curve, sRGB bytes.
#pragma once
#include <array>
#include <cstdint>

#include "geometry/image.h"
#include "geometry/vector.h"
#include "render/sensor/float8.h"

namespace marketgen::render::raytrace {

// `radiance` times exposure: 1 is a white sheet under the store's own light.
Rgb8 display_color(Vec3f exposed);

// The same for eight pixels: the film curve as a table over the logarithm of its input, within a
// third of a byte's step.
class ToneCurve {
 public:
  ToneCurve();
  // Three bytes a pixel, one after another.
  using Pixels = std::array<std::uint8_t, 3 * lane_count>;
  Pixels shown(const Vec8& exposed) const;

 private:
  static constexpr int steps_per_stop = 128, lowest_stop = -13, stops = 18;
  Float8 at(Float8 linear) const;
  std::array<float, steps_per_stop * stops> table_;
};
const ToneCurve& tone_curve();

// What the curve takes, under light that is `light` times as much in each channel.
inline Vec8 exposed(const Vec8& radiance, float exposure, Vec3f light) {
  const Vec8 meant = radiance * Float8(exposure);
  return {meant.x * Float8(light.x), meant.y * Float8(light.y), meant.z * Float8(light.z)};
}

// Linear RGB (Rec. 709, unit luminance) of a black body at `kelvin`, 1000..40000 K.
Vec3f black_body(double kelvin);

}  // namespace marketgen::render::raytrace
