#include "render/tone.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "render/shading_math.h"

namespace marketgen::raytrace {
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

float ToneCurve::at(float linear) const {
  constexpr int bits_per_step = 23 - 7;  // of a float's mantissa; 2^7 steps a stop
  static_assert(steps_per_stop == 1 << 7);
  constexpr int first = (127 + lowest_stop) << 7;
  const int step = (std::bit_cast<std::int32_t>(linear) >> bits_per_step) - first;
  return table_[static_cast<std::size_t>(std::clamp(step, 0, static_cast<int>(table_.size()) - 1))];
}

void ToneCurve::write(std::span<const Float4> radiance, float exposure, std::uint8_t* rgb) const {
  constexpr std::size_t most = 64;  // at a time
  std::array<float, most> r, g, b;
  for (std::size_t first = 0; first < radiance.size(); first += most) {
    const std::size_t count = std::min(most, radiance.size() - first);
    const float scale = exposure * base_exposure;
    for (std::size_t i = 0; i < count; ++i) {
      const Float4 c = radiance[first + i] * scale;
      r[i] = c.x();
      g[i] = c.y();
      b[i] = c.z();
    }
    for (std::size_t i = 0; i < count; ++i) {
      const float x = at(0.842479062F * r[i] + 0.0784335999F * g[i] + 0.0792237451F * b[i]);
      const float y = at(0.0423282422F * r[i] + 0.878468636F * g[i] + 0.0791661274F * b[i]);
      const float z = at(0.0423756549F * r[i] + 0.0784336F * g[i] + 0.879142973F * b[i]);
      const float grey = 0.2126F * x + 0.7152F * y + 0.0722F * z;
      const float dx = grey + (x - grey) * look_saturation;
      const float dy = grey + (y - grey) * look_saturation;
      const float dz = grey + (z - grey) * look_saturation;
      r[i] = 1.19687900F * dx - 0.0980208811F * dy - 0.0990297441F * dz;
      g[i] = -0.0528968518F * dx + 1.15190313F * dy - 0.0989611768F * dz;
      b[i] = -0.0529716355F * dx - 0.0980434501F * dy + 1.15107367F * dz;
    }
    const auto byte = [](float x) {
      return static_cast<std::uint8_t>(std::min(std::max(x, 0.0F), 1.0F) * 255 + 0.5F);
    };
    std::uint8_t* to = rgb + 3 * first;
    for (std::size_t i = 0; i < count; ++i) {
      to[3 * i] = byte(r[i]);
      to[3 * i + 1] = byte(g[i]);
      to[3 * i + 2] = byte(b[i]);
    }
  }
}

const ToneCurve& tone_curve() {
  static const ToneCurve curve;
  return curve;
}

Rgb8 display_color(Vec3f exposed) {
  std::array<std::uint8_t, 3> rgb{};
  const Float4 pixel(is_finite(exposed) ? exposed : Vec3f{});
  tone_curve().write(std::span(&pixel, 1), 1, rgb.data());
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

}  // namespace marketgen::raytrace
