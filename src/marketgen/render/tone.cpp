#include "render/tone.h"

#include <algorithm>
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

std::uint8_t to_byte(float x) {
  return static_cast<std::uint8_t>(std::clamp(x, 0.0F, 1.0F) * 255 + 0.5F);
}

}  // namespace

Rgb8 display_color(Vec3f exposed) {
  const Vec3f c = is_finite(exposed) ? exposed * base_exposure : Vec3f{};
  Vec3f d{curve(0.842479062F * c.x + 0.0784335999F * c.y + 0.0792237451F * c.z),
          curve(0.0423282422F * c.x + 0.878468636F * c.y + 0.0791661274F * c.z),
          curve(0.0423756549F * c.x + 0.0784336F * c.y + 0.879142973F * c.z)};
  d = Vec3f{std::pow(d.x, look_contrast),
            std::pow(d.y, look_contrast),
            std::pow(d.z, look_contrast)} *
      look_gain;
  const float grey = luminance(d);
  d = mix({grey, grey, grey}, d, look_saturation);
  return {to_byte(1.19687900F * d.x - 0.0980208811F * d.y - 0.0990297441F * d.z),
          to_byte(-0.0528968518F * d.x + 1.15190313F * d.y - 0.0989611768F * d.z),
          to_byte(-0.0529716355F * d.x - 0.0980434501F * d.y + 1.15107367F * d.z)};
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
