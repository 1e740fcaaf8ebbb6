#include "assets/material_pattern.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace marketgen {
namespace {

// Sizes of joints and bars, as built.
constexpr float grout_mm = 3;
constexpr float mortar_mm = 10;
constexpr float plank_gap_mm = 1.5F;
constexpr float t_bar_mm = 24;
// Height of a brick course over its length: (65 + 10) over (240 + 10) mm of the normal format, DIN
// 4172.
constexpr double course_aspect = 0.30;

// Measures of one texture.
struct Grid {
  int size_px;
  float mm_per_px;

  // Distance in millimetres from texel `i` to the nearest of the lines that cut the texture into
  // `parts`.
  float to_line_mm(int i, int parts) const {
    const float part = static_cast<float>(size_px) / static_cast<float>(parts);
    const float at = static_cast<float>(i) + 0.5F;
    const float inside = at - part * static_cast<float>(static_cast<int>(at / part));
    return std::min(inside, part - inside) * mm_per_px;
  }
  // 1 on a line of `width` (never thinner than a texel), 0 beside it.
  float line(float distance_mm, float width_mm) const {
    const float half = std::max(width_mm, mm_per_px) / 2;
    return 1 - smooth_step(half - mm_per_px / 2, half + mm_per_px / 2, distance_mm);
  }
};

MaterialLook flat_look(int size_px) {
  return {TextureField(size_px, size_px, 0), TextureField(size_px, size_px, 1)};
}

void add_light(MaterialLook& look, const TextureField& field, float depth) {
  for (std::size_t i = 0; i < field.values.size(); ++i)
    look.light.values[i] += (field.values[i] - 0.5F) * 2 * depth;
}

// One brightness for every piece of a pattern.
std::vector<float> piece_tones(int count, float depth, const Seed& seed) {
  Stream draw = seed.stream();
  std::vector<float> tones(static_cast<std::size_t>(count));
  for (float& tone : tones)
    tone = static_cast<float>(draw.uniform(-1, 1)) * depth;
  return tones;
}

MaterialLook plain_look(const Grid& grid, const Seed& seed) {
  MaterialLook look = flat_look(grid.size_px);
  look.mark = noise_field(grid.size_px, grid.size_px, {4, 4, 5, 0.6F}, seed.child("clouds"));
  add_light(look,
            noise_field(grid.size_px, grid.size_px, {128, 128, 2, 0.8F}, seed.child("grain")),
            0.02F);
  return look;
}

MaterialLook tile_look(const Grid& grid, int tiles, const Seed& seed) {
  const int n = grid.size_px;
  MaterialLook look = flat_look(n);
  add_light(look, noise_field(n, n, {10, 10, 5, 0.6F}, seed.child("clouds")), 0.05F);
  const std::vector<float> tones = piece_tones(tiles * tiles, 0.025F, seed.child("tones"));
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const float edge = std::min(grid.to_line_mm(x, tiles), grid.to_line_mm(y, tiles));
      look.mark.row(y)[x] = grid.line(edge, grout_mm);
      const int tile = y * tiles / n * tiles + x * tiles / n;
      look.light.row(y)[x] += tones[static_cast<std::size_t>(tile)];
    }
  }
  return look;
}

// Boards along x, each with its own grain and one butt joint.
MaterialLook plank_look(const Grid& grid, int planks, const Seed& seed) {
  const int n = grid.size_px;
  MaterialLook look = flat_look(n);
  const TextureField grain = noise_field(n, n, {3, 72, 3, 0.6F}, seed.child("grain"));
  const TextureField figure = noise_field(n, n, {4, 20, 3, 0.5F}, seed.child("figure"));
  const std::vector<float> tones = piece_tones(planks, 0.07F, seed.child("tones"));
  Stream draw = seed.child("joints").stream();
  std::vector<int> shifts(static_cast<std::size_t>(planks));
  for (int& shift : shifts)
    shift = draw.integer(0, n - 1);
  for (int y = 0; y < n; ++y) {
    const int plank = y * planks / n;
    const int shift = shifts[static_cast<std::size_t>(plank)];
    const float* grain_row = grain.row((y + shift) % n);
    const float* figure_row = figure.row((y + shift * 3) % n);
    const float side = grid.to_line_mm(y, planks);
    for (int x = 0; x < n; ++x) {
      const int along = (x + shift) % n;
      const float joint = std::min(
          grid.line(side, plank_gap_mm) + grid.line(grid.to_line_mm(along, 1), plank_gap_mm), 1.0F);
      const float wood =
          smooth_step(0.35F, 0.75F, grain_row[along] * 0.6F + figure_row[along] * 0.45F);
      look.mark.row(y)[x] = std::min(1.0F, wood * 0.55F + joint * 0.5F);
      look.light.row(y)[x] += tones[static_cast<std::size_t>(plank)] - joint * 0.45F;
    }
  }
  return look;
}

MaterialLook terrazzo_look(const Grid& grid, const Seed& seed) {
  const int n = grid.size_px;
  MaterialLook look = flat_look(n);
  // Chips of 4 to 20 mm over 1.2 m: a coarse and a fine sieve.
  const TextureField coarse =
      bump_field(n, n, {52, 52, 0.62F, 0.9F, 0.6F, 0.55F}, seed.child("coarse"));
  const TextureField fine =
      bump_field(n, n, {120, 120, 0.55F, 0.9F, 0.5F, 0.5F}, seed.child("fine"));
  const TextureField edge = noise_field(n, n, {160, 160, 2, 0.6F}, seed.child("edge"));
  const TextureField tone = noise_field(n, n, {70, 70, 1, 0.5F}, seed.child("tone"));
  for (std::size_t i = 0; i < look.mark.values.size(); ++i) {
    const float rough = (edge.values[i] - 0.5F) * 0.9F;
    const float chip = std::max(smooth_step(0.30F, 0.45F, coarse.values[i] + rough),
                                smooth_step(0.40F, 0.55F, fine.values[i] + rough) * 0.7F);
    // Some chips are dark, some lighter than the binder.
    const bool light_chip = tone.values[i] > 0.56F;
    look.mark.values[i] = light_chip ? 0 : chip * (0.25F + tone.values[i] * 0.8F);
    look.light.values[i] += light_chip ? chip * 0.07F : 0;
  }
  return look;
}

// Rough bricks are burnt unevenly, glazed ones (metro tiles) are alike.
MaterialLook brick_look(const Grid& grid, int bricks, double roughness, const Seed& seed) {
  const int n = grid.size_px;
  const int courses = std::max(
      2,
      static_cast<int>(std::lround(bricks / course_aspect / 2)) * 2);  // even: the bond must close
  MaterialLook look = flat_look(n);
  add_light(look,
            noise_field(n, n, {40, 40, 4, 0.6F}, seed.child("sand")),
            0.11F * static_cast<float>(roughness));
  const std::vector<float> tones =
      piece_tones(courses * bricks, 0.11F * static_cast<float>(roughness), seed.child("tones"));
  for (int y = 0; y < n; ++y) {
    const int course = y * courses / n;
    const int shift = course % 2 == 0 ? 0 : n / bricks / 2;
    const float bed = grid.to_line_mm(y, courses);
    for (int x = 0; x < n; ++x) {
      const int along = (x + shift) % n;
      const float joint = grid.line(std::min(bed, grid.to_line_mm(along, bricks)), mortar_mm);
      look.mark.row(y)[x] = joint;
      const int brick = course * bricks + along * bricks / n;
      look.light.row(y)[x] += tones[static_cast<std::size_t>(brick)] * (1 - joint);
    }
  }
  return look;
}

MaterialLook concrete_look(const Grid& grid, const Seed& seed) {
  const int n = grid.size_px;
  MaterialLook look = flat_look(n);
  const TextureField clouds = noise_field(n, n, {3, 3, 6, 0.6F}, seed.child("clouds"));
  const TextureField holes =
      bump_field(n, n, {60, 60, 0.14F, 1.0F, 0.8F, 0.25F}, seed.child("holes"));
  for (std::size_t i = 0; i < look.mark.values.size(); ++i) {
    look.mark.values[i] = smooth_step(0.25F, 0.75F, clouds.values[i]);
    look.light.values[i] -= smooth_step(0.2F, 0.9F, holes.values[i]) * 0.16F;
  }
  add_light(look, noise_field(n, n, {150, 150, 2, 0.8F}, seed.child("grain")), 0.035F);
  return look;
}

// Mineral-fibre tiles in white T-bars.
MaterialLook ceiling_look(const Grid& grid, int tiles, const Seed& seed) {
  const int n = grid.size_px;
  MaterialLook look = flat_look(n);
  const TextureField pores =
      bump_field(n, n, {130, 130, 0.34F, 1.0F, 0.6F, 0.5F}, seed.child("pores"));
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const float edge = std::min(grid.to_line_mm(x, tiles), grid.to_line_mm(y, tiles));
      const float bar = grid.line(edge, t_bar_mm);
      const float recess =
          grid.line(edge, t_bar_mm + 14) * (1 - bar);  // the shadow line beside the bar
      look.mark.row(y)[x] = smooth_step(0.1F, 0.8F, pores.row(y)[x]) * 0.9F * (1 - bar);
      look.light.row(y)[x] += bar * 0.03F - recess * 0.12F;
    }
  }
  return look;
}

MaterialLook brushed_look(const Grid& grid, const Seed& seed) {
  const int n = grid.size_px;
  MaterialLook look = flat_look(n);
  look.mark = noise_field(n, n, {6, 170, 2, 0.7F}, seed.child("strokes"));
  add_light(look, noise_field(n, n, {2, 90, 3, 0.7F}, seed.child("bands")), 0.05F);
  return look;
}

}  // namespace

int periods_in_texture(MaterialPattern pattern) {
  switch (pattern) {
    case MaterialPattern::tiles:
    case MaterialPattern::terrazzo:
    case MaterialPattern::ceiling_grid:
      return 2;
    case MaterialPattern::planks:
      return 8;
    case MaterialPattern::brick:
    case MaterialPattern::brushed:
      return 4;
    case MaterialPattern::plain:
    case MaterialPattern::concrete:
      return 1;
  }
  return 1;
}

MaterialLook material_look(const MaterialRow& material, int size_px, const Seed& seed) {
  const int periods = periods_in_texture(material.pattern);
  const Grid grid{size_px,
                  static_cast<float>(material.period_mm * periods) / static_cast<float>(size_px)};
  switch (material.pattern) {
    case MaterialPattern::plain:
      return plain_look(grid, seed);
    case MaterialPattern::tiles:
      return tile_look(grid, periods, seed);
    case MaterialPattern::planks:
      return plank_look(grid, periods, seed);
    case MaterialPattern::terrazzo:
      return terrazzo_look(grid, seed);
    case MaterialPattern::brick:
      return brick_look(grid, periods, material.roughness, seed);
    case MaterialPattern::concrete:
      return concrete_look(grid, seed);
    case MaterialPattern::ceiling_grid:
      return ceiling_look(grid, periods, seed);
    case MaterialPattern::brushed:
      return brushed_look(grid, seed);
  }
  return flat_look(size_px);
}

}  // namespace marketgen
