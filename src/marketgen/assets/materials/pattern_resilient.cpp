#include "assets/materials/cells.h"
#include "assets/materials/pieces.h"

namespace marketgen::assets {

// Round flat studs with a chamfered rim, as on platforms and loading bays.
void draw_studs(PatternSheet& sheet) {
  const int studs = sheet.periods;
  const float pitch = sheet.period_mm(), radius = pitch * 0.34F, rim = pitch * 0.06F;
  const TextureField dust = sheet.noise("dust", 40, 4);
  const TextureField grain = sheet.noise("grain", 2.5F, 2);
  sheet.each_texel([&](Texel t, int x, int y) {
    const float dx = pitch / 2 - sheet.to_line_mm(x, studs);
    const float dy = pitch / 2 - sheet.to_line_mm(y, studs);
    const float away = std::sqrt(dx * dx + dy * dy) - radius;
    const float raised = 1 - smooth_step(-rim, rim, away);
    const float ring = sheet.inside(std::fabs(away) - rim);
    const std::size_t i = sheet.index(x, y);
    // Dust stays in the low places.
    t.mark = std::clamp(0.8F * (1 - raised) * dust.values[i] + 0.10F * ring, 0.0F, 1.0F);
    t.height_mm = 1.1F * raised + 0.06F * grain.values[i];
    t.roughness = 0.10F * (1 - raised) + 0.05F * (grain.values[i] - 0.5F);
  });
}

void draw_flecks(PatternSheet& sheet) {
  const auto coarse = scatter_cells(sheet, "coarse", 6, 1);
  const auto fine = scatter_cells(sheet, "fine", 3, 1);
  const Seed kinds = sheet.seed.child("kinds");
  const TextureField ragged = sheet.noise("ragged", 1.6F, 2);
  const TextureField clouds = sheet.noise("clouds", 120, 4);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float large = piece_number(kinds, coarse[i].id);
    const float small = piece_number(kinds, fine[i].id + 104729U);
    const float rough = (ragged.values[i] - 0.5F) * 1.6F;
    const float big_fleck = large > 0.86F ? sheet.inside(0.7F + rough - coarse[i].border_mm) : 0;
    const float fleck = small > 0.80F ? sheet.inside(0.35F + rough * 0.5F - fine[i].border_mm) : 0;
    t.mark = std::max(big_fleck, small > 0.90F || sheet.row.third_color.empty() ? fleck : 0.0F);
    if (!sheet.row.third_color.empty()) t.third = small <= 0.90F ? fleck : 0;
    t.light += (clouds.values[i] - 0.5F) * 0.03F;
    t.height_mm = 0.05F * ragged.values[i];
  }
}

// Linoleum: granules of two colours drawn out by the calender.
void draw_marbled(PatternSheet& sheet) {
  const TextureField bend = sheet.noise("bend", 170, 2);
  const TextureField broad = sheet.streaks("broad", 150, 24, 4);
  const TextureField thin = sheet.streaks("thin", 60, 5, 4);
  const float reach = 16 / sheet.mm_per_px;
  sheet.each_texel([&](Texel t, int x, int y) {
    const std::size_t i = sheet.index(x, y);
    const float off = (bend.values[i] - 0.5F) * reach * 2;
    const float u = static_cast<float>(x) + off * 0.4F, v = static_cast<float>(y) + off;
    const float b = broad.wrapped_at(u, v), s = thin.wrapped_at(u, v);
    t.mark = smooth_step(0.36F, 0.74F, 0.55F * b + 0.5F * s);
    if (!sheet.row.third_color.empty()) t.third = 0.6F * smooth_step(0.6F, 0.76F, s);
    t.light += 0.05F * (s - 0.5F);
  });
  add_centred(sheet.look.height_mm, sheet.noise("waves", 20, 2), 0.04F);
  add_centred(sheet.look.roughness, sheet.noise("wear", 140, 4), 0.07F);
}

void draw_cork(PatternSheet& sheet) {
  const auto large = scatter_cells(sheet, "large", 5.5F, 1, 0.9F);
  const auto small = scatter_cells(sheet, "small", 2.6F, 1, 0.5F);
  const Seed kinds = sheet.seed.child("kinds");
  const TextureField grain = sheet.noise("grain", 1.4F, 2, 0.7F);
  for (std::size_t i = 0; i < large.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float which = piece_number(kinds, large[i].id);
    const bool whole = which > 0.35F;
    const float kind = piece_number(kinds, (whole ? large[i].id : small[i].id) + 31337U);
    const float border = whole ? large[i].border_mm : small[i].border_mm;
    const float groove = 1 - smooth_step(0, 0.6F, border);
    t.mark = std::clamp(kind * kind * 0.9F + 0.35F * (grain.values[i] - 0.4F), 0.0F, 1.0F);
    if (!sheet.row.third_color.empty() && kind > 0.94F) t.third = 0.8F;
    t.light += 0.10F * (kind - 0.5F) - 0.16F * groove + 0.10F * (grain.values[i] - 0.5F);
    t.height_mm = -0.25F * groove + 0.12F * grain.values[i];
    t.roughness = 0.05F * groove;
  }
}

}  // namespace marketgen::assets
