#include "render/tone.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

// AgX by T. Sobotka in B. Wrensch's polynomial form: inset, log2 range, sigmoid, outset.
constexpr float low_stop = -12.47393F, high_stop = 4.026069F;

float sigmoid(float x) {
  const float x2 = x * x, x4 = x2 * x2;
  return 15.5F * x4 * x2 - 40.14F * x4 * x + 31.96F * x4 - 6.868F * x2 * x + 0.4298F * x2 +
         0.1191F * x - 0.00232F;
}

float curve(float linear) {
  const float stops = std::log2(std::max(linear, 1e-8F));
  return std::max(0.0F,
                  sigmoid(std::clamp((stops - low_stop) / (high_stop - low_stop), 0.0F, 1.0F)));
}

// A look on top: AgX alone is flat, made for grading.
constexpr float look_contrast = 1.35F, look_saturation = 1.18F, look_gain = 1.10F;
// Interreflection lifts a furnished room above its lamps' own lux; this puts white paper at nine
// tenths of the screen's white.
constexpr float base_exposure = 0.78F;

}  // namespace

ToneCurve::ToneCurve() {
  for (std::size_t i = 0; i < table_.size(); ++i) {
    // Floats of one exponent lie evenly: the middle of a step.
    const auto step = static_cast<int>(i);
    const float mantissa = 1 + (static_cast<float>(step % steps_per_stop) + 0.5F) / steps_per_stop;
    const float linear = std::ldexp(mantissa, lowest_stop + step / steps_per_stop);
    table_[i] = std::pow(curve(linear), look_contrast) * look_gain;
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
  const Vec8 c = exposed * Float8(base_exposure);
  const Float8 x = at(0.842479062F * c.x + 0.0784335999F * c.y + 0.0792237451F * c.z);
  const Float8 y = at(0.0423282422F * c.x + 0.878468636F * c.y + 0.0791661274F * c.z);
  const Float8 z = at(0.0423756549F * c.x + 0.0784336F * c.y + 0.879142973F * c.z);
  const Float8 grey = 0.2126F * x + 0.7152F * y + 0.0722F * z;
  const Float8 dx = grey + (x - grey) * look_saturation;
  const Float8 dy = grey + (y - grey) * look_saturation;
  const Float8 dz = grey + (z - grey) * look_saturation;
  const auto byte = [](Float8 value) {
    return to_int(clamp(value, Float8(0), Float8(1)) * 255 + 0.5F);
  };
  const Int8 r = byte(1.19687900F * dx - 0.0980208811F * dy - 0.0990297441F * dz);
  const Int8 g = byte(-0.0528968518F * dx + 1.15190313F * dy - 0.0989611768F * dz);
  const Int8 b = byte(-0.0529716355F * dx - 0.0980434501F * dy + 1.15107367F * dz);
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
