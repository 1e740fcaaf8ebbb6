#include "render/build_light.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "render/shading_math.h"
#include "render/tone.h"

namespace marketgen::raytrace {
namespace {

constexpr float panel_length_m = 1.2F, panel_width_m = 0.3F;
constexpr float panel_pitch_m = 2.4F;  // along a row
constexpr float row_pitch_m = 2.8F;    // between rows where no aisle says otherwise
constexpr float closest_rows_m = 1.5F;
constexpr float wall_distance_m = 0.6F;  // panels keep this far from walls
constexpr float below_ceiling_m = 0.015F;
constexpr float panel_frame_m = 0.02F;
constexpr double neutral_kelvin = 4700;  // the camera's white point
constexpr double adaptation = 0.42;      // how much of the difference to it the picture keeps
// Daylight in units of the shop's own white: an overcast day, brighter than the room, as
// photographed from inside.
constexpr float sky_over_white = 4.5F, horizon_over_white = 3.2F, pavement_over_white = 1.6F;
constexpr float daylight_reach =
    0.35F;  // share of it that the openings' area lights send in (awning, street, dirt)

enum class RowAxis { x, y };

// The direction of most gondolas; of the room's longer side when there are none.
RowAxis row_axis(const Layout& layout) {
  double along_x = 0, along_y = 0;
  for (const Fixture& f : layout.fixtures) {
    if (f.sides == 2) (f.yaw_deg % 180 == 0 ? along_x : along_y) += f.width_mm;
  }
  if (along_x == along_y)
    return layout.shell.width_mm >= layout.shell.depth_mm ? RowAxis::x : RowAxis::y;
  return along_x > along_y ? RowAxis::x : RowAxis::y;
}

// Places of panel rows across their axis: over aisles that run along it, then filled up to an even
// spacing.
std::vector<float> row_places(const Layout& layout, RowAxis axis, float low, float high) {
  std::vector<float> places;
  for (const Aisle& aisle : layout.aisles) {
    const RectMm box = bounds_of(aisle.polygon_mm);
    const int along = axis == RowAxis::x ? box.width() : box.depth(),
              across = axis == RowAxis::x ? box.depth() : box.width();
    if (along < 2 * across || along < 3000 || across > 5000) continue;
    places.push_back(static_cast<float>(axis == RowAxis::x ? box.y0 + box.y1 : box.x0 + box.x1) *
                     0.5e-3F);
  }
  std::sort(places.begin(), places.end());
  std::vector<float> rows;
  const float first = low + wall_distance_m, last = high - wall_distance_m;
  for (const float place : places) {
    const bool fits =
        place > first && place < last && (rows.empty() || place - rows.back() >= closest_rows_m);
    if (fits) rows.push_back(place);
  }
  std::vector<float> filled;
  float from = low - row_pitch_m / 2;
  rows.push_back(high + row_pitch_m / 2);
  for (const float next : rows) {
    const int missing = static_cast<int>(std::lround((next - from) / row_pitch_m)) - 1;
    for (int i = 1; i <= missing; ++i)
      filled.push_back(from +
                       (next - from) * static_cast<float>(i) / static_cast<float>(missing + 1));
    if (next < high) filled.push_back(next);
    from = next;
  }
  std::erase_if(filled, [&](float place) { return place < first - 0.01F || place > last + 0.01F; });
  if (filled.empty()) filled.push_back((low + high) / 2);
  return filled;
}

struct Panel {
  float x = 0, y = 0;  // middle
  float half_x = 0, half_y = 0;
};

bool hangs_free(const Layout& layout, const Room& room, const Panel& panel) {
  const int x = static_cast<int>(std::lround(panel.x * 1000)),
            y = static_cast<int>(std::lround(panel.y * 1000));
  const int dx = static_cast<int>(panel.half_x * 1000) + 50,
            dy = static_cast<int>(panel.half_y * 1000) + 50;
  for (const PointMm corner :
       {PointMm{x - dx, y - dy}, {x + dx, y - dy}, {x + dx, y + dy}, {x - dx, y + dy}}) {
    if (!contains(room.outline, corner)) return false;
  }
  return std::none_of(
      layout.shell.columns.begin(), layout.shell.columns.end(), [&](const Column& c) {
        return overlap({x - dx, y - dy, x + dx, y + dy}, footprint_of(c).grown(50));
      });
}

std::vector<Panel> place_panels(const Layout& layout, const Room& room) {
  const RectMm bounds = bounds_of(room.outline);
  const RowAxis axis = row_axis(layout);
  const auto metres = [](int mm) { return static_cast<float>(mm) * 1e-3F; };
  const bool along_x = axis == RowAxis::x;
  const float low = metres(along_x ? bounds.x0 : bounds.y0),
              high = metres(along_x ? bounds.x1 : bounds.y1);
  const int count = std::max(1, static_cast<int>((high - low) / panel_pitch_m + 0.3F));
  const float pitch = (high - low) / static_cast<float>(count);
  std::vector<Panel> panels;
  for (const float across : row_places(layout,
                                       axis,
                                       metres(along_x ? bounds.y0 : bounds.x0),
                                       metres(along_x ? bounds.y1 : bounds.x1))) {
    for (int i = 0; i < count; ++i) {
      const float along = low + pitch * (static_cast<float>(i) + 0.5F);
      const Panel panel = along_x ? Panel{along, across, panel_length_m / 2, panel_width_m / 2}
                                  : Panel{across, along, panel_width_m / 2, panel_length_m / 2};
      if (hangs_free(layout, room, panel)) panels.push_back(panel);
    }
  }
  return panels;
}

// Irradiance on the floor under unit radiance from all panels, nothing in the way: mean over a
// grid.
float mean_floor_irradiance(const std::vector<AreaLight>& lights, const Bounds3& room) {
  constexpr int grid = 12;
  float sum = 0;
  for (int i = 0; i < grid * grid; ++i) {
    const Vec3f size = room.size();
    const Vec3f point = room.low + Vec3f{size.x * (static_cast<float>(i % grid) + 0.5F) / grid,
                                         size.y * (static_cast<float>(i / grid) + 0.5F) / grid,
                                         0};
    for (const AreaLight& light : lights) {
      const Vec3f to_light = light.corner + (light.edge_u + light.edge_v) * 0.5F - point;
      const float distance2 = dot(to_light, to_light);
      sum += light.area * to_light.z * to_light.z / (distance2 * distance2);
    }
  }
  return sum / (grid * grid);
}

Vec3f tint(double kelvin) {
  const Vec3f lamp = black_body(kelvin), camera = black_body(neutral_kelvin);
  const auto part = [](float a, float b) {
    return static_cast<float>(std::pow(a / b, adaptation));
  };
  const Vec3f color{part(lamp.x, camera.x), part(lamp.y, camera.y), part(lamp.z, camera.z)};
  return color / luminance(color);
}

void add_daylight(World& world, const Room& room, float white) {
  const Vec3f day = tint(6500);
  world.surroundings = {day * (sky_over_white * white),
                        day * (horizon_over_white * white),
                        day * (pavement_over_white * white),
                        true};
  for (const WallEdge& edge : room.walls) {
    for (const WallOpening& o : edge.openings) {
      if (!o.glazed()) continue;
      // Outside the frame; the light side faces the room.
      const Vec3f corner = edge.world_from_wall({o.high, -0.2F, o.sill});
      const Vec3f u = edge.world_from_wall.turn({o.low - o.high, 0, 0}), v{0, 0, o.head - o.sill};
      world.lights.push_back(
          make_area_light(corner, u, v, world.surroundings.horizon * daylight_reach));
    }
  }
}

}  // namespace

LightBuilder::LightBuilder(Draft& draft) {
  panel_ = draft.material({.color = {0, 0, 0}, .emission = {1, 1, 1}});
  frame_ = draft.material({.color = {0.75F, 0.75F, 0.75F}, .roughness = 0.5F});
}

void LightBuilder::build(Draft& draft, const Room& room) const {
  World& world = draft.world();
  const Look& look = draft.scene().layout.look;
  const float z = room.ceiling - below_ceiling_m;
  Mesh frames;
  for (const Panel& p : place_panels(draft.scene().layout, room)) {
    const Vec3f corner{p.x - p.half_x, p.y + p.half_y, z}, u{2 * p.half_x, 0, 0},
        v{0, -2 * p.half_y, 0};
    Mesh quad;
    add_quad(quad, corner, corner + u, corner + u + v, corner + v, 0);
    append(world.ceiling,
           world.shell_glass,
           quad,
           {panel_},
           world,
           {1, static_cast<std::int32_t>(world.lights.size())});
    world.lights.push_back(make_area_light(corner, u, v, {1, 1, 1}));
    const float ox = p.half_x + panel_frame_m, oy = p.half_y + panel_frame_m;
    add_box(
        frames, {p.x - ox, p.y - oy, z - 0.004F}, {p.x + ox, p.y - p.half_y, room.ceiling}, 0, 0);
    add_box(
        frames, {p.x - ox, p.y + p.half_y, z - 0.004F}, {p.x + ox, p.y + oy, room.ceiling}, 0, 0);
    add_box(frames,
            {p.x - ox, p.y - p.half_y, z - 0.004F},
            {p.x - p.half_x, p.y + p.half_y, room.ceiling},
            0,
            0);
    add_box(frames,
            {p.x + p.half_x, p.y - p.half_y, z - 0.004F},
            {p.x + ox, p.y + p.half_y, room.ceiling},
            0,
            0);
  }
  append(world.ceiling, world.shell_glass, frames, {frame_}, world, {1, -1});

  const auto lux = static_cast<float>(look.light_lux);
  const float white = lux * inverse_pi;  // radiance of a white sheet on the floor
  const Vec3f radiance = tint(look.light_kelvin) *
                         (lux / std::max(mean_floor_irradiance(world.lights, world.room), 1e-6F));
  for (AreaLight& light : world.lights)
    light.radiance = radiance;
  world.panel_count = static_cast<std::uint32_t>(world.lights.size());
  world.materials[panel_].emission = radiance;
  world.exposure = 1 / white;
  add_daylight(world, room, white);
}

}  // namespace marketgen::raytrace
