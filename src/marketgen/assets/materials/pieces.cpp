#include "assets/materials/pieces.h"

namespace marketgen::assets {

Piece grid_piece(
    const PatternSheet& sheet, int columns, int rows, float shift, float x_mm, float y_mm) {
  const float width = sheet.side_mm / static_cast<float>(columns);
  const float height = sheet.side_mm / static_cast<float>(rows);
  const float x = fraction(x_mm / sheet.side_mm + shift / static_cast<float>(columns)) *
                  static_cast<float>(columns);
  const float y = y_mm / height;
  const int column = std::min(static_cast<int>(x), columns - 1);
  const int row = std::min(static_cast<int>(y), rows - 1);
  const float u = (x - static_cast<float>(column)) * width;
  const float v = (y - static_cast<float>(row)) * height;
  const float edge = std::min({u, width - u, v, height - v});
  return {static_cast<std::uint32_t>(row * columns + column), edge, u, v};
}

void cut_joints(PatternSheet& sheet, const std::vector<Piece>& pieces, const Joints& joints) {
  const float half = std::max(joints.width_mm, sheet.mm_per_px) / 2;
  const float round = std::max(joints.round_mm, sheet.mm_per_px);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float joint = sheet.line(pieces[i].edge_mm, joints.width_mm);
    t.mark = mixed(t.mark, 1, joint);
    t.third *= 1 - joint;
    t.light = mixed(t.light, 1, joint);
    t.height_mm -=
        joints.depth_mm * (1 - smooth_step(half - round / 2, half + round, pieces[i].edge_mm));
    t.roughness = mixed(t.roughness, joints.roughness - sheet.roughness(), joint);
    t.metal *= 1 - joint;
  }
}

void tone_pieces(PatternSheet& sheet, const std::vector<Piece>& pieces, float depth) {
  const Seed tones = sheet.seed.child("tones");
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    sheet.look.light.values[i] +=
        (piece_number(tones, pieces[i].id) - 0.5F) * 2 * depth * sheet.variation;
  }
}

void darken_joints(PatternSheet& sheet,
                   const std::vector<Piece>& pieces,
                   float width_mm,
                   float depth_mm,
                   float share) {
  const float half = std::max(width_mm, sheet.mm_per_px) / 2;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Texel t = sheet.texel(i);
    const float joint = sheet.line(pieces[i].edge_mm, width_mm);
    t.light *= 1 - joint * share;
    t.height_mm -= depth_mm * (1 - smooth_step(0, half + sheet.mm_per_px, pieces[i].edge_mm));
    t.roughness += joint * (0.85F - sheet.roughness()) * 0.7F;
  }
}

}  // namespace marketgen::assets
