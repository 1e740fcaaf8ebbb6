#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "assets/print/color.h"
#include "assets/print/label.h"
#include "layout/makes.h"
#include "render/stage/build_signage.h"

namespace marketgen::render::raytrace {
namespace {

constexpr float band_height_m = 0.34F, band_depth_m = 0.02F;
constexpr float band_clear_m = 2.55F;  // above cabinets and doors
constexpr float name_width_m = 2.6F, name_pitch_m = 7;
constexpr float board_height_m = 0.36F, board_width_m = 1.5F, board_depth_m = 0.02F;
constexpr float board_clear_m = 2.35F;  // people and open doors pass below
constexpr float two_boards_from_m = 5;  // longer zones have a board at either end
constexpr float board_from_end_m = 0.8F;
constexpr float cable_m = 0.004F;
constexpr float near_wall_m = 0.4F;  // fixtures whose back is this near stand against the wall
constexpr int name_px = 128, board_px = 192;
constexpr float neon_m = 0.022F, neon_below_m = 0.05F;  // the tube, and how far below a band
constexpr float neon_over_white = 3;
constexpr std::string_view white_text = "#ffffff";
constexpr float number_width_m = 0.5F;  // of the board over a lane
constexpr float exit_width_m = 0.6F, exit_height_m = 0.2F, exit_depth_m = 0.04F;
constexpr float over_door_m = 0.06F;                  // from a door's head to its board
constexpr std::string_view safety_green = "#00794a";  // ISO 3864-4
constexpr std::string_view usual_exit_word = "EXIT";

// What stands over exits. Countries that are not here have the English word: so have China and
// Japan, whose letters the fonts of signs lack.
struct ExitWord {
  std::string_view country, word;
};
constexpr std::array<ExitWord, 3> exit_words{
    {{"ch", "AUSGANG"}, {"se", "UTG\u00c5NG"}, {"pl", "WYJ\u015aCIE"}}};

std::string exit_word(const std::optional<std::string>& country) {
  const auto found = std::ranges::find(exit_words, country.value_or(""), &ExitWord::country);
  return std::string(found == exit_words.end() ? usual_exit_word : found->word);
}

// Where the free-standing fixtures of a zone are, and along which axis their runs go.
struct Ground {
  RectMm bounds{1 << 30, 1 << 30, -(1 << 30), -(1 << 30)};
  int along_x = 0, along_y = 0;
  bool any = false;
};

void include(Ground& ground, const layout::Fixture& fixture) {
  const RectMm r = layout::footprint_of(fixture);
  ground.bounds = {std::min(ground.bounds.x0, r.x0),
                   std::min(ground.bounds.y0, r.y0),
                   std::max(ground.bounds.x1, r.x1),
                   std::max(ground.bounds.y1, r.y1)};
  (fixture.yaw_deg % 180 == 0 ? ground.along_x : ground.along_y) += fixture.width_mm;
  ground.any = true;
}

struct Interval {
  float low = 1e9F, high = -1e9F;
};

// The part of `edge` that the fixture's back covers; empty when it stands away from the wall.
Interval covered(const WallEdge& edge, const layout::Fixture& fixture) {
  const RectMm r = layout::footprint_of(fixture);
  Interval along, off;
  for (const PointMm& p : polygon_of(r)) {
    const Vec3f q = edge.world_from_wall.to_local(
        {static_cast<float>(p[0]) * 1e-3F, static_cast<float>(p[1]) * 1e-3F, 0});
    along = {std::min(along.low, q.x), std::max(along.high, q.x)};
    off = {std::min(off.low, q.y), std::max(off.high, q.y)};
  }
  const bool against = off.low > -0.05F && off.low < near_wall_m && along.low > -0.1F &&
                       along.high < edge.length + 0.1F;
  return against ? along : Interval{};
}

// Where the belt begins: assets/fixtures/checkout_lane.cpp says at which end of the module.
PointMm belt_head(const layout::Fixture& lane) {
  constexpr double from_middle = 0.38;  // of the lane's length
  const bool lengthwise = lane.width_mm > lane.depth_mm;
  const int yaw_deg = lane.yaw_deg + (lengthwise ? 0 : 90);
  const double turn = yaw_deg * std::numbers::pi / 180;
  const double off = from_middle * std::max(lane.width_mm, lane.depth_mm);
  return {lane.x_mm + static_cast<int>(std::lround(off * std::cos(turn))),
          lane.y_mm + static_cast<int>(std::lround(off * std::sin(turn)))};
}

}  // namespace

std::uint16_t sign_material(Draft& draft,
                            const std::string& text,
                            const std::string& ground,
                            float width,
                            float height,
                            int height_px) {
  const int width_px =
      static_cast<int>(std::lround(static_cast<float>(height_px) * width / height));
  const std::string content = "sign " + std::to_string(width_px) + "x" + std::to_string(height_px) +
                              " " + ground + " " + text;
  const std::int32_t texture = draft.texture(
      content, [=] { return assets::draw_sign(text, ground, white_text, width_px, height_px); });
  return draft.material({.color = {1, 1, 1}, .roughness = 0.6F, .texture = texture});
}

std::vector<std::uint32_t> lanes_in_order(const layout::Layout& layout) {
  std::vector<std::uint32_t> lanes;
  for (std::uint32_t f = 0; f < layout.fixtures.size(); ++f)
    if (layout::counts_as(layout, layout.fixtures[f], "checkout_lane")) lanes.push_back(f);
  std::ranges::sort(lanes, {}, [&](std::uint32_t lane) {
    return std::pair{layout.fixtures[lane].x_mm, layout.fixtures[lane].y_mm};
  });
  return lanes;
}

SignBuilder::SignBuilder(Draft& draft, const Room& room) : room_(room) {
  band_low_ = std::min(band_clear_m, room.ceiling - band_height_m - 0.1F);
  board_low_ = std::min(board_clear_m, room.ceiling - board_height_m - 0.15F);
  Material band{.roughness = 0.6F};
  if (const Result<Vec3f> accent = assets::linear_from_hex(draft.scene().layout.look.accent);
      accent.ok())
    band.color = *accent;
  band_ = draft.material(band);
  if (draft.scene().layout.look.neon.value_or(false))
    neon_ = draft.material({.color = {0, 0, 0}, .emission = band.color});
  metal_ = draft.material({.color = {0.5F, 0.5F, 0.5F}, .roughness = 0.4F});
  hang_boards(draft);
  write_names(draft);
  if (draft.scene().layout.outfit != plan::Outfit::full) return;
  number_lanes(draft);
  mark_exits(draft);
}

void SignBuilder::hang_boards(Draft& draft) {
  const layout::Layout& layout = draft.scene().layout;
  std::map<std::string, Ground> grounds;
  for (const layout::Fixture& fixture : layout.fixtures) {
    const bool against_wall =
        std::any_of(room_.walls.begin(), room_.walls.end(), [&](const WallEdge& edge) {
          return covered(edge, fixture).high > 0;
        });
    if (!against_wall) include(grounds[fixture.zone], fixture);
  }
  for (const layout::LayoutZone& zone : layout.zones) {
    const Ground& ground = grounds[zone.id];
    if (!ground.any || zone.label.empty()) continue;
    const bool along_x = ground.along_x > ground.along_y;
    const float low = metres(along_x ? ground.bounds.x0 : ground.bounds.y0),
                high = metres(along_x ? ground.bounds.x1 : ground.bounds.y1);
    const float across = metres(along_x ? ground.bounds.y0 + ground.bounds.y1
                                        : ground.bounds.x0 + ground.bounds.x1) /
                         2;
    std::vector<float> places{(low + high) / 2};
    if (high - low > two_boards_from_m) places = {low + board_from_end_m, high - board_from_end_m};
    const std::uint16_t material = sign_material(
        draft, zone.label, layout.look.accent, board_width_m, board_height_m, board_px);
    for (const float place : places) {
      const float z = board_low_ + board_height_m / 2;
      boards_.push_back({along_x ? Vec3f{place, across, z} : Vec3f{across, place, z},
                         along_x,
                         board_width_m,
                         material});
    }
  }
}

void SignBuilder::write_names(Draft& draft) {
  const layout::Layout& layout = draft.scene().layout;
  for (std::size_t w = 0; w < room_.walls.size(); ++w) {
    std::map<std::string, Interval> parts;
    for (const layout::Fixture& fixture : layout.fixtures) {
      const Interval part = covered(room_.walls[w], fixture);
      if (part.high <= 0) continue;
      Interval& all = parts[fixture.zone];
      all = {std::min(all.low, part.low), std::max(all.high, part.high)};
    }
    for (const layout::LayoutZone& zone : layout.zones) {
      const auto found = parts.find(zone.id);
      if (found == parts.end() || zone.label.empty() || found->second.high - found->second.low < 1)
        continue;
      const float span = found->second.high - found->second.low;
      const int count = std::max(1, static_cast<int>(span / name_pitch_m));
      const float width = std::min(name_width_m, span - 0.2F);
      const std::uint16_t material =
          sign_material(draft, zone.label, layout.look.accent, width, band_height_m, name_px);
      for (int i = 0; i < count; ++i) {
        const float middle =
            found->second.low + span * (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
        names_.push_back({w, middle, width, material});
      }
    }
  }
}

// Towards whoever comes along a lane.
void SignBuilder::number_lanes(Draft& draft) {
  const layout::Layout& layout = draft.scene().layout;
  const std::vector<std::uint32_t> lanes = lanes_in_order(layout);
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const layout::Fixture& lane = layout.fixtures[lanes[i]];
    const RectMm floor = layout::footprint_of(lane);
    const PointMm head = belt_head(lane);
    const float z = board_low_ + board_height_m / 2;
    boards_.push_back({{metres(head[0]), metres(head[1]), z},
                       floor.width() > floor.depth(),
                       number_width_m,
                       sign_material(draft,
                                     std::to_string(i + 1),
                                     layout.look.accent,
                                     number_width_m,
                                     board_height_m,
                                     board_px)});
  }
}

// Over exits and emergency exits; over the entrance of a shop whose only door that is.
void SignBuilder::mark_exits(Draft& draft) {
  const layout::Layout& layout = draft.scene().layout;
  const bool has_exit =
      std::ranges::find(layout.shell.openings, plan::OpeningKind::exit, &plan::Opening::kind) !=
      layout.shell.openings.end();
  const auto is_way_out = [&](plan::OpeningKind kind) {
    return kind == plan::OpeningKind::exit || kind == plan::OpeningKind::emergency ||
           (kind == plan::OpeningKind::entrance && !has_exit);
  };
  for (std::size_t w = 0; w < room_.walls.size(); ++w) {
    for (const WallOpening& opening : room_.walls[w].openings) {
      const float low = opening.head + over_door_m;
      if (!is_way_out(opening.kind) || low + exit_height_m > room_.ceiling) continue;
      exits_.push_back({w, (opening.low + opening.high) / 2, low});
    }
  }
  if (!exits_.empty())
    exit_ = sign_material(draft,
                          exit_word(layout.country),
                          std::string(safety_green),
                          exit_width_m,
                          exit_height_m,
                          name_px);
}

void SignBuilder::add_exit(Mesh& mesh, const ExitBoard& board) const {
  const Placement& wall = room_.walls[board.wall].world_from_wall;
  const float low = board.middle - exit_width_m / 2, high = board.middle + exit_width_m / 2;
  const float top = board.low + exit_height_m;
  add_framed_box(mesh, wall, {low, 0, board.low}, {high, exit_depth_m, top}, 0, 0);
  add_wall_picture(mesh, wall, low, high, exit_depth_m + 1e-3F, board.low, top, 1);
}

void SignBuilder::add_board(Mesh& mesh, const Board& board) const {
  // x along the board, y out of its first face.
  const Placement at = board.facing_x ? Placement{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, board.middle}
                                      : Placement{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, board.middle};
  const float w = board.width / 2, h = board_height_m / 2, d = board_depth_m / 2;
  add_framed_box(mesh, at, {-w, -d, -h}, {w, d, h}, 0, 0);
  add_wall_picture(mesh, at, -w, w, d + 1e-3F, -h, h, 1);
  const Placement behind{-at.x, -at.y, at.z, at.position};
  add_wall_picture(mesh, behind, -w, w, d + 1e-3F, -h, h, 1);
  const float up = room_.ceiling - board.middle.z;
  for (const float x : {-0.8F * w, 0.8F * w}) {
    add_framed_box(
        mesh, at, {x - cable_m / 2, -cable_m / 2, h}, {x + cable_m / 2, cable_m / 2, up}, 0, 0);
  }
}

void SignBuilder::add_band(
    Mesh& mesh, const WallEdge& edge, float low, float high, float depth) const {
  float done = 0;
  const auto strip = [&](float from, float to) {
    if (to - from > 0.05F)
      add_framed_box(mesh, edge.world_from_wall, {from, 0, low}, {to, depth, high}, 0, 0);
  };
  for (const WallOpening& o : edge.openings) {
    if (o.head <= low) continue;
    strip(done, o.low);
    done = o.high;
  }
  strip(done, edge.length);
}

void SignBuilder::build(Draft& draft) const {
  World& world = draft.world();
  for (const Board& board : boards_) {
    Mesh mesh;
    add_board(mesh, board);
    append(world.ceiling, world.shell_glass, mesh, {metal_, board.material}, world, {1, -1});
  }
  for (const ExitBoard& board : exits_) {
    Mesh mesh;
    add_exit(mesh, board);
    append(world.shell, world.shell_glass, mesh, {metal_, exit_}, world, {1, -1});
  }
  Mesh bands, neon;
  for (const WallEdge& edge : room_.walls) {
    add_band(bands, edge, band_low_, band_low_ + band_height_m, band_depth_m);
    const float low = band_low_ - neon_below_m;
    add_band(neon, edge, low, low + neon_m, neon_m);
  }
  append(world.shell, world.shell_glass, bands, {band_}, world, {1, -1});
  if (neon_) {
    Vec3f& light = world.materials[*neon_].emission;
    light = light * (neon_over_white / world.exposure);
    append(world.shell, world.shell_glass, neon, {*neon_}, world, {1, -1});
  }
  for (const WallName& name : names_) {
    Mesh mesh;
    add_wall_picture(mesh,
                     room_.walls[name.wall].world_from_wall,
                     name.middle - name.width / 2,
                     name.middle + name.width / 2,
                     band_depth_m + 1e-3F,
                     band_low_,
                     band_low_ + band_height_m,
                     0);
    append(world.shell, world.shell_glass, mesh, {name.material}, world, {1, -1});
  }
}

}  // namespace marketgen::render::raytrace
