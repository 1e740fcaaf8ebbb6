#include "assets/materials/pieces.h"
#include "assets/materials/wood_grain.h"

namespace marketgen::assets {
namespace {

constexpr float t_bar_mm = 24;

}  // namespace

// Mineral-fibre tiles in white T-bars.
void draw_ceiling_grid(PatternSheet& sheet) {
  const int n = sheet.size_px, tiles = sheet.periods;
  const TextureField pores =
      bump_field(n, n, {130, 130, 0.34F, 1.0F, 0.6F, 0.5F}, sheet.seed.child("pores"));
  sheet.each_texel([&](Texel t, int x, int y) {
    const float edge = std::min(sheet.to_line_mm(x, tiles), sheet.to_line_mm(y, tiles));
    const float bar = sheet.line(edge, t_bar_mm);
    const float recess = sheet.line(edge, t_bar_mm + 14) * (1 - bar);  // shadow beside the bar
    const float pore = smooth_step(0.1F, 0.8F, pores.row(y)[x]) * (1 - bar);
    t.mark = pore * 0.9F;
    t.light += bar * 0.03F - recess * 0.12F;
    t.height_mm = -1.5F * pore - 4 * recess;
    t.roughness = -0.4F * bar;
  });
}

// Open cells of sheet metal: what is above them is dark.
void draw_open_grid(PatternSheet& sheet) {
  const float bar_mm = sheet.joint_mm(10);
  const int cells = sheet.periods;
  sheet.each_texel([&](Texel t, int x, int y) {
    const float edge = std::min(sheet.to_line_mm(x, cells), sheet.to_line_mm(y, cells));
    const float bar = sheet.line(edge, bar_mm);
    // The cell's walls are seen fading into the void.
    const float depth = smooth_step(bar_mm / 2, sheet.period_mm() * 0.42F, edge);
    t.mark = (1 - bar) * (0.55F + 0.45F * depth);
    t.height_mm = -12 * (1 - bar) * depth;
    t.roughness = 0.3F * (1 - bar);
    t.metal = bar;
  });
}

// Bars along x: slat walls, baffles, battens.
void draw_slats(PatternSheet& sheet) {
  const int bars = sheet.periods;
  const float gap = sheet.joint_mm(12);
  const auto pieces =
      lay_pieces(sheet, [&](float x, float y) { return grid_piece(sheet, 1, bars, 0, x, y); });
  if (sheet.row.variation > 0) {
    grow_wood(sheet, pieces, 0.5F * sheet.variation);
    tone_pieces(sheet, pieces, 0.06F);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float across = std::min(pieces[i].across_mm, sheet.period_mm() - pieces[i].across_mm);
    const float open = sheet.line(across, gap);
    const float shade = sheet.row.third_color.empty() ? 0 : open;
    t.third = shade;
    t.light *= 1 - open * (sheet.row.third_color.empty() ? 0.72F : 0.1F);
    t.height_mm -= 12 * (1 - smooth_step(gap / 2 - 1, gap / 2 + 2.5F, across));
    t.roughness += open * (0.9F - sheet.roughness());
  }
}

}  // namespace marketgen::assets
