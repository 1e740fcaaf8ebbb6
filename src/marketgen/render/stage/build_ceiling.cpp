#include "render/stage/build_ceiling.h"

#include <algorithm>
#include <cmath>

#include "assets/print/color.h"
#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

constexpr float tile_m = 0.6F;     // of ceiling grids; services sit in the middle of a tile
constexpr int services_pitch = 5;  // tiles between services, both ways
constexpr float lamp_clear_m = 0.42F;
constexpr float darkest_closed = 0.10F;  // ceilings darker than this are open
constexpr float outlet_half_m = 0.29F;
constexpr int outlet_rings = 3;
constexpr float duct_radius_m = 0.2F, duct_below_m = 0.26F;  // its axis below the ceiling
constexpr float duct_end_m = 0.5F, collar_pitch_m = 1.5F;
constexpr float second_duct_from_m = 9;
constexpr int duct_segments = 32, small_segments = 20;

// Whether a place on the ceiling is at least `clear` from every lamp.
bool is_clear_of_lamps(const World& world, float x, float y, float clear) {
  for (std::uint32_t i = 0; i < world.panel_count; ++i) {
    const AreaLight& light = world.lights[i];
    const Vec3f middle = light.middle();
    const float dx =
        std::fabs(middle.x - x) - (std::fabs(light.edge_u.x) + std::fabs(light.edge_v.x)) / 2;
    const float dy =
        std::fabs(middle.y - y) - (std::fabs(light.edge_u.y) + std::fabs(light.edge_v.y)) / 2;
    if (std::max(dx, dy) < clear) return false;
  }
  return true;
}

bool is_in_room(const Room& room, float x, float y) {
  constexpr float beside = 0.35F;
  for (const float dx : {-beside, beside}) {
    for (const float dy : {-beside, beside}) {
      if (!contains(room.outline, floor_mm(Vec3f{x + dx, y + dy, 0}))) return false;
    }
  }
  return true;
}

// Turned about a line down from the ceiling at `at`; z of the profile counts from the ceiling.
void add_turned(Mesh& mesh, Vec3f at, const std::vector<ProfilePoint>& profile) {
  const std::size_t first = mesh.positions.size();
  add_lathe(mesh, profile, small_segments);
  for (std::size_t v = first; v < mesh.positions.size(); ++v)
    mesh.positions[v] += at;
}

// A square air outlet: rings of white sheet one inside the other, each a little lower.
void add_outlet(Mesh& mesh, Vec3f at, std::uint16_t sheet, std::uint16_t gap) {
  constexpr float step = 0.0015F, pitch = outlet_half_m / outlet_rings;
  for (int k = 0; k < outlet_rings; ++k) {
    const auto place = static_cast<float>(k);
    const float half = outlet_half_m - place * pitch, dark = half - pitch + 0.018F;
    const float low = 0.004F + 2 * place * step;
    add_box(mesh, at - Vec3f{half, half, low}, at + Vec3f{half, half, 0}, 0.002F, sheet);
    if (k + 1 < outlet_rings)
      add_box(mesh, at - Vec3f{dark, dark, low + step}, at + Vec3f{dark, dark, 0}, 0, gap);
  }
}

void add_detector(Mesh& mesh, Vec3f at, std::uint16_t white) {
  add_turned(mesh,
             at,
             {{0, -0.045F, white, true},
              {0.03F, -0.045F, white},
              {0.036F, -0.03F, white, true},
              {0.05F, -0.025F, white},
              {0.055F, -0.002F, white, true},
              {0, 0, white}});
}

void add_sprinkler(Mesh& mesh, Vec3f at, std::uint16_t metal) {
  add_turned(mesh,
             at,
             {{0, -0.062F, metal, true},
              {0.02F, -0.062F, metal, true},
              {0.02F, -0.059F, metal, true},
              {0.006F, -0.056F, metal},
              {0.006F, -0.012F, metal, true},
              {0.036F, -0.010F, metal},
              {0.038F, 0, metal, true},
              {0, 0, metal}});
}

void add_camera(Mesh& mesh, Vec3f at, std::uint16_t white, std::uint16_t dome) {
  constexpr int steps = 8;
  constexpr float radius = 0.055F, ring = 0.03F;
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= steps; ++i) {
    const float angle = pi / 2 * static_cast<float>(i) / steps;
    profile.push_back(
        {radius * std::sin(angle), -ring - radius * std::cos(angle), dome, i == steps});
  }
  profile.push_back({0.07F, -ring, white, true});
  profile.push_back({0.078F, 0, white, true});
  profile.push_back({0, 0, white});
  add_turned(mesh, at, profile);
}

// A tube from z = 0 to `length` with collars where its pieces meet.
std::vector<ProfilePoint> duct_profile(float length, std::uint16_t sheet) {
  constexpr float lip = 0.012F, half = 0.025F;
  std::vector<ProfilePoint> profile{{0, 0, sheet, true}, {duct_radius_m, 0, sheet, true}};
  for (float z = collar_pitch_m; z < length - collar_pitch_m / 2; z += collar_pitch_m) {
    profile.push_back({duct_radius_m, z - half, sheet, true});
    profile.push_back({duct_radius_m + lip, z - half, sheet, true});
    profile.push_back({duct_radius_m + lip, z + half, sheet, true});
    profile.push_back({duct_radius_m, z + half, sheet, true});
  }
  profile.push_back({duct_radius_m, length, sheet, true});
  profile.push_back({0, length, sheet});
  return profile;
}

bool rows_run_along_x(const World& world) {
  if (world.panel_count == 0) return true;
  return std::fabs(world.lights[0].edge_u.x) >= std::fabs(world.lights[0].edge_v.y);
}

// Where across the lamps' rows a duct hangs: the place nearest to `share` of the width that keeps
// clear of them.
float duct_place(const World& world, bool along_x, float low, float across, float share) {
  constexpr float step = 0.05F, clear = duct_radius_m + 0.12F;
  float best = low + across * share, nearest = 1e9F;
  for (float place = low + 0.6F; place < low + across - 0.6F; place += step) {
    bool free = true;
    for (std::uint32_t i = 0; i < world.panel_count; ++i) {
      const AreaLight& light = world.lights[i];
      const Vec3f middle = light.middle();
      const float half = std::fabs(along_x ? light.edge_v.y : light.edge_u.x) / 2;
      free = free && std::fabs((along_x ? middle.y : middle.x) - place) > half + clear;
    }
    const float off = std::fabs(place - (low + across * share));
    if (free && off < nearest) {
      nearest = off;
      best = place;
    }
  }
  return best;
}

}  // namespace

CeilingBuilder::CeilingBuilder(Draft& draft, const Room& room) : room_(room), materials_(finishes) {
  materials_[white] = draft.material({.color = {0.78F, 0.78F, 0.77F}, .roughness = 0.45F});
  materials_[slot] = draft.material({.color = {0.30F, 0.30F, 0.30F}, .roughness = 0.9F});
  materials_[metal] =
      draft.material({.color = {0.75F, 0.74F, 0.72F}, .roughness = 0.25F, .metallic = 1});
  materials_[dome] = draft.material({.color = {0.02F, 0.02F, 0.022F}, .roughness = 0.08F});
  materials_[duct] =
      draft.material({.color = {0.60F, 0.61F, 0.62F}, .roughness = 0.42F, .metallic = 1});
  if (const catalog::MaterialRow* row = draft.row(draft.scene().layout.look.ceiling)) {
    const Result<Vec3f> color = assets::linear_from_hex(row->color);
    open_ = color.ok() && luminance(*color) < darkest_closed;
  }
}

// Every few tiles a place; what is there alternates.
void CeilingBuilder::add_services(Mesh& mesh, const World& world) const {
  const RectMm bounds = bounds_of(room_.outline);
  const auto tiles = [](int mm) {
    return static_cast<int>(static_cast<float>(mm) * 1e-3F / tile_m);
  };
  for (int j = tiles(bounds.y0) + 2; j < tiles(bounds.y1); j += services_pitch) {
    for (int i = tiles(bounds.x0) + 2; i < tiles(bounds.x1); i += services_pitch) {
      const Vec3f at{(static_cast<float>(i) + 0.5F) * tile_m,
                     (static_cast<float>(j) + 0.5F) * tile_m,
                     room_.ceiling};
      const int kind = (i / services_pitch + 2 * (j / services_pitch)) % 4;
      const Vec3f beside = at + Vec3f{tile_m * 2, tile_m, 0};
      if (is_in_room(room_, beside.x, beside.y) &&
          is_clear_of_lamps(world, beside.x, beside.y, 0.15F))
        add_sprinkler(mesh, beside, metal);
      if (!is_in_room(room_, at.x, at.y) || !is_clear_of_lamps(world, at.x, at.y, lamp_clear_m))
        continue;
      if (kind == 1)
        add_detector(mesh, at, white);
      else if (kind == 3)
        add_camera(mesh, at, white, dome);
      else if (!open_)
        add_outlet(mesh, at, white, slot);
    }
  }
}

// Beside the rows of lamps and along them, in rooms that are rectangles.
void CeilingBuilder::add_ducts(Mesh& mesh, const World& world) const {
  const RectMm bounds = bounds_of(room_.outline);
  const bool along_x = rows_run_along_x(world);
  const float length = metres(along_x ? bounds.width() : bounds.depth()) - 2 * duct_end_m;
  const float across = metres(along_x ? bounds.depth() : bounds.width());
  const Vec3f low{metres(bounds.x0), metres(bounds.y0), room_.ceiling - duct_below_m};
  const Quaternion turn = along_x ? rotation_about({0, 1, 0}, double{pi} / 2)
                                  : rotation_about({1, 0, 0}, -double{pi} / 2);
  const std::vector<float> shares =
      across > second_duct_from_m ? std::vector<float>{0.3F, 0.72F} : std::vector<float>{0.55F};
  for (const float share : shares) {
    const float place = duct_place(world, along_x, along_x ? low.y : low.x, across, share);
    const Vec3f start =
        along_x ? Vec3f{low.x + duct_end_m, place, low.z} : Vec3f{place, low.y + duct_end_m, low.z};
    const std::size_t first = mesh.positions.size();
    add_lathe(mesh, duct_profile(length, duct), duct_segments);
    marketgen::place(mesh, Pose{to_double(start), turn}, first);
  }
}

void CeilingBuilder::build(Draft& draft) const {
  if (draft.scene().layout.fixtures.empty()) return;  // no shop, a bare room
  World& world = draft.world();
  Mesh mesh;
  add_services(mesh, world);
  if (open_ && room_.outline.size() == 4) add_ducts(mesh, world);
  append(world.ceiling, world.shell_glass, mesh, materials_, world, {1, -1});
}

}  // namespace marketgen::render::raytrace
