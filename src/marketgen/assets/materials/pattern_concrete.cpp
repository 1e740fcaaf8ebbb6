#include "assets/materials/pieces.h"

namespace marketgen::assets {
namespace {

// Clouds of cement and the pores that air leaves in it.
void cast(PatternSheet& sheet, float pore_depth_mm) {
  const TextureField clouds = sheet.noise("clouds", 700, 6, 0.6F);
  const int pores = sheet.count_of(45);
  const TextureField holes = bump_field(sheet.size_px,
                                        sheet.size_px,
                                        {pores, pores, 0.12F, 1.0F, 0.8F, 0.4F},
                                        sheet.seed.child("holes"));
  for (std::size_t i = 0; i < clouds.values.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float hole = smooth_step(0.2F, 0.9F, holes.values[i]);
    t.mark = smooth_step(0.25F, 0.75F, clouds.values[i]);
    t.light -= 0.28F * hole;
    t.height_mm -= pore_depth_mm * hole;
  }
  const TextureField grain = sheet.noise("grain", 12, 3, 0.7F);
  add_centred(sheet.look.light, grain, 0.05F);
  add_centred(sheet.look.height_mm, grain, 0.25F);
  add_centred(sheet.look.roughness, clouds, 0.08F);
}

}  // namespace

void draw_concrete(PatternSheet& sheet) {
  const int n = sheet.size_px;
  const Seed& seed = sheet.seed;
  const TextureField clouds = noise_field(n, n, {3, 3, 6, 0.6F}, seed.child("clouds"));
  const TextureField holes =
      bump_field(n, n, {60, 60, 0.14F, 1.0F, 0.8F, 0.25F}, seed.child("holes"));
  const TextureField grain = noise_field(n, n, {150, 150, 2, 0.8F}, seed.child("grain"));
  for (std::size_t i = 0; i < clouds.values.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float hole = smooth_step(0.2F, 0.9F, holes.values[i]);
    t.mark = smooth_step(0.25F, 0.75F, clouds.values[i]);
    t.light -= hole * 0.16F;
    t.height_mm = -1.2F * hole * sheet.roughness();
  }
  add_centred(sheet.look.light, grain, 0.035F);
  add_centred(sheet.look.height_mm, grain, 0.5F * sheet.roughness());
  add_centred(sheet.look.roughness, clouds, 0.12F);
}

// Rough-sawn boards print their grain, their steps and the fins between them.
void draw_board_formed(PatternSheet& sheet) {
  const int boards = sheet.periods;
  const Seed butts = sheet.seed.child("butts");
  const auto pieces = lay_pieces(sheet, [&](float x, float y) {
    const auto row = static_cast<std::uint32_t>(y / sheet.side_mm * static_cast<float>(boards));
    return grid_piece(sheet, 1, boards, piece_number(butts, row), x, y);
  });
  cast(sheet, 2.5F);
  const TextureField grain = sheet.streaks("grain", 260, 5, 3);
  const TextureField figure = sheet.streaks("figure", 500, 30, 3);
  const Seed steps = sheet.seed.child("steps");
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Texel t = sheet.texel(i);
    const Piece& p = pieces[i];
    const float cut = piece_number(steps, p.id + 31);
    const auto size = static_cast<float>(sheet.size_px);
    const float u = p.along_mm / sheet.mm_per_px + cut * size;
    const float v = p.across_mm / sheet.mm_per_px + fraction(cut * 37) * size;
    const float rings = wave(figure.wrapped_at(u, v) * 6);
    const float print = 0.6F * grain.wrapped_at(u, v) + 0.4F * rings;
    const float fin = sheet.line(p.edge_mm, 3);
    t.height_mm += 1.4F * print + 2.2F * piece_number(steps, p.id) + 1.2F * fin;
    t.light += 0.16F * (print - 0.5F) - 0.13F * fin;
  }
  tone_pieces(sheet, pieces, 0.07F);
}

// Panels of smooth formwork: shadow joints, four tie holes each.
void draw_cast_panels(PatternSheet& sheet) {
  const int panels = sheet.periods;
  const auto pieces = lay_pieces(
      sheet, [&](float x, float y) { return grid_piece(sheet, panels, panels, 0, x, y); });
  cast(sheet, 2);
  const float panel = sheet.period_mm();
  constexpr float hole_mm = 22, rim_mm = 5;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float u = std::fabs(std::fabs(pieces[i].along_mm - panel / 2) - panel / 4);
    const float v = std::fabs(std::fabs(pieces[i].across_mm - panel / 2) - panel / 4);
    const float away = std::sqrt(u * u + v * v);
    const float hole = 1 - smooth_step(hole_mm - rim_mm, hole_mm + rim_mm, away);
    t.height_mm -= 14 * hole;
    t.light *= 1 - 0.55F * hole * smooth_step(-1, 1, (hole_mm - away) / hole_mm);
  }
  tone_pieces(sheet, pieces, 0.05F);
  darken_joints(sheet, pieces, sheet.joint_mm(5), 5, 0.55F);
}

}  // namespace marketgen::assets
