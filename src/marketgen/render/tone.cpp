#include "render/tone.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "geometry/srgb.h"
#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

constexpr float mid_gain = 1.12F;  // of what lies between toe and shoulder
// Blacks lose more than half of their light, greys little.
constexpr float toe_low = 0.012F, toe_high = 0.03F;
constexpr float shoulder_from = 0.5F;  // of the screen's light
constexpr float clipped_from = 12;     // times white: the screen's white

// Extended Reinhard over what is left of the screen's light: its slope goes on from the middle's.
float shoulder(float light) {
  constexpr float left = 1 - shoulder_from;
  constexpr float farthest = (mid_gain * clipped_from - shoulder_from) / left;
  const float over = (light - shoulder_from) / left;
  return shoulder_from + left * over * (1 + over / (farthest * farthest)) / (1 + over);
}

}  // namespace

float film_curve(float exposed) {
  const float meant = mid_gain * std::max(exposed, 0.0F);
  const float light = meant * (meant + toe_low) / (meant + toe_high);
  const float compressed = light < shoulder_from ? light : shoulder(light);
  return static_cast<float>(srgb_encoded(static_cast<double>(std::min(compressed, 1.0F))));
}

FilmTable film_table() {
  FilmTable table{};
  for (std::size_t i = 0; i < table.values.size(); ++i) {
    const float steps = static_cast<float>(i) / FilmTable::steps_per_stop;
    table.values[i] = film_curve(std::exp2(FilmTable::first_stop + steps));
  }
  return table;
}

ToneCurve::ToneCurve() {
  for (std::size_t i = 0; i < table_.size(); ++i) {
    // Floats of one exponent lie evenly: the middle of a step.
    const auto step = static_cast<int>(i);
    const float mantissa = 1 + (static_cast<float>(step % steps_per_stop) + 0.5F) / steps_per_stop;
    const float linear = std::ldexp(mantissa, lowest_stop + step / steps_per_stop);
    table_[i] = film_curve(linear);
  }
}

Float8 ToneCurve::at(Float8 linear) const {
  constexpr int bits_per_step = 23 - 7;  // of a float's mantissa; 2^7 steps a stop
  static_assert(steps_per_stop == 1 << 7);
  constexpr int first = (127 + lowest_stop) << 7;
  // As positive floats: their bits grow with them.
  const Float8 lowest = float_of_bits(Int8(first << bits_per_step));
  const Int8 step = (bits_of(max(linear, lowest)) >> bits_per_step) - first;
  return gathered(table_.data(), min(step, Int8(static_cast<int>(table_.size()) - 1)));
}

ToneCurve::Pixels ToneCurve::shown(const Vec8& exposed) const {
  const auto byte = [this](Float8 channel) { return to_int(at(channel) * 255 + 0.5F); };
  const Int8 r = byte(exposed.x), g = byte(exposed.y), b = byte(exposed.z);
  // Four bytes a pixel to three: twelve in each half of the register.
  const __m256i order = _mm256_setr_epi8(0,
                                         1,
                                         2,
                                         4,
                                         5,
                                         6,
                                         8,
                                         9,
                                         10,
                                         12,
                                         13,
                                         14,
                                         -1,
                                         -1,
                                         -1,
                                         -1,
                                         0,
                                         1,
                                         2,
                                         4,
                                         5,
                                         6,
                                         8,
                                         9,
                                         10,
                                         12,
                                         13,
                                         14,
                                         -1,
                                         -1,
                                         -1,
                                         -1);
  alignas(32) std::array<std::uint8_t, 32> spread;
  Int8(_mm256_shuffle_epi8((r | (g << 8) | (b << 16)).m, order)).store(spread.data());
  Pixels pixels;
  std::copy_n(spread.begin(), 12, pixels.begin());
  std::copy_n(spread.begin() + 16, 12, pixels.begin() + 12);
  return pixels;
}

const ToneCurve& tone_curve() {
  static const ToneCurve curve;
  return curve;
}

Rgb8 display_color(Vec3f exposed) {
  const ToneCurve::Pixels rgb = tone_curve().shown(all(is_finite(exposed) ? exposed : Vec3f{}));
  return {rgb[0], rgb[1], rgb[2]};
}

Vec3f black_body(double kelvin) {
  // CIE 1931 chromaticity of the Planckian locus (Kim et al., US patent 7024034).
  const double t = std::clamp(kelvin, 1667.0, 25000.0);
  const double x =
      t < 4000 ? -0.2661239e9 / (t * t * t) - 0.2343589e6 / (t * t) + 0.8776956e3 / t + 0.179910
               : -3.0258469e9 / (t * t * t) + 2.1070379e6 / (t * t) + 0.2226347e3 / t + 0.240390;
  const double y =
      t < 2222   ? -1.1063814 * x * x * x - 1.34811020 * x * x + 2.18555832 * x - 0.20219683
      : t < 4000 ? -0.9549476 * x * x * x - 1.37418593 * x * x + 2.09137015 * x - 0.16748867
                 : 3.0817580 * x * x * x - 5.87338670 * x * x + 3.75112997 * x - 0.37001483;
  const double big_x = x / y, big_z = (1 - x - y) / y;  // luminance 1
  const Vec3 rgb{3.2404542 * big_x - 1.5371385 - 0.4985314 * big_z,
                 -0.9692660 * big_x + 1.8760108 + 0.0415560 * big_z,
                 0.0556434 * big_x - 0.2040259 + 1.0572252 * big_z};
  const Vec3f color =
      to_float(Vec3{std::max(rgb.x, 0.0), std::max(rgb.y, 0.0), std::max(rgb.z, 0.0)});
  return color / luminance(color);
}

}  // namespace marketgen::render::raytrace
