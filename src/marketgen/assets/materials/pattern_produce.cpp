#include "assets/materials/cells.h"
#include "assets/materials/pieces.h"

namespace marketgen::assets {

// Olives, beans, seeds, granules behind glass: bright where they touch it, dark or wet between.
void draw_pieces(PatternSheet& sheet) {
  const float size = sheet.period_mm();
  const auto cells = scatter_cells(sheet, "pieces", size, 0.8F, 0.06F * size);
  const Seed tones = sheet.seed.child("tones");
  const TextureField clouds = sheet.noise("clouds", 0.5F * size, 3);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float tone = piece_number(tones, cells[i].id) - 0.5F;
    const float touches = smooth_step(0.55F * size, 0.12F * size, cells[i].middle_mm);
    const float gap = 1 - smooth_step(0, 0.2F * size, cells[i].border_mm);
    t.mark = gap;
    t.light += 0.2F * sheet.variation * tone + 0.08F * (clouds.values[i] - 0.5F) +
               0.16F * (touches - 0.7F) - 0.12F * gap;
    t.height_mm = 0.1F * size * smooth_step(0, 0.35F * size, cells[i].border_mm);
  }
}

// Oil glands of citrus rind: dimples of changing size.
void draw_peel(PatternSheet& sheet) {
  const auto glands = scatter_cells(sheet, "glands", 2.1F, 0.8F);
  const Seed sizes = sheet.seed.child("sizes");
  const TextureField clouds = sheet.noise("clouds", 22, 4);
  const TextureField waves = sheet.noise("waves", 7, 2);
  for (std::size_t i = 0; i < glands.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float radius = 0.35F + 0.5F * piece_number(sizes, glands[i].id);
    const float dimple = 1 - smooth_step(0, radius, glands[i].middle_mm);
    t.height_mm = -0.5F * dimple + 0.35F * waves.values[i];
    t.mark =
        std::clamp(0.6F * smooth_step(0.35F, 0.8F, clouds.values[i]) + 0.3F * dimple, 0.0F, 1.0F);
    t.light += 0.05F * (clouds.values[i] - 0.5F) - 0.05F * dimple;
    t.roughness = 0.08F * dimple;
  }
}

// Streaks run from stem to calyx, dots lie between them.
void draw_lenticels(PatternSheet& sheet) {
  const TextureField blush = sheet.streaks("blush", 26, 80, 3);
  const TextureField streak = sheet.streaks("streak", 1.6F, 36, 3);
  const auto dots = scatter_cells(sheet, "dots", 4.5F, 1);
  const Seed sizes = sheet.seed.child("sizes");
  for (std::size_t i = 0; i < dots.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float radius = 0.12F + 0.32F * piece_number(sizes, dots[i].id);
    const float dot = 1 - smooth_step(radius * 0.6F, radius, dots[i].middle_mm);
    t.mark = smooth_step(0.22F, 0.62F, 0.6F * blush.values[i] + 0.45F * streak.values[i]);
    t.third = sheet.row.third_color.empty() ? 0 : 0.75F * dot;
    t.light += 0.06F * (streak.values[i] - 0.5F);
    t.height_mm = 0.02F * streak.values[i];
    t.roughness = 0.12F * dot;
  }
}

// Dark bands with torn edges, lighter threads inside.
void draw_stripes(PatternSheet& sheet) {
  const TextureField torn = sheet.noise("torn", sheet.period_mm() * 0.35F, 5, 0.62F);
  const TextureField threads = sheet.noise("threads", sheet.period_mm() * 0.16F, 4, 0.6F);
  const Seed widths = sheet.seed.child("widths");
  sheet.each_texel([&](Texel t, int x, int y) {
    const std::size_t i = sheet.index(x, y);
    const float u = (static_cast<float>(x) + 0.5F) * sheet.mm_per_px / sheet.period_mm();
    const float shifted = u + (torn.values[i] - 0.5F) * 0.75F + 1;
    const auto band = static_cast<std::uint32_t>(static_cast<int>(shifted) % sheet.periods);
    const float width = 0.10F + 0.14F * piece_number(widths, band);
    const float away = std::fabs(fraction(shifted) - 0.5F);
    const float stripe = 1 - smooth_step(width, width + 0.10F, away);
    const float net = 1 - smooth_step(0, 0.05F, std::fabs(threads.values[i] - 0.5F));
    t.mark = std::clamp(stripe * (1 - 0.35F * net) + 0.22F * net * (1 - stripe), 0.0F, 1.0F);
    t.light += 0.05F * (threads.values[i] - 0.5F);
  });
  add_centred(sheet.look.height_mm, sheet.noise("waves", 30, 2), 0.12F);
}

// The cracks of the skin heal into raised cork.
void draw_netting(PatternSheet& sheet) {
  const auto cracks = scatter_cells(sheet, "cracks", 8, 1, 1.6F);
  const auto fine = scatter_cells(sheet, "fine", 4, 1, 0.8F);
  const TextureField wide = sheet.noise("wide", 14, 3);
  const TextureField clouds = sheet.noise("clouds", 40, 4);
  const TextureField grain = sheet.noise("grain", 1, 2);
  for (std::size_t i = 0; i < cracks.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float width = 0.5F + 1.3F * wide.values[i];
    const float net = 1 - smooth_step(0.4F * width, width, cracks[i].border_mm);
    const float thin = 0.7F * (1 - smooth_step(0.1F, 0.5F, fine[i].border_mm)) *
                       smooth_step(0.4F, 0.65F, wide.values[i]);
    const float cork = std::max(net, thin);
    t.mark = cork;
    t.light += 0.10F * (clouds.values[i] - 0.5F) + 0.16F * cork * (grain.values[i] - 0.5F);
    t.height_mm = 0.75F * cork + 0.1F * grain.values[i] * cork;
    t.roughness = 0.25F * cork;
  }
}

void draw_earthy(PatternSheet& sheet) {
  const TextureField russet = sheet.noise("russet", 6, 4, 0.65F);
  const TextureField clouds = sheet.noise("clouds", 26, 4);
  const TextureField fine = sheet.noise("fine", 1, 2, 0.7F);
  const auto eyes = scatter_cells(sheet, "eyes", 24, 1);
  const Seed sizes = sheet.seed.child("sizes");
  for (std::size_t i = 0; i < eyes.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float radius = 0.6F + 2 * piece_number(sizes, eyes[i].id);
    const float eye = 1 - smooth_step(radius * 0.4F, radius, eyes[i].middle_mm);
    const float speck = smooth_step(0.62F, 0.72F, fine.values[i]);
    t.mark =
        std::clamp(0.9F * smooth_step(0.45F, 0.7F, russet.values[i]) * clouds.values[i] * 1.4F +
                       0.6F * eye + 0.45F * speck,
                   0.0F,
                   1.0F);
    t.light += 0.14F * (clouds.values[i] - 0.5F) - 0.10F * eye;
    t.height_mm = 0.18F * russet.values[i] - 0.8F * eye + 0.07F * fine.values[i];
  }
}

// Eyes on a hexagonal lattice, each a raised shield with a dark tip.
void draw_fruit_scales(PatternSheet& sheet) {
  const int columns = sheet.periods, rows = columns * 2;
  const float width = sheet.period_mm();
  const float pitch = sheet.side_mm / static_cast<float>(rows);
  const TextureField ragged = sheet.noise("ragged", width * 0.25F, 3);
  const TextureField fine = sheet.noise("fine", width * 0.07F, 2);
  const Seed tones = sheet.seed.child("tones");
  sheet.each_texel([&](Texel t, int x, int y) {
    const std::size_t k = sheet.index(x, y);
    const float u = (static_cast<float>(x) + 0.5F) * sheet.mm_per_px / width;
    const float v = (static_cast<float>(y) + 0.5F) * sheet.mm_per_px / pitch;
    float least = 1e9F;
    float to_x = 0, to_y = 0;
    std::uint32_t id = 0;
    for (int j = static_cast<int>(v) - 1; j <= static_cast<int>(v) + 1; ++j) {
      const int row = ((j % rows) + rows) % rows;
      const float shift = row % 2 == 0 ? 0.5F : 0.0F;
      const float column = std::floor(u - shift + 0.5F);
      const float dx = u - shift - column;
      const float dy = (v - static_cast<float>(j) - 0.5F) * 0.5F;
      const float diamond = std::fabs(dx) + std::fabs(dy);
      if (diamond >= least) continue;
      least = diamond, to_x = dx, to_y = dy;
      const int c = ((static_cast<int>(column) % columns) + columns) % columns;
      id = static_cast<std::uint32_t>(row * columns + c);
    }
    const float edge = least + (ragged.values[k] - 0.5F) * 0.10F;
    const float shield = 1 - smooth_step(0.30F, 0.49F, edge);
    const float tip = 1 - smooth_step(0.02F, 0.11F, std::fabs(to_x) + std::fabs(to_y - 0.06F));
    t.height_mm = width * (0.14F * shield + 0.05F * tip + 0.02F * fine.values[k]);
    t.mark = std::clamp(0.85F * (1 - shield) + 0.5F * fine.values[k] * shield - 0.1F, 0.0F, 1.0F);
    t.third = sheet.row.third_color.empty() ? 0 : 0.85F * tip;
    t.light += 0.25F * (piece_number(tones, id) - 0.5F) - 0.25F * to_y * shield;
  });
}

// Crinkles between a net of veins.
void draw_leaf(PatternSheet& sheet) {
  const auto coarse = scatter_cells(sheet, "coarse", 24, 1, 4);
  const auto fine = scatter_cells(sheet, "fine", 6, 1, 1.2F);
  const TextureField crinkle = sheet.noise("crinkle", 11, 3);
  const TextureField clouds = sheet.noise("clouds", 45, 4);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float vein = 1 - smooth_step(0.2F, 1.3F, coarse[i].border_mm);
    const float thin = 0.45F * (1 - smooth_step(0.05F, 0.45F, fine[i].border_mm));
    t.mark = std::clamp(std::max(vein, 0.6F * thin) * 0.85F, 0.0F, 1.0F);
    t.light += 0.18F * (clouds.values[i] - 0.5F) + 0.20F * (crinkle.values[i] - 0.5F);
    t.height_mm = 2.4F * crinkle.values[i] - 0.9F * vein - 0.3F * thin +
                  0.5F * smooth_step(0, 3, fine[i].border_mm);
  }
}

}  // namespace marketgen::assets
