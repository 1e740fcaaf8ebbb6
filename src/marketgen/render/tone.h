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

// Linear RGB (Rec. 709, unit luminance) of a black body at `kelvin`, 1000..40000 K.
Vec3f black_body(double kelvin);

}  // namespace marketgen::render::raytrace
