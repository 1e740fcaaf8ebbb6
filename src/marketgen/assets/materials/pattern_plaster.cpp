#include "assets/materials/pattern_sheet.h"

namespace marketgen::assets {

// Thin coats of lime, brushed crosswise: clouds with the brush's edges in them.
void draw_limewash(PatternSheet& sheet) {
  const TextureField clouds = sheet.noise("clouds", 330, 6, 0.6F);
  const TextureField level = sheet.streaks("level", 120, 9, 3);
  const TextureField upright = sheet.streaks("upright", 9, 120, 3);
  const TextureField choice = sheet.noise("choice", 150, 3);
  for (std::size_t i = 0; i < clouds.values.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float turn = smooth_step(0.35F, 0.65F, choice.values[i]);
    const float stroke = mixed(level.values[i], upright.values[i], turn);
    t.mark =
        std::clamp(smooth_step(0.2F, 0.8F, clouds.values[i]) + (stroke - 0.5F) * 0.5F, 0.0F, 1.0F);
    t.light += (stroke - 0.5F) * 0.06F;
    t.height_mm = 0.35F * stroke;
  }
  add_centred(sheet.look.height_mm, sheet.noise("sand", 4, 2), 0.15F);
}

// Grains of sand of up to `period / 200` in the last coat; relief makes it thrown plaster.
void draw_roughcast(PatternSheet& sheet) {
  const int grains = sheet.count_of(5);
  const TextureField sand = bump_field(sheet.size_px,
                                       sheet.size_px,
                                       {grains, grains, 0.75F, 1, 0.5F, 0.85F},
                                       sheet.seed.child("sand"));
  const TextureField heaps = sheet.noise("heaps", 28, 4);
  const TextureField clouds = sheet.noise("clouds", 400, 4);
  for (std::size_t i = 0; i < sand.values.size(); ++i) {
    const Texel t = sheet.texel(i);
    t.height_mm = 1.3F * sand.values[i] + 1.6F * (heaps.values[i] - 0.5F);
    t.mark = std::clamp(
        0.6F * smooth_step(0.3F, 0.7F, clouds.values[i]) + 0.4F * (1 - sand.values[i]), 0.0F, 1.0F);
    t.light += 0.11F * (sand.values[i] - 0.6F) + 0.06F * (heaps.values[i] - 0.5F);
  }
}

// Venetian plaster: the edges of many trowel strokes, some polished.
void draw_trowelled(PatternSheet& sheet) {
  Stream draw = sheet.seed.child("strokes").stream();
  const float side = sheet.side_mm;
  const int strokes = static_cast<int>(side * side / (160 * 70) * 3);
  const int n = sheet.size_px;
  for (int k = 0; k < strokes; ++k) {
    const float radius_a = static_cast<float>(draw.uniform(60, 140));
    const float radius_b = static_cast<float>(draw.uniform(22, 60));
    const float slope = static_cast<float>(draw.normal()) * 0.8F;
    const float unit = 1 / std::sqrt(1 + slope * slope);
    const float tone = static_cast<float>(draw.uniform());
    const float share = static_cast<float>(draw.uniform(0.25, 0.7));
    const int cx = draw.integer(0, n - 1), cy = draw.integer(0, n - 1);
    const int reach = static_cast<int>(radius_a / sheet.mm_per_px) + 1;
    for (int dy = -reach; dy <= reach; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        const float x = static_cast<float>(dx) * sheet.mm_per_px;
        const float y = static_cast<float>(dy) * sheet.mm_per_px;
        const float along = (x + y * slope) * unit / radius_a;
        const float over = (y - x * slope) * unit / radius_b + 0.5F * along * along;
        const float within = 1 - along * along - over * over;
        if (within <= 0) continue;
        const Texel t = sheet.texel(sheet.index((cx + dx + n) % n, (cy + dy + n) % n));
        // Sharp at the stroke's front edge, faded behind it.
        const float here = share * smooth_step(0, 0.12F + 0.5F * smooth_step(-1, 1, over), within);
        t.mark = mixed(t.mark, tone, here);
        t.height_mm = mixed(t.height_mm, tone * 0.5F, here);
        t.roughness = mixed(t.roughness, (tone - 0.5F) * 0.22F, here);
      }
    }
  }
  add_centred(sheet.look.light, sheet.noise("clouds", 200, 5), 0.05F);
}

}  // namespace marketgen::assets
