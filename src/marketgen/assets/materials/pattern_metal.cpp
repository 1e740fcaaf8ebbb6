#include "assets/materials/cells.h"
#include "assets/materials/pieces.h"

namespace marketgen::assets {

void draw_brushed(PatternSheet& sheet) {
  const int n = sheet.size_px;
  const Seed& seed = sheet.seed;
  sheet.look.mark = noise_field(n, n, {6, 170, 2, 0.7F}, seed.child("strokes"));
  const TextureField bands = noise_field(n, n, {2, 90, 3, 0.7F}, seed.child("bands"));
  add_centred(sheet.look.light, bands, 0.05F);
  add_centred(sheet.look.height_mm, sheet.look.mark, 0.06F);
  add_centred(sheet.look.roughness, sheet.look.mark, 0.10F);
  add_centred(sheet.look.roughness, sheet.noise("hands", 120, 4), 0.05F);
}

void draw_hammered(PatternSheet& sheet) {
  const auto dents = scatter_cells(sheet, "dents", 9, 0.85F);
  for (std::size_t i = 0; i < dents.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float slope = dents[i].middle_mm / 9;  // dents are spoon-shaped and meet in ridges
    t.height_mm = 1.5F * slope * slope;
    t.mark = 1.4F * slope * slope;
    t.roughness = 0.08F * slope;
  }
}

// Zinc crystals: each of its own grey and its own gloss, feathered.
void draw_galvanised(PatternSheet& sheet) {
  const auto crystals = scatter_cells(sheet, "crystals", 17, 1, 2.5F);
  const TextureField feather = sheet.noise("feather", 4, 2);
  const TextureField clouds = sheet.noise("clouds", 90, 4);
  const Seed kinds = sheet.seed.child("kinds");
  for (std::size_t i = 0; i < crystals.size(); ++i) {
    const Texel t = sheet.texel(i);
    // A few crystals go on growing over their neighbours' borders.
    const float kind = piece_number(kinds, crystals[i].id);
    const float seam = 1 - smooth_step(0, 0.8F, crystals[i].border_mm);
    t.mark = std::clamp(kind + (feather.values[i] - 0.5F) * 0.4F, 0.0F, 1.0F) * (1 - 0.4F * seam);
    t.light += (clouds.values[i] - 0.5F) * 0.06F;
    t.height_mm = (kind - 0.5F) * 0.05F - 0.04F * seam;
    t.roughness = (kind - 0.5F) * 0.24F + 0.06F * seam;
  }
}

// Tear plate: lozenges about four times as long as wide, turned by 90 degrees from one to the next.
void draw_diamond_plate(PatternSheet& sheet) {
  const float pitch = sheet.period_mm();
  const int cells = sheet.periods;
  const TextureField scuffs = sheet.noise("scuffs", 25, 4);
  const TextureField scratches = sheet.streaks("scratches", 60, 1.5F, 2);
  sheet.each_texel([&](Texel t, int x, int y) {
    const float u = (static_cast<float>(x) + 0.5F) * sheet.mm_per_px / pitch;
    const float v = (static_cast<float>(y) + 0.5F) * sheet.mm_per_px / pitch;
    const int i = std::min(static_cast<int>(u), cells - 1);
    const int j = std::min(static_cast<int>(v), cells - 1);
    const float du = u - static_cast<float>(i) - 0.5F, dv = v - static_cast<float>(j) - 0.5F;
    const float sign = (i + j) % 2 == 0 ? 1.0F : -1.0F;
    const float along = std::fabs(du + sign * dv) * 0.70710678F;
    const float over = std::fabs(du - sign * dv) * 0.70710678F;
    // A lens of two arcs, with a rounded top.
    const float tip = 0.52F, half = 0.12F;
    const float reach = 1 - (along / tip) * (along / tip);
    const float lens = reach <= 0 ? 0 : 1 - over / (half * reach);
    const float raised = smooth_step(0, 0.75F, lens);
    const std::size_t k = sheet.index(x, y);
    const float worn = raised * smooth_step(0.2F, 0.7F, scuffs.values[k]);
    t.height_mm = pitch * 0.055F * raised + 0.02F * scratches.values[k];
    t.mark = std::clamp(0.8F * (scuffs.values[k] - 0.25F) * (1 - raised), 0.0F, 1.0F);
    t.roughness = 0.08F * (scuffs.values[k] - 0.5F) - 0.10F * worn;
    t.light += 0.06F * worn;
  });
}

// Round holes on a square grid, a quarter of the pitch wide unless the row says how wide.
void draw_perforated(PatternSheet& sheet) {
  const int holes = sheet.periods;
  const float radius = sheet.joint_mm(sheet.period_mm() * 0.28F) / 2;
  add_centred(sheet.look.light, sheet.noise("clouds", 200, 4), 0.02F);
  add_centred(sheet.look.height_mm, sheet.noise("waves", 14, 2), 0.02F);
  const float half = sheet.period_mm() / 2;
  sheet.each_texel([&](Texel t, int x, int y) {
    const float dx = half - sheet.to_line_mm(x, holes), dy = half - sheet.to_line_mm(y, holes);
    const float away = std::sqrt(dx * dx + dy * dy) - radius;
    const float hole = sheet.inside(away);
    t.mark = hole;
    t.height_mm -= 1.5F * (1 - smooth_step(-0.5F, 0.8F, away));
    t.roughness = mixed(0, 0.9F - sheet.roughness(), hole);
    t.metal = 1 - hole;
  });
}

// Ribs from top to bottom; `relief` makes a corrugated sheet of them.
void draw_ribbed(PatternSheet& sheet) {
  const float rib = sheet.period_mm();
  const TextureField dirt = sheet.streaks("dirt", 9, 300, 4);
  sheet.each_texel([&](Texel t, int x, int y) {
    const float u = (static_cast<float>(x) + 0.5F) * sheet.mm_per_px / rib;
    const float height = wave(u);
    const float soil = dirt.values[sheet.index(x, y)];
    t.height_mm = rib * 0.16F * height;
    t.mark = std::clamp(0.5F * (1 - height) * soil * 1.6F, 0.0F, 1.0F);
    t.roughness = 0.05F * (soil - 0.5F);
  });
}

// Paint worn off at random down to the third colour, bare metal, scratched on the way.
void draw_worn_paint(PatternSheet& sheet) {
  const TextureField patches = sheet.noise("patches", 260, 7, 0.62F);
  const TextureField scratches = sheet.streaks("scratches", 130, 2.2F, 2);
  const TextureField where = sheet.noise("where", 180, 3);
  const TextureField clouds = sheet.noise("clouds", 300, 4);
  for (std::size_t i = 0; i < patches.values.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float chip = smooth_step(0.655F, 0.675F, patches.values[i]);
    const float scratch =
        smooth_step(0.80F, 0.88F, scratches.values[i]) * smooth_step(0.5F, 0.65F, where.values[i]);
    const float bare = std::max(chip, scratch * 0.8F);
    const float rim = smooth_step(0.615F, 0.655F, patches.values[i]) * (1 - chip);
    t.third = bare;
    t.mark = std::clamp(0.5F * clouds.values[i] + 0.5F * rim, 0.0F, 1.0F);
    t.height_mm = -0.25F * bare;
    t.roughness = 0.12F * (clouds.values[i] - 0.5F) + 0.25F * rim;
  }
}

}  // namespace marketgen::assets
