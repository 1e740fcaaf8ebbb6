#include "assets/materials/pieces.h"

namespace marketgen::assets {
namespace {

constexpr float grout_mm = 3;
constexpr Joints tile_joints{grout_mm, 1.1F, 1.6F, 0.85F};

// Clouds under the glaze and the faint waves of a fired face.
void fire_face(PatternSheet& sheet) {
  const int n = sheet.size_px;
  const TextureField clouds = noise_field(n, n, {10, 10, 5, 0.6F}, sheet.seed.child("clouds"));
  add_centred(sheet.look.light, clouds, 0.05F);
  add_centred(sheet.look.roughness, clouds, 0.05F);
  add_centred(sheet.look.height_mm, sheet.noise("waves", 70, 3), 0.16F);
}

}  // namespace

void draw_tiles(PatternSheet& sheet) {
  const int n = sheet.size_px, tiles = sheet.periods;
  fire_face(sheet);
  Stream draw = sheet.seed.child("tones").stream();
  std::vector<float> tones(static_cast<std::size_t>(tiles * tiles));
  for (float& tone : tones)
    tone = static_cast<float>(draw.uniform(-1, 1)) * 0.025F;
  const float width = sheet.joint_mm(grout_mm);
  sheet.each_texel([&](Texel t, int x, int y) {
    const float edge = std::min(sheet.to_line_mm(x, tiles), sheet.to_line_mm(y, tiles));
    t.mark = sheet.line(edge, width);
    t.light += tones[static_cast<std::size_t>(y * tiles / n * tiles + x * tiles / n)];
    t.height_mm -= 1.1F * (1 - smooth_step(0, width, edge));
    t.roughness = mixed(t.roughness, tile_joints.roughness - sheet.roughness(), t.mark);
  });
}

void draw_chequer(PatternSheet& sheet) {
  fire_face(sheet);
  const int tiles = sheet.periods;
  const auto pieces =
      lay_pieces(sheet, [&](float x, float y) { return grid_piece(sheet, tiles, tiles, 0, x, y); });
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto id = static_cast<int>(pieces[i].id);
    sheet.look.third.values[i] = static_cast<float>((id / tiles + id % tiles) % 2);
  }
  tone_pieces(sheet, pieces, 0.03F);
  cut_joints(sheet, pieces, {sheet.joint_mm(2), 0.8F, 1.2F, 0.85F});
}

void draw_mosaic(PatternSheet& sheet) {
  const int stones = sheet.periods * 2;
  const auto pieces = lay_pieces(
      sheet, [&](float x, float y) { return grid_piece(sheet, stones, stones, 0, x, y); });
  const Seed kinds = sheet.seed.child("kinds");
  const bool mixed_colors = !sheet.row.third_color.empty();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const float kind = piece_number(kinds, pieces[i].id);
    if (mixed_colors) sheet.look.third.values[i] = kind > 0.55F ? kind : 0;
  }
  tone_pieces(sheet, pieces, 0.10F);
  const Seed tilts = sheet.seed.child("tilts");
  for (std::size_t i = 0; i < pieces.size(); ++i) {  // no two stones lie in one plane
    const Piece& p = pieces[i];
    const float lean = (piece_number(tilts, p.id) - 0.5F) * 0.05F;
    const float turn = (piece_number(tilts, p.id + 9973) - 0.5F) * 0.05F;
    sheet.look.height_mm.values[i] += p.along_mm * lean + p.across_mm * turn;
  }
  cut_joints(sheet, pieces, {sheet.joint_mm(2), 0.8F, 1.4F, 0.85F});
}

void draw_hex_tiles(PatternSheet& sheet) {
  // Eight rows of seven tiles fill a square within 1 %: rows of hexagons are sqrt(3) / 2 apart.
  const int columns = sheet.periods, rows = sheet.periods + 1;
  const float width = sheet.side_mm / static_cast<float>(columns);
  const float pitch = sheet.side_mm / static_cast<float>(rows);
  const auto pieces = lay_pieces(sheet, [&](float x_mm, float y_mm) {
    Piece best;
    best.edge_mm = -1;
    const int row = static_cast<int>(y_mm / pitch);
    for (int r = row - 1; r <= row + 1; ++r) {
      const int even = ((r % rows) + rows) % rows;
      const float shift = even % 2 == 0 ? 0.5F : 1.0F;
      const float u = x_mm / width - shift;
      const float column = std::floor(u + 0.5F);
      const float dx = std::fabs(u - column) * width;
      const float dy = std::fabs(y_mm - (static_cast<float>(r) + 0.5F) * pitch);
      // To the flat sides left and right, and to the slanted ones.
      const float edge = std::min(width / 2 - dx, width / 2 - (dx * 0.5F + dy * 0.8660254F));
      if (edge <= best.edge_mm) continue;
      const int c = ((static_cast<int>(column) % columns) + columns) % columns;
      best = {static_cast<std::uint32_t>(even * columns + c), edge, dx, dy};
    }
    return best;
  });
  fire_face(sheet);
  if (!sheet.row.third_color.empty()) {
    const Seed kinds = sheet.seed.child("kinds");
    for (std::size_t i = 0; i < pieces.size(); ++i)
      sheet.look.third.values[i] = piece_number(kinds, pieces[i].id) > 0.72F ? 1.0F : 0.0F;
  }
  tone_pieces(sheet, pieces, 0.03F);
  cut_joints(sheet, pieces, {sheet.joint_mm(grout_mm), 1, 1.5F, 0.85F});
}

// Zellige: every tile glazed by hand, none flat, the glaze deeper where it pooled.
void draw_glazed_tiles(PatternSheet& sheet) {
  const int columns = sheet.periods;
  const int rows =
      std::max(1, static_cast<int>(std::lround(static_cast<float>(columns) * sheet.aspect(1))));
  const auto pieces = lay_pieces(
      sheet, [&](float x, float y) { return grid_piece(sheet, columns, rows, 0, x, y); });
  const TextureField pools = sheet.noise("pools", 45, 3);
  const Seed tilts = sheet.seed.child("tilts");
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& p = pieces[i];
    const Texel t = sheet.texel(i);
    const float lean = (piece_number(tilts, p.id) - 0.5F) * 0.03F;
    const float turn = (piece_number(tilts, p.id + 9973) - 0.5F) * 0.03F;
    t.height_mm += p.along_mm * lean + p.across_mm * turn + (pools.values[i] - 0.5F) * 1.1F;
    t.light += (pools.values[i] - 0.5F) * 0.22F;
    if (!sheet.row.third_color.empty())
      t.third = smooth_step(0.45F, 0.8F, pools.values[i]) * piece_number(tilts, p.id + 77);
  }
  tone_pieces(sheet, pieces, 0.10F);
  cut_joints(sheet, pieces, {sheet.joint_mm(2), 0.9F, 3, 0.9F});
}

// Scallops: discs in rows half a tile apart, each under the row above it.
void draw_fish_scale(PatternSheet& sheet) {
  const int columns = sheet.periods, rows = sheet.periods * 2;
  const float width = sheet.side_mm / static_cast<float>(columns);
  const float pitch = sheet.side_mm / static_cast<float>(rows);
  const float radius = width / 2;
  struct Disc {
    std::uint32_t id;
    float away, dx, dy;  // of the point, from the disc's middle
  };
  // The disc of row `r` nearest to a point; row 0's middles lie on the texture's top edge.
  const auto nearest = [&](int r, float x_mm, float y_mm) {
    const int row = ((r % rows) + rows) % rows;
    const float u = x_mm / width - (row % 2 == 0 ? 0.0F : 0.5F);
    const float column = std::floor(u);
    const float dx = (u - column - 0.5F) * width;
    const float dy = y_mm - static_cast<float>(r) * pitch;
    const int c = ((static_cast<int>(column) % columns) + columns) % columns;
    return Disc{
        static_cast<std::uint32_t>(row * columns + c), std::sqrt(dx * dx + dy * dy), dx, dy};
  };
  const auto pieces = lay_pieces(sheet, [&](float x_mm, float y_mm) {
    float above = radius;  // to the edge of what covers this place from above
    for (int r = static_cast<int>(y_mm / pitch) - 1;; ++r) {
      const Disc disc = nearest(r, x_mm, y_mm);
      if (disc.away <= radius)
        return Piece{disc.id, std::min(radius - disc.away, above), disc.dx, disc.dy};
      above = std::min(above, disc.away - radius);
    }
  });
  fire_face(sheet);
  tone_pieces(sheet, pieces, 0.06F);
  cut_joints(sheet, pieces, {sheet.joint_mm(2), 0.9F, 3, 0.9F});
}

}  // namespace marketgen::assets
