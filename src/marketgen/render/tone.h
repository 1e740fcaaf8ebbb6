// From radiance to what a screen shows: exposure, the film curve, sRGB bytes.
//
// The curve takes each channel by itself, so that print keeps its colour: a label in the light that
// the picture is exposed for comes out nearly as its file has it. It has a soft toe, is straight
// through the middle (18 % grey at 119 of 255) and bends from there (paper of 80 % at 220, a sheet
// in twice the light at 242) to 12 times white.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "geometry/image.h"
#include "geometry/vector.h"
#include "render/sensor/float8.h"

namespace marketgen::render::raytrace {

// What a screen gets for one channel, sRGB-encoded 0..1. `exposed` is radiance times exposure: 1 is
// a white sheet in the light that the picture is exposed for.
float film_curve(float exposed);

// The curve for programs that draw elsewhere: its values at steps of a quarter of a stop from
// 2^first_stop on, straight between them within a byte's step.
struct FilmTable {
  static constexpr int first_stop = -13, steps_per_stop = 4;
  std::array<float, std::size_t{17 * steps_per_stop + 1}> values;
};
FilmTable film_table();

// Not finite: black.
Rgb8 display_color(Vec3f exposed);

// The same for eight pixels: the curve as a table over the logarithm of its input, within a third
// of a byte's step.
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
