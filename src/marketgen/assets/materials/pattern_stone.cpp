#include "assets/materials/cells.h"
#include "assets/materials/pieces.h"

namespace marketgen::assets {
namespace {

constexpr float stone_joint_mm = 1.5F;  // polished slabs lie close

// Slabs of one period, each cut from another part of the block.
struct Cut {
  float x, y;
};
Cut cut_of(const PatternSheet& sheet, std::uint32_t slab) {
  const Seed cuts = sheet.seed.child("cuts");
  const auto size = static_cast<float>(sheet.size_px);
  return {std::floor(piece_number(cuts, slab) * size),
          std::floor(piece_number(cuts, slab + 7919) * size)};
}

// 1 on the middle of a vein, where `field` is a half, 0 at `width` from it.
float vein(float field, float width) {
  return 1 - smooth_step(0, width, std::fabs(field - 0.5F));
}

}  // namespace

// Without variation the stone is one slab, without joints.
void draw_marble(PatternSheet& sheet) {
  const bool whole = sheet.variation <= 0;
  const int slabs = sheet.periods;
  const auto pieces =
      lay_pieces(sheet, [&](float x, float y) { return grid_piece(sheet, slabs, slabs, 0, x, y); });
  const float slab = sheet.period_mm();
  const TextureField bend_x = sheet.noise("bend-x", slab * 0.5F, 4, 0.45F);
  const TextureField bend_y = sheet.noise("bend-y", slab * 0.5F, 4, 0.45F);
  const TextureField large = sheet.streaks("large", slab * 1.3F, slab * 0.45F, 2);
  const TextureField small = sheet.streaks("small", slab * 0.8F, slab * 0.25F, 3);
  const TextureField clouds = sheet.noise("clouds", slab * 0.5F, 5, 0.6F);
  const TextureField swell = sheet.noise("swell", slab * 0.3F, 2);
  const float bend = slab * 0.4F / sheet.mm_per_px;
  sheet.each_texel([&](Texel t, int x, int y) {
    const std::size_t i = sheet.index(x, y);
    const Cut cut = whole ? Cut{} : cut_of(sheet, pieces[i].id);
    // Beds lie slantwise: the lattice turned by 45 degrees still repeats with the texture.
    const float across = static_cast<float>(x) + cut.x, down = static_cast<float>(y) + cut.y;
    const float u = across + down, v = down - across;
    const float bx = (bend_x.wrapped_at(u, v) - 0.5F) * bend;
    const float by = (bend_y.wrapped_at(u, v) - 0.5F) * bend;
    const float wide = swell.wrapped_at(u, v);
    const float main = vein(large.wrapped_at(u + bx, v + by), 0.012F + 0.06F * wide * wide);
    const float fine = vein(small.wrapped_at(u + by, v - bx), 0.022F);
    const float cloud = clouds.wrapped_at(u + bx * 0.5F, v + by * 0.5F);
    t.mark = std::clamp(main * (0.35F + 0.9F * wide) + 0.40F * fine * wide +
                            0.35F * smooth_step(0.45F, 0.8F, cloud),
                        0.0F,
                        1.0F);
    if (!sheet.row.third_color.empty())
      t.third = 0.8F * main * smooth_step(0.45F, 0.7F, cloud + 0.25F * (wide - 0.5F));
    t.light += (cloud - 0.5F) * 0.06F;
    t.roughness = 0.05F * main;
  });
  if (whole) return;
  tone_pieces(sheet, pieces, 0.02F);
  cut_joints(sheet, pieces, {sheet.joint_mm(stone_joint_mm), 0.5F, 1, 0.7F});
}

void draw_travertine(PatternSheet& sheet) {
  const TextureField bands = sheet.streaks("bands", sheet.side_mm, 60, 4);
  const TextureField fine = sheet.streaks("fine", 220, 7, 3);
  const TextureField holes =
      bump_field(sheet.size_px,
                 sheet.size_px,
                 {sheet.count_of(38), sheet.count_of(14), 0.55F, 1, 0.7F, 0.35F},
                 sheet.seed.child("holes"));
  const TextureField ragged = sheet.streaks("ragged", 16, 5, 3);
  for (std::size_t i = 0; i < bands.values.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float layer = smooth_step(0.3F, 0.7F, bands.values[i]);
    // Pores follow the layers.
    const float hole =
        smooth_step(0.30F, 0.45F, holes.values[i] * layer + (ragged.values[i] - 0.5F) * 0.7F);
    t.mark = std::clamp(0.55F * layer + 0.5F * (fine.values[i] - 0.3F), 0.0F, 1.0F);
    t.light += (fine.values[i] - 0.5F) * 0.12F - hole * 0.22F;
    t.third = sheet.row.third_color.empty() ? 0 : 0.7F * hole;
    t.height_mm = -0.7F * hole;
    t.roughness = 0.35F * hole;
  }
}

void draw_granite(PatternSheet& sheet) {
  const auto crystals = scatter_cells(sheet, "crystals", 5.5F, 1);
  const auto mica = scatter_cells(sheet, "mica", 2.8F, 1);
  const Seed kinds = sheet.seed.child("kinds");
  const TextureField clouds = sheet.noise("clouds", 60, 4);
  for (std::size_t i = 0; i < crystals.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float kind = piece_number(kinds, crystals[i].id);
    const float dark = piece_number(kinds, mica[i].id + 104729U);
    t.mark = kind < 0.42F + 0.3F * (clouds.values[i] - 0.5F) ? kind * 1.6F : 0;
    t.third = dark > 0.80F ? 0.9F : kind > 0.93F ? 0.5F : 0;
    t.light += (kind - 0.5F) * 0.14F;
    t.roughness = 0.06F * (dark > 0.80F ? 1.0F : 0.0F);
  }
}

// Layers broken off one above the other.
void draw_slate(PatternSheet& sheet) {
  const int tiles = sheet.periods;
  const float aspect = sheet.aspect(1);
  const int rows = std::max(1, static_cast<int>(std::lround(static_cast<float>(tiles) * aspect)));
  const auto pieces = lay_pieces(sheet, [&](float x, float y) {
    const int row = static_cast<int>(y / sheet.side_mm * static_cast<float>(rows));
    return grid_piece(
        sheet, tiles, rows, rows % 2 == 0 && aspect > 1 && row % 2 == 1 ? 0.5F : 0, x, y);
  });
  const TextureField layers = sheet.streaks("layers", 330, 190, 5);
  const TextureField rust = sheet.noise("rust", 300, 5, 0.6F);
  const TextureField grain = sheet.noise("grain", 6, 3);
  constexpr float step_count = 7;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Texel t = sheet.texel(i);
    const Cut cut = cut_of(sheet, pieces[i].id);
    const auto x = static_cast<float>(i % static_cast<std::size_t>(sheet.size_px));
    const auto y = static_cast<float>(i / static_cast<std::size_t>(sheet.size_px));
    const float level = layers.wrapped_at(x + cut.x, y + cut.y) * step_count;
    const float whole = std::floor(level);
    const float step =
        whole + 0.35F * (level - whole) + 0.65F * smooth_step(0.72F, 1, level - whole);
    const float edge =
        smooth_step(0.70F, 0.86F, level - whole) * (1 - smooth_step(0.86F, 1, level - whole));
    t.height_mm = step * 0.75F + (grain.values[i] - 0.5F) * 0.5F;
    t.light +=
        (fraction(whole * 0.618F) - 0.5F) * 0.06F - 0.10F * edge + (grain.values[i] - 0.5F) * 0.12F;
    t.mark = 0.18F * fraction(whole * 0.381F) + 0.3F * (1 - rust.values[i]);
    if (!sheet.row.third_color.empty())
      t.third = 0.7F * smooth_step(0.55F, 0.75F, rust.wrapped_at(x + cut.y, y + cut.x));
  }
  tone_pieces(sheet, pieces, 0.07F);
  cut_joints(sheet, pieces, {sheet.joint_mm(5), 3, 3, 0.92F});
}

void draw_crazy_paving(PatternSheet& sheet) {
  const auto slabs = scatter_cells(sheet, "slabs", sheet.period_mm() / 2, 1);
  const TextureField ragged = sheet.noise("ragged", 40, 3);
  const TextureField clouds = sheet.noise("clouds", 90, 5);
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    pieces.push_back({slabs[i].id, slabs[i].border_mm + (ragged.values[i] - 0.5F) * 8, 0, 0});
  }
  const Seed kinds = sheet.seed.child("kinds");
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    const Texel t = sheet.texel(i);
    if (!sheet.row.third_color.empty())
      t.third = smooth_step(0.4F, 0.9F, piece_number(kinds, slabs[i].id));
    t.light += (clouds.values[i] - 0.5F) * 0.22F;
    t.height_mm = (clouds.values[i] - 0.5F) * 1.2F;
  }
  tone_pieces(sheet, pieces, 0.11F);
  cut_joints(sheet, pieces, {sheet.joint_mm(12), 2.5F, 4, 0.92F});
}

void draw_terrazzo(PatternSheet& sheet) {
  const int n = sheet.size_px;
  const Seed& seed = sheet.seed;
  // Chips of 4 to 20 mm over 1.2 m: a coarse and a fine sieve.
  const TextureField coarse =
      bump_field(n, n, {52, 52, 0.62F, 0.9F, 0.6F, 0.55F}, seed.child("coarse"));
  const TextureField fine =
      bump_field(n, n, {120, 120, 0.55F, 0.9F, 0.5F, 0.5F}, seed.child("fine"));
  const TextureField edge = noise_field(n, n, {160, 160, 2, 0.6F}, seed.child("edge"));
  const TextureField tone = noise_field(n, n, {70, 70, 1, 0.5F}, seed.child("tone"));
  for (std::size_t i = 0; i < tone.values.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float rough = (edge.values[i] - 0.5F) * 0.9F;
    const float chip = std::max(smooth_step(0.30F, 0.45F, coarse.values[i] + rough),
                                smooth_step(0.40F, 0.55F, fine.values[i] + rough) * 0.7F);
    // Some chips are dark, some lighter than the binder, some of a third stone.
    const bool light_chip = tone.values[i] > 0.56F;
    t.mark = light_chip ? 0 : chip * (0.25F + tone.values[i] * 0.8F);
    t.light += light_chip ? chip * 0.07F : 0;
    if (!sheet.row.third_color.empty() && tone.values[i] < 0.44F) t.third = chip * 0.9F;
    t.height_mm = 0.03F * chip;
    t.roughness = 0.06F * (0.4F - chip);
  }
}

}  // namespace marketgen::assets
