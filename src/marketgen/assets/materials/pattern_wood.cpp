#include "assets/materials/pieces.h"
#include "assets/materials/wood_grain.h"

namespace marketgen::assets {
namespace {

constexpr float plank_gap_mm = 1.5F;
constexpr float plank_bevel_mm = 0.7F;

// Boards along x, each with one butt joint somewhere.
std::vector<Piece> lay_boards(const PatternSheet& sheet, int boards) {
  const Seed joints = sheet.seed.child("butts");
  return lay_pieces(sheet, [&](float x, float y) {
    const auto row = static_cast<std::uint32_t>(y / sheet.side_mm * static_cast<float>(boards));
    const float shift = piece_number(joints, row);
    return grid_piece(sheet, 1, boards, shift, x, y);
  });
}

}  // namespace

// Boards along x, each with its own grain and one butt joint.
void draw_planks(PatternSheet& sheet) {
  const int n = sheet.size_px, planks = sheet.periods;
  const Seed& seed = sheet.seed;
  const TextureField grain = noise_field(n, n, {3, 72, 3, 0.6F}, seed.child("grain"));
  const TextureField figure = noise_field(n, n, {4, 20, 3, 0.5F}, seed.child("figure"));
  Stream tone_draw = seed.child("tones").stream();
  Stream joint_draw = seed.child("joints").stream();
  std::vector<float> tones;
  std::vector<int> shifts;
  for (int i = 0; i < planks; ++i) {
    tones.push_back(static_cast<float>(tone_draw.uniform(-1, 1)) * 0.07F);
    shifts.push_back(joint_draw.integer(0, n - 1));
  }
  sheet.each_texel([&](Texel t, int x, int y) {
    const auto plank = static_cast<std::size_t>(y * planks / n);
    const int along = (x + shifts[plank]) % n;
    const float side = sheet.to_line_mm(y, planks), butt = sheet.to_line_mm(along, 1);
    const float joint =
        std::min(sheet.line(side, plank_gap_mm) + sheet.line(butt, plank_gap_mm), 1.0F);
    const float fine = grain.row((y + shifts[plank]) % n)[along];
    const float wood = smooth_step(
        0.35F, 0.75F, fine * 0.6F + figure.row((y + shifts[plank] * 3) % n)[along] * 0.45F);
    t.mark = std::min(1.0F, wood * 0.55F + joint * 0.5F);
    t.light += tones[plank] - joint * 0.45F;
    t.height_mm = -0.15F * wood - plank_bevel_mm * (1 - smooth_step(0, 3, std::min(side, butt)));
    t.roughness = 0.10F * (wood - 0.4F) + 0.3F * joint;
  });
}

// Softwood: year rings flow round the knots.
void draw_knotty_planks(PatternSheet& sheet) {
  const auto pieces = lay_boards(sheet, sheet.periods);
  const float board = sheet.period_mm();
  const int across = std::max(2, sheet.count_of(board * 1.6F));
  const TextureField knots = bump_field(sheet.size_px,
                                        sheet.size_px,
                                        {across, across, 0.20F, 0.9F, 0.55F, 0.55F},
                                        sheet.seed.child("knots"));
  const TextureField figure = sheet.streaks("figure", 900, 50, 3);
  const TextureField rings = sheet.streaks("rings", 500, 5, 3);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Texel t = sheet.texel(i);
    // Rings crowd round a knot: the distance to it bends their phase.
    const float ragged = knots.values[i] + (rings.values[i] - 0.5F) * 0.25F;
    const float near = smooth_step(0, 1, ragged);
    const float knot = smooth_step(0.42F, 0.62F, ragged);
    const float phase = figure.values[i] * 7 + near * 3.5F + rings.values[i] * 0.5F;
    const float late = wave(phase) * wave(phase);
    t.mark = std::min(1.0F, 0.55F * late + 0.25F * rings.values[i] + 0.25F * near + 0.5F * knot);
    t.light -= 0.32F * knot * (0.4F + 0.6F * wave(knots.values[i] * 9));
    t.height_mm -= 0.12F * late;
    t.roughness += 0.08F * (late - 0.4F) - 0.1F * knot;
  }
  tone_pieces(sheet, pieces, 0.07F);
  darken_joints(sheet, pieces, sheet.joint_mm(2), 1.2F, 0.6F);
}

// Crown cut: nested arches along the sheet.
void draw_veneer(PatternSheet& sheet) {
  const TextureField bend = sheet.streaks("bend", 700, 160, 2);
  const TextureField rings = sheet.streaks("rings", 400, 6, 3);
  const TextureField pores = sheet.streaks("pores", 45, 1.6F, 2);
  const float sheets = std::max(1.0F, std::round(sheet.side_mm / 450));
  sheet.each_texel([&](Texel t, int x, int y) {
    const std::size_t i = sheet.index(x, y);
    const float across =
        (static_cast<float>(y) + 0.5F) / static_cast<float>(sheet.size_px) * sheets;
    const float crown = wave(across);  // 0 in the middle of a leaf, where the cut runs flat
    const float phase = bend.values[i] * 9 + crown * 6;
    const float late = wave(phase);
    const float pore = smooth_step(0.55F, 0.85F, pores.values[i]);
    t.mark =
        std::clamp(0.5F * late * late + 0.3F * rings.values[i] + 0.4F * pore - 0.05F, 0.0F, 1.0F);
    t.height_mm = -0.08F * pore;
    t.roughness += 0.06F * pore;
  });
  add_centred(sheet.look.light, sheet.streaks("flames", 900, 120, 3), 0.06F);
}

// OSB: strands 80 to 150 mm long, pressed flat over one another.
void draw_strand_board(PatternSheet& sheet) {
  Stream draw = sheet.seed.child("strands").stream();
  const float side = sheet.side_mm;
  const int strands = static_cast<int>(side * side / (90 * 14) * 4.5F);
  const TextureField grain = sheet.noise("grain", 2.5F, 2);
  for (int k = 0; k < strands; ++k) {
    const float length = static_cast<float>(draw.uniform(60, 150));
    const float width = static_cast<float>(draw.uniform(7, 24));
    const float x0 = static_cast<float>(draw.uniform()) * side;
    const float y0 = static_cast<float>(draw.uniform()) * side;
    // Strands of the face layers lie along the board, more or less.
    const float slope = static_cast<float>(draw.normal()) * 0.55F;
    const float unit = 1 / std::sqrt(1 + slope * slope);
    const float tone = static_cast<float>(draw.uniform());
    const float light = 1 + static_cast<float>(draw.uniform(-0.16, 0.12));
    const float level = static_cast<float>(draw.uniform()) * 0.5F;
    const int reach = static_cast<int>((length + width) / 2 / sheet.mm_per_px) + 2;
    const int cx = static_cast<int>(x0 / sheet.mm_per_px);
    const int cy = static_cast<int>(y0 / sheet.mm_per_px);
    for (int dy = -reach; dy <= reach; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        const float px = static_cast<float>(dx) * sheet.mm_per_px;
        const float py = static_cast<float>(dy) * sheet.mm_per_px;
        const float along = (px + py * slope) * unit, over = (py - px * slope) * unit;
        // Ends break off raggedly.
        const float end = length / 2 - 8 * fraction(over * 0.37F + tone * 7);
        const float gap = std::max(std::fabs(along) - end, std::fabs(over) - width / 2);
        const float here = sheet.inside(gap);
        if (here <= 0) continue;
        const int n = sheet.size_px;
        const std::size_t i = sheet.index(((cx + dx) % n + n) % n, ((cy + dy) % n + n) % n);
        const Texel t = sheet.texel(i);
        const float fibre = grain.wrapped_at((along * 0.12F + tone * 90) / sheet.mm_per_px,
                                             (over + tone * 300) / sheet.mm_per_px);
        const float rim = smooth_step(-1.6F, 0, gap);
        t.mark = mixed(t.mark, std::clamp(tone * 0.55F + fibre * 0.5F - 0.1F, 0.0F, 1.0F), here);
        t.light = mixed(t.light, light - 0.30F * rim * here, here);
        t.height_mm = mixed(t.height_mm, level - 0.35F * rim, here);
      }
    }
  }
  add_centred(sheet.look.roughness, grain, 0.06F);
}

}  // namespace marketgen::assets
