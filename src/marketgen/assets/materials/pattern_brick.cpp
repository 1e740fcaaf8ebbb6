#include "assets/materials/pieces.h"

namespace marketgen::assets {
namespace {

constexpr float mortar_mm = 10;
// Raked joints: 4 mm behind the face.
constexpr float mortar_depth_mm = 4;
// Height of a brick course over its length: (65 + 10) over (240 + 10) mm of the normal format, DIN
// 4172.
constexpr double course_aspect = 0.30;

// Courses in the texture: even, so that the bond closes.
int courses_of(const PatternSheet& sheet, float stretcher_mm) {
  const float course = sheet.row.aspect > 0 ? stretcher_mm / sheet.aspect(1) : stretcher_mm * 0.30F;
  return std::max(2, static_cast<int>(std::lround(sheet.side_mm / course / 2)) * 2);
}

// Fired clay: sandy, each brick of its own tone and a little out of line.
void finish_bricks(PatternSheet& sheet, const std::vector<Piece>& pieces) {
  const float rough = sheet.roughness();
  add_centred(sheet.look.light, sheet.noise("sand", 24, 4, 0.6F), 0.11F * rough);
  add_centred(sheet.look.height_mm, sheet.noise("pits", 9, 3, 0.7F), 0.7F * rough);
  tone_pieces(sheet, pieces, 0.13F * rough);
  const Seed places = sheet.seed.child("places");
  const Seed kinds = sheet.seed.child("kinds");
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Texel t = sheet.texel(i);
    t.height_mm += piece_number(places, pieces[i].id) * 0.8F * rough;
    if (!sheet.row.third_color.empty())
      t.third = smooth_step(0.55F, 1, piece_number(kinds, pieces[i].id));
  }
  cut_joints(sheet,
             pieces,
             {sheet.joint_mm(mortar_mm), mortar_depth_mm * (0.3F + 0.7F * rough), 3, 0.92F});
}

}  // namespace

// Stretcher bond. Rough bricks are burnt unevenly, glazed ones (metro tiles) are alike.
void draw_brick(PatternSheet& sheet) {
  const int n = sheet.size_px, bricks = sheet.periods;
  const double course = sheet.row.aspect > 0 ? 1 / sheet.row.aspect : course_aspect;
  const int courses = std::max(2, static_cast<int>(std::lround(bricks / course / 2)) * 2);
  const float rough = sheet.roughness();
  const TextureField sand = noise_field(n, n, {40, 40, 4, 0.6F}, sheet.seed.child("sand"));
  add_centred(sheet.look.light, sand, 0.11F * rough);
  add_centred(sheet.look.height_mm, sand, 1.2F * rough);
  Stream draw = sheet.seed.child("tones").stream();
  std::vector<float> tones(static_cast<std::size_t>(courses * bricks));
  for (float& tone : tones)
    tone = static_cast<float>(draw.uniform(-1, 1)) * 0.11F * rough;
  const float width = sheet.joint_mm(mortar_mm);
  const float depth = mortar_depth_mm * (0.3F + 0.7F * rough);
  sheet.each_texel([&](Texel t, int x, int y) {
    const int at = y * courses / n;
    const int along = (x + (at % 2 == 0 ? 0 : n / bricks / 2)) % n;
    const float edge = std::min(sheet.to_line_mm(y, courses), sheet.to_line_mm(along, bricks));
    t.mark = sheet.line(edge, width);
    const float tone = tones[static_cast<std::size_t>(at * bricks + along * bricks / n)];
    t.light += tone * (1 - t.mark);
    t.height_mm += tone * 5 - depth * (1 - smooth_step(width / 2 - 1.5F, width / 2 + 1.5F, edge));
    t.roughness = mixed(0, 0.92F - rough, t.mark);
  });
}

void draw_brick_stack(PatternSheet& sheet) {
  const int bricks = sheet.periods;
  const int courses = courses_of(sheet, sheet.period_mm());
  finish_bricks(sheet, lay_pieces(sheet, [&](float x, float y) {
                  return grid_piece(sheet, bricks, courses, 0, x, y);
                }));
}

// A course of stretchers, a course of headers over their middles and joints.
void draw_brick_english(PatternSheet& sheet) {
  const int bricks = sheet.periods;
  const int courses = courses_of(sheet, sheet.period_mm());
  finish_bricks(
      sheet, lay_pieces(sheet, [&](float x, float y) {
        const int course = static_cast<int>(y / sheet.side_mm * static_cast<float>(courses));
        Piece piece = course % 2 == 0 ? grid_piece(sheet, bricks, courses, 0, x, y)
                                      : grid_piece(sheet, 2 * bricks, courses, 0.5F, x, y);
        piece.id += static_cast<std::uint32_t>((course % 2) * courses * bricks * 2);
        return piece;
      }));
}

// Stretcher and header in turn, each header over the middle of a stretcher.
void draw_brick_flemish(PatternSheet& sheet) {
  const int pairs = sheet.periods;
  const float pair = sheet.period_mm(), stretcher = pair * 2 / 3;
  const int courses = courses_of(sheet, stretcher);
  finish_bricks(
      sheet, lay_pieces(sheet, [&](float x, float y) {
        const int course = static_cast<int>(y / sheet.side_mm * static_cast<float>(courses));
        Piece piece = grid_piece(sheet, pairs, courses, course % 2 == 0 ? 0.0F : 0.5F, x, y);
        const bool header = piece.along_mm > stretcher;
        const float u = header ? piece.along_mm - stretcher : piece.along_mm;
        const float width = header ? pair - stretcher : stretcher;
        const float pitch = sheet.side_mm / static_cast<float>(courses);
        piece.edge_mm = std::min({u, width - u, piece.across_mm, pitch - piece.across_mm});
        piece.id = piece.id * 2 + (header ? 1U : 0U);
        return piece;
      }));
}

// Split strips of stone: courses 25 to 80 mm high, lengths and depths at random.
void draw_ledgestone(PatternSheet& sheet) {
  Stream draw = sheet.seed.child("courses").stream();
  struct Course {
    float top, height, shift;
    int stones;
  };
  std::vector<Course> courses;
  std::vector<int> course_at(static_cast<std::size_t>(sheet.size_px));
  float y = 0;
  while (y < sheet.side_mm) {
    float height = static_cast<float>(draw.uniform(25, 75));
    if (sheet.side_mm - y - height < 30) height = sheet.side_mm - y;
    const float stone = static_cast<float>(draw.uniform(4, 7)) * std::min(height, 55.0F);
    courses.push_back({y, height, static_cast<float>(draw.uniform()), sheet.count_of(stone)});
    y += height;
  }
  for (int row = 0, k = 0; row < sheet.size_px; ++row) {
    while ((static_cast<float>(row) + 0.5F) * sheet.mm_per_px >
           courses[static_cast<std::size_t>(k)].top + courses[static_cast<std::size_t>(k)].height)
      ++k;
    course_at[static_cast<std::size_t>(row)] = k;
  }
  const Seed lengths = sheet.seed.child("lengths");
  const auto pieces = lay_pieces(sheet, [&](float x_mm, float y_mm) {
    const auto row = static_cast<std::size_t>(y_mm / sheet.mm_per_px);
    const int k = course_at[std::min(row, course_at.size() - 1)];
    const Course& c = courses[static_cast<std::size_t>(k)];
    const float place = fraction(x_mm / sheet.side_mm + c.shift) * static_cast<float>(c.stones);
    // Joints move by up to a third of a stone.
    const auto joint = [&](int i) {
      const auto id = static_cast<std::uint32_t>(k * 64 + (i + c.stones) % c.stones);
      return static_cast<float>(i) + (piece_number(lengths, id) - 0.5F) * 0.66F;
    };
    int i = static_cast<int>(place);
    if (place < joint(i)) --i;
    if (place >= joint(i + 1)) ++i;
    const float stone_mm = sheet.side_mm / static_cast<float>(c.stones);
    const float left = (place - joint(i)) * stone_mm, right = (joint(i + 1) - place) * stone_mm;
    const float down = y_mm - c.top;
    const auto id = static_cast<std::uint32_t>(k * 64 + (i + c.stones) % c.stones);
    return Piece{id, std::min({left, right, down, c.height - down}), left, down};
  });
  const TextureField broken = sheet.streaks("broken", 70, 28, 5);
  const Seed depths = sheet.seed.child("depths"), kinds = sheet.seed.child("kinds");
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Texel t = sheet.texel(i);
    const std::uint32_t id = pieces[i].id;
    t.height_mm = piece_number(depths, id) * 12 + broken.values[i] * 7;
    t.light += (broken.values[i] - 0.5F) * 0.35F;
    t.mark = smooth_step(0.5F, 0.9F, piece_number(kinds, id)) * 0.8F;
    if (!sheet.row.third_color.empty())
      t.third = smooth_step(0.6F, 1, piece_number(kinds, id + 7919)) * 0.8F;
  }
  tone_pieces(sheet, pieces, 0.14F);
  darken_joints(sheet, pieces, sheet.joint_mm(3), 9, 0.75F);
}

}  // namespace marketgen::assets
