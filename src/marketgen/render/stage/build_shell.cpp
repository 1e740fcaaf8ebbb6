#include "render/stage/build_shell.h"

#include <algorithm>
#include <cmath>

#include "plan/shell_measures.h"

namespace marketgen::render::raytrace {
namespace {

constexpr float wall_depth_m = static_cast<float>(plan::wall_thickness_m);
constexpr float skirting_height_m = 0.09F, skirting_depth_m = 0.012F;
constexpr float frame_m = 0.06F;     // aluminium profiles
constexpr float operator_m = 0.16F;  // box over a sliding door
constexpr float pane_m = 0.012F;
constexpr float window_module_m = 1.4F;  // mullions about this far apart
constexpr float floor_polish = 0.65F;    // a shop's floor is sealed and machine-cleaned every day

void add_horizontal(Mesh& mesh,
                    const PolygonMm& outline,
                    float z,
                    bool facing_up,
                    float extent,
                    std::uint16_t surface) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const PointMm& p : outline) {
    const Vec3f position{static_cast<float>(p[0]) * 1e-3F, static_cast<float>(p[1]) * 1e-3F, z};
    mesh.add_vertex(
        position, {0, 0, facing_up ? 1.0F : -1.0F}, {position.x / extent, -position.y / extent});
  }
  for (const auto& t : triangulated(outline)) {
    if (facing_up)
      mesh.add_triangle(first + t[0], first + t[1], first + t[2], surface);
    else
      mesh.add_triangle(first + t[0], first + t[2], first + t[1], surface);
  }
}

}  // namespace

ShellBuilder::ShellBuilder(Draft& draft, const Room& room) : room_(room), materials_(finishes) {
  const plan::Look& look = draft.scene().layout.look;
  Material polished = draft.world().materials[draft.tiled_material(look.floor)];
  polished.roughness *= floor_polish;
  polished.roughness_scale = floor_polish;
  materials_[floor] = draft.material(polished);
  materials_[wall] = draft.tiled_material(look.wall);
  materials_[ceiling] = draft.tiled_material(look.ceiling);
  floor_extent_ = draft.extent_m(look.floor);
  wall_extent_ = draft.extent_m(look.wall);
  ceiling_extent_ = draft.extent_m(look.ceiling);
  materials_[skirting] = draft.material({.color = {0.16F, 0.16F, 0.165F}, .roughness = 0.5F});
  materials_[frame] = draft.material({.color = {0.10F, 0.105F, 0.11F}, .roughness = 0.45F});
  materials_[pane] =
      draft.material({.color = {0.95F, 0.975F, 0.97F}, .roughness = 0.02F, .glass = true});
  materials_[steel_door] = draft.material({.color = {0.42F, 0.44F, 0.46F}, .roughness = 0.45F});
  materials_[trim] = draft.material({.color = {0.6F, 0.6F, 0.59F}, .roughness = 0.8F});
}

void ShellBuilder::add_floor(Mesh& mesh) const {
  add_horizontal(mesh, room_.outline, 0, true, floor_extent_, floor);
}

void ShellBuilder::add_ceiling(Mesh& mesh) const {
  add_horizontal(mesh, room_.outline, room_.ceiling, false, ceiling_extent_, ceiling);
}

void ShellBuilder::add_wall(Mesh& mesh, const WallEdge& edge) const {
  const Placement& at = edge.world_from_wall;
  float done = 0;
  for (const WallOpening& o : edge.openings) {
    if (o.low > done)
      add_wall_panel(mesh, at, done, o.low, 0, 0, room_.ceiling, wall, wall_extent_);
    if (o.sill > 0) add_wall_panel(mesh, at, o.low, o.high, 0, 0, o.sill, wall, wall_extent_);
    add_wall_panel(mesh, at, o.low, o.high, 0, o.head, room_.ceiling, wall, wall_extent_);
    add_reveal(mesh, edge, o);
    if (o.glazed())
      add_glazing(mesh, edge, o);
    else
      add_steel_door(mesh, edge, o);
    done = o.high;
  }
  if (done < edge.length)
    add_wall_panel(mesh, at, done, edge.length, 0, 0, room_.ceiling, wall, wall_extent_);
  // The wall's top, for plans seen from above.
  add_framed_box(mesh,
                 at,
                 {-wall_depth_m, -wall_depth_m, room_.ceiling},
                 {edge.length + wall_depth_m, 0, room_.ceiling + 0.02F},
                 0,
                 trim);
}

void ShellBuilder::add_skirting(Mesh& mesh, const WallEdge& edge) const {
  float done = 0;
  const auto strip = [&](float from, float to) {
    if (to - from > 0.01F) {
      add_framed_box(mesh,
                     edge.world_from_wall,
                     {from, 0, 0},
                     {to, skirting_depth_m, skirting_height_m},
                     0.003F,
                     skirting);
    }
  };
  for (const WallOpening& o : edge.openings) {
    if (!o.is_door()) continue;
    strip(done, o.low);
    done = o.high;
  }
  strip(done, edge.length);
}

void ShellBuilder::add_reveal(Mesh& mesh, const WallEdge& edge, const WallOpening& o) const {
  const Placement& at = edge.world_from_wall;
  constexpr float thin = 0.01F;
  const float outside = -wall_depth_m,
              inside = -1e-3F;  // behind the wall's face, so that the two do not fight
  add_framed_box(mesh, at, {o.low - thin, outside, o.sill}, {o.low, inside, o.head}, 0, trim);
  add_framed_box(mesh, at, {o.high, outside, o.sill}, {o.high + thin, inside, o.head}, 0, trim);
  add_framed_box(mesh, at, {o.low, outside, o.head}, {o.high, inside, o.head + thin}, 0, trim);
  add_framed_box(mesh, at, {o.low, outside, o.sill - thin}, {o.high, inside, o.sill}, 0, trim);
}

void ShellBuilder::add_glazing(Mesh& mesh, const WallEdge& edge, const WallOpening& o) const {
  const Placement& at = edge.world_from_wall;
  constexpr auto y0 = static_cast<float>(-plan::glazing_back_m),
                 y1 = static_cast<float>(-plan::glazing_front_m);
  const bool door = o.is_door();
  const float head = door ? operator_m : frame_m;
  const int leaves = std::max(
      1, static_cast<int>(std::lround((o.high - o.low) / (door ? 1.0F : window_module_m))));
  add_framed_box(mesh,
                 at,
                 {o.low, y0, o.head - head},
                 {o.high, y1 + (door ? 0.06F : 0.0F), o.head},
                 0.003F,
                 frame);
  const float foot = door ? 0.08F : frame_m;
  const float low = o.sill + (door ? 0.012F : 0.0F);
  add_framed_box(mesh, at, {o.low, y0, low}, {o.high, y1, low + foot}, 0.003F, frame);
  const float step = (o.high - o.low) / static_cast<float>(leaves);
  for (int i = 0; i <= leaves; ++i) {
    const float x =
        std::clamp(o.low + step * static_cast<float>(i), o.low + frame_m / 2, o.high - frame_m / 2);
    add_framed_box(mesh,
                   at,
                   {x - frame_m / 2, y0, low + foot},
                   {x + frame_m / 2, y1, o.head - head},
                   0.003F,
                   frame);
  }
  const float pane_y = (y0 + y1) / 2;
  for (int i = 0; i < leaves; ++i) {
    const float left = o.low + step * static_cast<float>(i) + frame_m,
                right = o.low + step * static_cast<float>(i + 1) - frame_m;
    add_framed_box(mesh,
                   at,
                   {left, pane_y - pane_m / 2, low + foot},
                   {right, pane_y + pane_m / 2, o.head - head},
                   0,
                   pane);
  }
}

void ShellBuilder::add_steel_door(Mesh& mesh, const WallEdge& edge, const WallOpening& o) const {
  const Placement& at = edge.world_from_wall;
  constexpr auto y0 = static_cast<float>(-plan::door_leaf_back_m),
                 y1 = static_cast<float>(-plan::door_leaf_front_m);
  const int leaves = o.high - o.low > 1.3F ? 2 : 1;
  const float step = (o.high - o.low) / static_cast<float>(leaves);
  constexpr float gap = 0.004F;
  for (int i = 0; i < leaves; ++i) {
    const float x0 = o.low + step * static_cast<float>(i) + gap,
                x1 = o.low + step * static_cast<float>(i + 1) - gap;
    add_framed_box(mesh, at, {x0, y0, 0.01F}, {x1, y1, o.head - gap}, 0.004F, steel_door);
    add_framed_box(mesh,
                   at,
                   {x0 + 0.05F, y1, 0.02F},
                   {x1 - 0.05F, y1 + 0.003F, 0.24F},
                   0,
                   frame);  // kick plate
    add_framed_box(mesh,
                   at,
                   {x0 + 0.10F, y1, 1.0F},
                   {x1 - 0.10F, y1 + 0.05F, 1.03F},
                   0.004F,
                   frame);  // push bar
  }
}

void ShellBuilder::add_columns(Mesh& mesh, const plan::Shell& shell) const {
  for (const plan::Column& column : shell.columns) {
    const float half = static_cast<float>(column.size_mm) * 0.5e-3F;
    const Placement at{
        {1, 0, 0},
        {0, 1, 0},
        {0, 0, 1},
        {static_cast<float>(column.x_mm) * 1e-3F, static_cast<float>(column.y_mm) * 1e-3F, 0}};
    add_framed_box(
        mesh, at, {-half, -half, 0}, {half, half, room_.ceiling}, 0.01F, wall, wall_extent_);
    const float foot = half + skirting_depth_m;
    add_framed_box(mesh, at, {-foot, -foot, 0}, {foot, foot, skirting_height_m}, 0.003F, skirting);
  }
}

void ShellBuilder::build(Draft& draft) const {
  World& world = draft.world();
  Mesh mesh, over;
  add_floor(mesh);
  for (const WallEdge& edge : room_.walls) {
    add_wall(mesh, edge);
    add_skirting(mesh, edge);
  }
  add_columns(mesh, draft.scene().layout.shell);
  add_ceiling(over);
  append(world.shell, world.shell_glass, mesh, materials_, world, {1, -1});
  append(world.ceiling, world.shell_glass, over, materials_, world, {1, -1});
  // What is inside: walls have thickness, and a light probe in or behind them would see the day.
  for (const WallEdge& edge : room_.walls) {
    for (const float z : {0.0F, room_.ceiling})
      world.room.include(edge.world_from_wall({0, 0, z}));
  }
}

}  // namespace marketgen::render::raytrace
