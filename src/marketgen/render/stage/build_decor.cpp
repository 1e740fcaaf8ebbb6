#include "render/stage/build_decor.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "assets/print/poster.h"
#include "render/picture_objects.h"

namespace marketgen::render::raytrace {
namespace {

// On walls: above what is low, below the band with the zones' names.
constexpr float poster_foot_m = 1.3F, poster_top_m = 2.45F, poster_from_ceiling_m = 0.62F;
constexpr float poster_pitch_m = 2.6F, min_wall_m = 1.5F;
constexpr float beside_opening_m = 0.25F, beside_fixture_m = 0.15F;
constexpr float stands_at_wall_m = 0.7F;  // things nearer than this and as high hide a poster
constexpr float picture_frame_m = 0.022F, picture_depth_m = 0.018F;
constexpr float sheet_lift_m = 0.003F;
// On the ends of shelves.
constexpr int end_height_mm = 1300, end_free_mm = 450;
constexpr float end_share = 0.74F, end_margin_m = 0.12F;  // of the depth; below the top
constexpr int near_poster_px = 720;
constexpr float mat_depth_m = 1.7F, mat_height_m = 0.004F, mat_edge_m = 0.04F;

struct WallSpan {
  float low = 0, high = 0;
};

// What is left of a wall beside what stands in `taken`.
std::vector<WallSpan> free_spans(float length, std::vector<WallSpan> taken) {
  std::sort(taken.begin(), taken.end(), [](const WallSpan& a, const WallSpan& b) {
    return a.low < b.low;
  });
  std::vector<WallSpan> spans;
  float done = beside_fixture_m;
  for (const WallSpan& span : taken) {
    if (span.low > done) spans.push_back({done, span.low});
    done = std::max(done, span.high);
  }
  if (length - beside_fixture_m > done) spans.push_back({done, length - beside_fixture_m});
  std::erase_if(spans, [](const WallSpan& s) { return s.high - s.low < min_wall_m; });
  return spans;
}

// The parts of a wall that openings or high fixtures take.
std::vector<WallSpan> taken_spans(const layout::Layout& layout, const WallEdge& edge) {
  std::vector<WallSpan> taken;
  for (const WallOpening& o : edge.openings)
    taken.push_back({o.low - beside_opening_m, o.high + beside_opening_m});
  for (const layout::Fixture& fixture : layout.fixtures) {
    if (static_cast<float>(fixture.height_mm) * 1e-3F < poster_foot_m - 0.1F) continue;
    WallSpan along{1e9F, -1e9F}, off = along;
    for (const PointMm& p : polygon_of(layout::footprint_of(fixture))) {
      const Vec3f q = edge.world_from_wall.to_local(
          {static_cast<float>(p[0]) * 1e-3F, static_cast<float>(p[1]) * 1e-3F, 0});
      along = {std::min(along.low, q.x), std::max(along.high, q.x)};
      off = {std::min(off.low, q.y), std::max(off.high, q.y)};
    }
    if (off.low < stands_at_wall_m && off.high > 0)
      taken.push_back({along.low - beside_fixture_m, along.high + beside_fixture_m});
  }
  return taken;
}

// Type of the zone in which a place lies, empty where there is none.
std::string zone_type_at(const layout::Layout& layout, Vec3f place) {
  for (const layout::LayoutZone& zone : layout.zones) {
    if (contains(zone.polygon_mm, floor_mm(place))) return zone.type;
  }
  return {};
}

// The two ends of a double shelf: outward direction and the middle of the end's foot.
struct ShelfEnd {
  Vec3f out, foot;
  RectMm before;  // the floor one would look at it from
};
std::array<ShelfEnd, 2> ends_of(const layout::Fixture& fixture) {
  const RectMm r = layout::footprint_of(fixture);
  const bool along_x = fixture.yaw_deg % 180 == 0;
  const Vec3f middle{metres(r.x0 + r.x1) / 2, metres(r.y0 + r.y1) / 2, 0};
  if (along_x) {
    return {
        ShelfEnd{{-1, 0, 0}, {metres(r.x0), middle.y, 0}, {r.x0 - end_free_mm, r.y0, r.x0, r.y1}},
        {{1, 0, 0}, {metres(r.x1), middle.y, 0}, {r.x1, r.y0, r.x1 + end_free_mm, r.y1}}};
  }
  return {ShelfEnd{{0, -1, 0}, {middle.x, metres(r.y0), 0}, {r.x0, r.y0 - end_free_mm, r.x1, r.y0}},
          {{0, 1, 0}, {middle.x, metres(r.y1), 0}, {r.x0, r.y1, r.x1, r.y1 + end_free_mm}}};
}

bool is_free(const layout::Layout& layout, const RectMm& floor) {
  return std::none_of(
      layout.fixtures.begin(), layout.fixtures.end(), [&](const layout::Fixture& other) {
        return overlap(layout::footprint_of(other), floor);
      });
}

}  // namespace

DecorBuilder::DecorBuilder(Draft& draft, const Room& room) : room_(room) {
  frame_ = draft.material({.color = {0.16F, 0.16F, 0.165F}, .roughness = 0.35F});
  mat_ = draft.material({.color = {0.035F, 0.036F, 0.038F}, .roughness = 0.95F});
  mat_edge_ = draft.material({.color = {0.45F, 0.45F, 0.45F}, .roughness = 0.35F, .metallic = 1});
  if (draft.scene().layout.fixtures.empty()) return;  // no shop, a bare room
  hang_on_ends(draft);
  hang_on_walls(draft);
}

// Every place takes the next poster of its zone in the next design.
void DecorBuilder::hang(Draft& draft, Sheet sheet, const std::string& zone_type) {
  const std::vector<const assets::Poster*> choice = assets::posters_for(zone_type);
  const auto turn = static_cast<unsigned>(sheets_.size());
  const std::string own = choice.front()->zone_type.empty() ? "" : zone_type;
  const assets::Poster& poster = *choice[hung_[own]++ % choice.size()];
  const std::string accent = draft.scene().layout.look.accent;
  const int px = draft.print() == PrintDetail::near ? near_poster_px : near_poster_px / 3;
  const std::string content = "poster " + std::to_string(px) + " " + std::to_string(turn % 3) +
                              " " + accent + " " + std::string(poster.headline);
  const auto draw = [poster, accent, turn, px]() -> Result<assets::PrintedPicture> {
    MARKETGEN_TRY(Image picture, assets::draw_poster(poster, accent, turn, px));
    return assets::PrintedPicture{std::move(picture), std::nullopt};
  };
  sheet.material = draft.material(
      {.color = {1, 1, 1}, .roughness = 0.45F, .texture = draft.print_texture(content, draw)});
  sheets_.push_back(sheet);
}

void DecorBuilder::hang_on_walls(Draft& draft) {
  const layout::Layout& layout = draft.scene().layout;
  const float top = std::min(poster_top_m, room_.ceiling - poster_from_ceiling_m);
  const float height = top - poster_foot_m;
  if (height < 0.6F) return;
  const float width = height * static_cast<float>(assets::poster_aspect);
  for (const WallEdge& edge : room_.walls) {
    for (const WallSpan& span : free_spans(edge.length, taken_spans(layout, edge))) {
      const float free = span.high - span.low;
      const int count = std::max(1, static_cast<int>(free / poster_pitch_m));
      for (int i = 0; i < count; ++i) {
        const float x =
            span.low + free * (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
        Sheet sheet{edge.world_from_wall, width, true, shell_object, 0};
        sheet.at.position = edge.world_from_wall({x, 0, poster_foot_m});
        hang(draft, sheet, zone_type_at(layout, edge.world_from_wall({x, 1, 0})));
      }
    }
  }
}

void DecorBuilder::hang_on_ends(Draft& draft) {
  const layout::Layout& layout = draft.scene().layout;
  for (std::size_t i = 0; i < layout.fixtures.size(); ++i) {
    const layout::Fixture& fixture = layout.fixtures[i];
    const bool shelf = fixture.sides == 2 && fixture.endcap_of.empty();
    if (!shelf || fixture.height_mm < end_height_mm) continue;
    const layout::LayoutZone* zone = layout::find_zone(layout, fixture.zone);
    for (const ShelfEnd& end : ends_of(fixture)) {
      if (!is_free(layout, end.before)) continue;
      const float top = static_cast<float>(fixture.height_mm) * 1e-3F - end_margin_m;
      const float width = std::min(static_cast<float>(fixture.depth_mm) * 1e-3F * end_share,
                                   (top - 0.25F) * static_cast<float>(assets::poster_aspect));
      const float foot = top - width / static_cast<float>(assets::poster_aspect);
      const Vec3f along{end.out.y, -end.out.x, 0};
      const Sheet sheet{{along, end.out, {0, 0, 1}, end.foot + Vec3f{0, 0, foot}},
                        width,
                        false,
                        first_fixture_object + static_cast<std::uint32_t>(i),
                        0};
      hang(draft, sheet, zone != nullptr ? zone->type : "");
    }
  }
}

void DecorBuilder::add_mats(Draft& draft) const {
  Mesh mats;
  for (const WallEdge& edge : room_.walls) {
    for (const WallOpening& o : edge.openings) {
      if (!o.glazed() || !o.is_door()) continue;
      const float y1 = 0.06F + mat_depth_m;
      add_framed_box(
          mats, edge.world_from_wall, {o.low, 0.06F, 0}, {o.high, y1, mat_height_m - 0.001F}, 0, 1);
      add_framed_box(mats,
                     edge.world_from_wall,
                     {o.low + mat_edge_m, 0.06F + mat_edge_m, 0},
                     {o.high - mat_edge_m, y1 - mat_edge_m, mat_height_m},
                     0,
                     0);
    }
  }
  World& world = draft.world();
  append(world.shell, world.shell_glass, mats, {mat_, mat_edge_}, world, {shell_object, -1});
}

void DecorBuilder::build(Draft& draft) const {
  World& world = draft.world();
  for (const Sheet& sheet : sheets_) {
    const float half = sheet.width / 2,
                height = sheet.width / static_cast<float>(assets::poster_aspect);
    const float depth = sheet.framed ? picture_depth_m * 0.6F : sheet_lift_m;
    Mesh mesh;
    if (sheet.framed) {
      const float w = half + picture_frame_m;
      const auto rail = [&](Vec3f low, Vec3f high) {
        add_framed_box(mesh, sheet.at, low, high, 0.002F, 0);
      };
      rail({-w, 0, -picture_frame_m}, {w, picture_depth_m, 0});
      rail({-w, 0, height}, {w, picture_depth_m, height + picture_frame_m});
      rail({-w, 0, 0}, {-half, picture_depth_m, height});
      rail({half, 0, 0}, {w, picture_depth_m, height});
    }
    add_wall_picture(mesh, sheet.at, -half, half, depth, 0, height, 1);
    append(
        world.shell, world.shell_glass, mesh, {frame_, sheet.material}, world, {sheet.owner, -1});
  }
  add_mats(draft);
}

}  // namespace marketgen::render::raytrace
