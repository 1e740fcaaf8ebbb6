// A texture while one pattern is drawn on it: its scale in millimetres, its random numbers, and the
// fields drawn so far.
//
// Every pattern of catalog/material_patterns.inc is one function here, draw_<name>(PatternSheet&),
// that starts from a flat sheet.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "assets/materials/material_pattern.h"

namespace marketgen::assets {

struct Texel {
  float &mark, &third, &light, &height_mm, &roughness, &metal;
};

struct PatternSheet {
  PatternSheet(const catalog::MaterialRow& material, int side_px, const Seed& material_seed);

  const catalog::MaterialRow& row;
  int size_px;
  int periods;    // of the pattern along the side
  float side_mm;  // of the whole texture
  float mm_per_px;
  float variation;  // the row's, between pieces
  Seed seed;
  MaterialLook look;

  float period_mm() const { return side_mm / static_cast<float>(periods); }
  float joint_mm(float usual) const {
    return row.joint_mm > 0 ? static_cast<float>(row.joint_mm) : usual;
  }
  float aspect(float usual) const {
    return row.aspect > 0 ? static_cast<float>(row.aspect) : usual;
  }
  float roughness() const { return static_cast<float>(row.roughness); }

  Texel texel(std::size_t i) {
    return {look.mark.values[i],
            look.third.values[i],
            look.light.values[i],
            look.height_mm.values[i],
            look.roughness.values[i],
            look.metal.values[i]};
  }
  // paint(texel, x, y) for every texel.
  template <class Paint>
  void each_texel(const Paint& paint) {
    for (int y = 0; y < size_px; ++y) {
      for (int x = 0; x < size_px; ++x)
        paint(texel(index(x, y)), x, y);
    }
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_px) +
           static_cast<std::size_t>(x);
  }

  // Whole pieces of about `size_mm` along the side, at least one.
  int count_of(float size_mm) const {
    return std::max(1, static_cast<int>(std::lround(side_mm / size_mm)));
  }
  // Noise with features of `size_mm`, drawn from the stream `name`.
  TextureField noise(std::string_view name,
                     float size_mm,
                     int octaves,
                     float falloff = 0.55F) const;
  // Features of `x_mm` by `y_mm`.
  TextureField streaks(std::string_view name, float x_mm, float y_mm, int octaves) const;

  // Distance in millimetres from texel `i` of an axis to the nearest of the lines that cut the
  // texture into `parts`.
  float to_line_mm(int i, int parts) const;
  // 1 within `width` of a line at `distance` (never thinner than a texel), 0 beside it.
  float line(float distance_mm, float width_mm) const;
  // 1 where `distance_mm` is below 0, 0 above, as soft as a texel.
  float inside(float distance_mm) const;
};

// Adds what a field differs from a half, times twice `depth`.
void add_centred(TextureField& to, const TextureField& field, float depth);

// A number 0..1 that belongs to piece `id`, the same wherever the piece is met.
float piece_number(const Seed& seed, std::uint32_t id);

constexpr float mixed(float a, float b, float share_of_b) {
  return a + (b - a) * share_of_b;
}
// x less its whole part, for x of either sign.
constexpr float fraction(float x) {
  const float rest = x - static_cast<float>(static_cast<int>(x));
  return rest < 0 ? rest + 1 : rest;
}
// A smooth wave of period 1: 1 at whole numbers, 0 half way.
constexpr float wave(float x) {
  const float t = fraction(x);
  return smooth_step(0, 1, t < 0.5F ? 1 - 2 * t : 2 * t - 1);
}

#define MATERIAL_PATTERN(name, periods, description) void draw_##name(PatternSheet& sheet);
#include "catalog/material_patterns.inc"
#undef MATERIAL_PATTERN

}  // namespace marketgen::assets
