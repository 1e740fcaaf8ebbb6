#include "render/stage/build_light.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assets/print/color.h"
#include "base/parallel.h"
#include "render/shading_math.h"
#include "render/tone.h"

namespace marketgen::render::raytrace {
namespace {

// Of one fitting: what glows, how far apart along a row, how far below the ceiling.
struct FittingSize {
  float length_m, width_m, pitch_m, below_ceiling_m;
};
constexpr std::array<FittingSize, catalog::names_of(catalog::LampFitting{}).size()> fitting_sizes{
    FittingSize{1.2F, 0.3F, 2.4F, 0.015F}, {2.26F, 0.15F, 2.4F, 0.14F}, {0.22F, 0.22F, 1.8F, 0.9F}};
constexpr float lowest_lamp_m = 2.6F;  // people, signs and open doors pass below
constexpr float row_pitch_m = 2.8F;    // between rows where no aisle says otherwise
constexpr float closest_rows_m = 1.5F;
constexpr float wall_distance_m = 0.6F;  // panels keep this far from walls
constexpr double neutral_kelvin = 4700;  // the camera's white point
constexpr double adaptation = 0.32;      // how much of the difference to it the picture keeps
// Share of what is seen outside that the openings' area lights send in (awning, street, dirt).
constexpr float daylight_reach = 0.7F;
enum class RowAxis { x, y };

// The direction of most gondolas; of the room's longer side when there are none.
RowAxis row_axis(const layout::Layout& layout) {
  double along_x = 0, along_y = 0;
  for (const layout::Fixture& f : layout.fixtures) {
    if (f.sides == 2) (f.yaw_deg % 180 == 0 ? along_x : along_y) += f.width_mm;
  }
  if (along_x == along_y)
    return layout.shell.width_mm >= layout.shell.depth_mm ? RowAxis::x : RowAxis::y;
  return along_x > along_y ? RowAxis::x : RowAxis::y;
}

// Places of panel rows across their axis: over aisles that run along it, then filled up to an even
// spacing.
std::vector<float> row_places(const layout::Layout& layout, RowAxis axis, float low, float high) {
  std::vector<float> places;
  for (const layout::Aisle& aisle : layout.aisles) {
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

bool hangs_free(const layout::Layout& layout, const Room& room, const Panel& panel) {
  const int x = static_cast<int>(std::lround(panel.x * 1000)),
            y = static_cast<int>(std::lround(panel.y * 1000));
  const int dx = static_cast<int>(panel.half_x * 1000) + 50,
            dy = static_cast<int>(panel.half_y * 1000) + 50;
  for (const PointMm corner :
       {PointMm{x - dx, y - dy}, {x + dx, y - dy}, {x + dx, y + dy}, {x - dx, y + dy}}) {
    if (!contains(room.outline, corner)) return false;
  }
  return std::none_of(
      layout.shell.columns.begin(), layout.shell.columns.end(), [&](const plan::Column& c) {
        return overlap({x - dx, y - dy, x + dx, y + dy}, plan::footprint_of(c).grown(50));
      });
}

std::vector<Panel> place_panels(const layout::Layout& layout,
                                const Room& room,
                                const FittingSize& size) {
  const RectMm bounds = bounds_of(room.outline);
  const RowAxis axis = row_axis(layout);
  const bool along_x = axis == RowAxis::x;
  const float low = metres(along_x ? bounds.x0 : bounds.y0),
              high = metres(along_x ? bounds.x1 : bounds.y1);
  const int count = std::max(1, static_cast<int>((high - low) / size.pitch_m + 0.3F));
  const float pitch = (high - low) / static_cast<float>(count);
  std::vector<Panel> panels;
  for (const float across : row_places(layout,
                                       axis,
                                       metres(along_x ? bounds.y0 : bounds.x0),
                                       metres(along_x ? bounds.y1 : bounds.x1))) {
    for (int i = 0; i < count; ++i) {
      const float along = low + pitch * (static_cast<float>(i) + 0.5F);
      const Panel panel = along_x ? Panel{along, across, size.length_m / 2, size.width_m / 2}
                                  : Panel{across, along, size.width_m / 2, size.length_m / 2};
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
      const Vec3f to_light = light.middle() - point;
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

void add_daylight(World& world, const Room& room, const plan::Look& look, float white) {
  world.surroundings.white = white;
  world.surroundings.daylight = static_cast<float>(look.daylight.value_or(1));
  world.surroundings.day_tint = tint(6500);
  world.surroundings.sampled_as_lights = true;
  const Vec3f radiance = world.surroundings.mean_radiance() * daylight_reach;
  for (const WallEdge& edge : room.walls) {
    for (const WallOpening& o : edge.openings) {
      if (!o.glazed()) continue;
      // Outside the frame; the light side faces the room.
      const Vec3f corner = edge.world_from_wall({o.high, -0.2F, o.sill});
      const Vec3f u = edge.world_from_wall.turn({o.low - o.high, 0, 0}), v{0, 0, o.head - o.sill};
      world.lights.push_back(make_area_light(corner, u, v, radiance));
    }
  }
}

// The bodies of fittings around what glows at height z. Surfaces: 0 their outside, 1 white inside.

void add_panel_frame(Mesh& mesh, const Panel& p, float z, float ceiling) {
  constexpr float rim = 0.02F, lip = 0.004F;
  const float ox = p.half_x + rim, oy = p.half_y + rim;
  add_box(mesh, {p.x - ox, p.y - oy, z - lip}, {p.x + ox, p.y - p.half_y, ceiling}, 0, 0);
  add_box(mesh, {p.x - ox, p.y + p.half_y, z - lip}, {p.x + ox, p.y + oy, ceiling}, 0, 0);
  add_box(
      mesh, {p.x - ox, p.y - p.half_y, z - lip}, {p.x - p.half_x, p.y + p.half_y, ceiling}, 0, 0);
  add_box(
      mesh, {p.x + p.half_x, p.y - p.half_y, z - lip}, {p.x + ox, p.y + p.half_y, ceiling}, 0, 0);
}

void add_cord(Mesh& mesh, float x, float y, float low, float ceiling) {
  constexpr float half = 0.003F;
  add_box(mesh, {x - half, y - half, low}, {x + half, y + half, ceiling}, 0, 0);
}

// A profile on two cords; neighbours in a row all but touch.
void add_line_body(Mesh& mesh, const Panel& p, float z, float ceiling) {
  constexpr float rim = 0.006F, height = 0.06F, cord_share = 0.8F;
  add_box(mesh,
          {p.x - p.half_x - rim, p.y - p.half_y - rim, z + 0.002F},
          {p.x + p.half_x + rim, p.y + p.half_y + rim, z + height},
          0.003F,
          0);
  const bool along_x = p.half_x > p.half_y;
  for (const float side : {-cord_share, cord_share}) {
    add_cord(mesh,
             p.x + (along_x ? side * p.half_x : 0),
             p.y + (along_x ? 0 : side * p.half_y),
             z + height,
             ceiling);
  }
}

// A round shade on a cord, white within; the light sits inside its mouth.
void add_pendant_body(Mesh& mesh, const Panel& p, float z, float ceiling) {
  constexpr int segments = 28;
  constexpr float wall = 0.004F;
  const std::vector<ProfilePoint> shade{{0.225F, -0.045F, 0},
                                        {0.215F, 0.02F, 0},
                                        {0.175F, 0.085F, 0},
                                        {0.105F, 0.135F, 0},
                                        {0.045F, 0.165F, 0, true},
                                        {0.035F, 0.235F, 0, true},
                                        {0, 0.24F, 0}};
  const std::size_t first = mesh.positions.size();
  add_lathe(mesh, shade, segments);
  Mesh inside;
  add_lathe(inside, {shade.begin(), shade.begin() + 5}, segments);
  for (std::size_t v = 0; v < inside.positions.size(); ++v) {
    inside.positions[v] = inside.positions[v] - inside.normals[v] * wall;
    inside.normals[v] = -inside.normals[v];
  }
  for (std::size_t t = 0; t < inside.triangles.size(); ++t) {
    std::swap(inside.triangles[t][1], inside.triangles[t][2]);
    inside.surfaces[t] = 1;
  }
  mesh.append(inside);
  for (std::size_t v = first; v < mesh.positions.size(); ++v)
    mesh.positions[v] += Vec3f{p.x, p.y, z};
  add_cord(mesh, p.x, p.y, z + 0.235F, ceiling);
}

}  // namespace

LightBuilder::LightBuilder(Draft& draft) {
  const plan::Look& look = draft.scene().layout.look;
  fitting_ = look.lamps.value_or(catalog::LampFitting::panel);
  panel_ = draft.material({.color = {0, 0, 0}, .emission = {1, 1, 1}});
  Material body{.color = {0.75F, 0.75F, 0.75F}, .roughness = 0.5F};
  if (fitting_ == catalog::LampFitting::line) body.color = {0.22F, 0.22F, 0.225F};
  if (fitting_ == catalog::LampFitting::pendant) {
    const Result<Vec3f> accent = assets::linear_from_hex(look.accent);
    if (accent.ok()) body.color = *accent;
    body.roughness = 0.3F;
  }
  body_ = draft.material(body);
  inside_ = draft.material({.color = {0.85F, 0.85F, 0.83F}, .roughness = 0.6F});
}

void LightBuilder::add_lamps(World& world, const layout::Layout& layout, const Room& room) const {
  const FittingSize& size = fitting_sizes[static_cast<std::size_t>(fitting_)];
  const float z = std::min(room.ceiling - fitting_sizes[0].below_ceiling_m,
                           std::max(lowest_lamp_m, room.ceiling - size.below_ceiling_m));
  Mesh bodies;
  for (const Panel& p : place_panels(layout, room, size)) {
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
    if (fitting_ == catalog::LampFitting::line)
      add_line_body(bodies, p, z, room.ceiling);
    else if (fitting_ == catalog::LampFitting::pendant)
      add_pendant_body(bodies, p, z, room.ceiling);
    else
      add_panel_frame(bodies, p, z, room.ceiling);
  }
  append(world.ceiling, world.shell_glass, bodies, {body_, inside_}, world, {1, -1});
}

void LightBuilder::build(Draft& draft, const Room& room) const {
  World& world = draft.world();
  const plan::Look& look = draft.scene().layout.look;
  add_lamps(world, draft.scene().layout, room);
  const auto lux = static_cast<float>(look.light_lux);
  const float white = lux * inverse_pi;  // radiance of a white sheet on the floor
  const Vec3f radiance = tint(look.light_kelvin) *
                         (lux / std::max(mean_floor_irradiance(world.lights, world.room), 1e-6F));
  for (AreaLight& light : world.lights)
    light.radiance = radiance;
  world.panel_count = static_cast<std::uint32_t>(world.lights.size());
  world.materials[panel_].emission = radiance;
  world.exposure = 1 / white;
  add_daylight(world, room, look, white);
}

}  // namespace marketgen::render::raytrace
