#include "assets/materials/pieces.h"
#include "assets/materials/wood_grain.h"

namespace marketgen::assets {
namespace {

constexpr float parquet_gap_mm = 0.8F;

// Blocks `ratio` times as long as wide, laid in zigzags that run from top to bottom. The texture
// holds `zigzags` of them.
//
// On the square lattice of block widths, cell (i, j) belongs to a level block when (i - j) mod 2 r
// < r and to an upright one otherwise; the lattice stands on its corner here.
Piece zigzag_piece(const PatternSheet& sheet, int ratio, int zigzags, float x_mm, float y_mm) {
  const int steps = ratio * zigzags;  // of the lattice's diagonal along each side
  const auto diagonals = static_cast<float>(steps);
  const float a = x_mm / sheet.side_mm * diagonals, b = y_mm / sheet.side_mm * diagonals;
  const float cell_mm = sheet.side_mm / diagonals * 0.70710678F;
  const float u = a + b, v = b - a;
  const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
  const float fu = u - static_cast<float>(i), fv = v - static_cast<float>(j);
  const int t = (((i - j) % (2 * ratio)) + 2 * ratio) % (2 * ratio);
  const bool level = t < ratio;
  const int place = level ? t : 2 * ratio - 1 - t;  // cells from the block's first end
  const float along = static_cast<float>(place) + (level ? fu : fv);
  const float across = level ? fv : fu;
  const float edge =
      std::min({along, static_cast<float>(ratio) - along, across, 1 - across}) * cell_mm;
  // The block's first cell, brought back into the texture: (steps, steps) and (steps, -steps) are
  // its periods.
  int first_i = level ? i - place : i, first_j = level ? j : j - place;
  const int down = (first_i + first_j) >= 0 ? (first_i + first_j) / (2 * steps)
                                            : -((2 * steps - 1 - first_i - first_j) / (2 * steps));
  first_i -= down * steps;
  first_j -= down * steps;
  const int apart = ((first_i - first_j) % (2 * steps) + 2 * steps) % (2 * steps);
  const auto id =
      static_cast<std::uint32_t>((first_i + first_j) * 2 * steps + apart) * 2 + (level ? 1U : 0U);
  return {id, edge, along * cell_mm, across * cell_mm};
}

std::vector<Piece> lay_zigzags(const PatternSheet& sheet, int ratio) {
  return lay_pieces(
      sheet, [&](float x, float y) { return zigzag_piece(sheet, ratio, sheet.periods, x, y); });
}

int ratio_of(const PatternSheet& sheet, float usual) {
  return std::max(2, static_cast<int>(std::lround(sheet.aspect(usual))));
}

void finish_parquet(PatternSheet& sheet, const std::vector<Piece>& pieces) {
  grow_wood(sheet, pieces, 0.75F);
  tone_pieces(sheet, pieces, 0.11F);
  darken_joints(sheet, pieces, sheet.joint_mm(parquet_gap_mm), 0.6F, 0.4F);
}

}  // namespace

void draw_herringbone(PatternSheet& sheet) {
  finish_parquet(sheet, lay_zigzags(sheet, ratio_of(sheet, 6)));
}

void draw_herringbone_tiles(PatternSheet& sheet) {
  const auto pieces = lay_zigzags(sheet, ratio_of(sheet, 3));
  const TextureField clouds = sheet.noise("clouds", 90, 4);
  add_centred(sheet.look.light, clouds, 0.05F);
  add_centred(sheet.look.height_mm, sheet.noise("waves", 40, 2), 0.2F);
  tone_pieces(sheet, pieces, 0.04F);
  cut_joints(sheet, pieces, {sheet.joint_mm(2.5F), 1, 2, 0.85F});
}

// Blocks cut at 45 degrees meet in straight lines: columns sheared up and down in turn.
void draw_chevron(PatternSheet& sheet) {
  const int columns = sheet.periods * 2;
  const float width = sheet.side_mm / static_cast<float>(columns);
  // Rows of blocks along one side; a block is `aspect` times as long as wide.
  const float length = width * 1.41421356F;
  const float upright = length / sheet.aspect(6) * 1.41421356F;
  const int rows = std::max(2, static_cast<int>(std::lround(sheet.side_mm / upright)));
  const float pitch = sheet.side_mm / static_cast<float>(rows);
  const auto pieces = lay_pieces(sheet, [&](float x_mm, float y_mm) {
    const int column = static_cast<int>(x_mm / width);
    const float in = x_mm - static_cast<float>(column) * width;
    const float rise = column % 2 == 0 ? in : width - in;
    const float v = fraction((y_mm - rise) / sheet.side_mm) * static_cast<float>(rows);
    const int row = std::min(static_cast<int>(v), rows - 1);
    const float across = (v - static_cast<float>(row)) * pitch * 0.70710678F;
    const float edge = std::min({in, width - in, across, pitch * 0.70710678F - across});
    return Piece{
        static_cast<std::uint32_t>(row * columns + column), edge, in * 1.41421356F, across};
  });
  finish_parquet(sheet, pieces);
}

void draw_basket(PatternSheet& sheet) {
  const int squares = sheet.periods;
  const int strips = ratio_of(sheet, 5);
  const auto pieces = lay_pieces(sheet, [&](float x, float y) {
    const Piece square = grid_piece(sheet, squares, squares, 0, x, y);
    const auto at = static_cast<int>(square.id);
    const bool turned = (at / squares + at % squares) % 2 == 1;
    const float width = sheet.period_mm() / static_cast<float>(strips);
    const float over = turned ? square.along_mm : square.across_mm;
    const int strip = std::min(static_cast<int>(over / width), strips - 1);
    const float across = over - static_cast<float>(strip) * width;
    const float edge = std::min({square.edge_mm, across, width - across});
    return Piece{square.id * static_cast<std::uint32_t>(strips) + static_cast<std::uint32_t>(strip),
                 edge,
                 turned ? square.across_mm : square.along_mm,
                 across};
  });
  finish_parquet(sheet, pieces);
}

}  // namespace marketgen::assets
