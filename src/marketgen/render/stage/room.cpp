#include "render/stage/room.h"

#include <algorithm>
#include <cmath>

#include "plan/shell_measures.h"
#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

constexpr float jamb_m = 0.02F;  // at least this much wall stays beside an opening

plan::Wall wall_of(const plan::Shell& shell, PointMm a, PointMm b, bool& on_wall) {
  on_wall = true;
  if (a[1] == 0 && b[1] == 0) return plan::Wall::south;
  if (a[1] == shell.depth_mm && b[1] == shell.depth_mm) return plan::Wall::north;
  if (a[0] == 0 && b[0] == 0) return plan::Wall::west;
  if (a[0] == shell.width_mm && b[0] == shell.width_mm) return plan::Wall::east;
  on_wall = false;
  return plan::Wall::south;
}

WallOpening opening_heights(plan::OpeningKind kind, float ceiling) {
  WallOpening opening;
  opening.kind = kind;
  opening.sill = static_cast<float>(plan::opening_sill_m(kind));
  opening.head = static_cast<float>(plan::opening_top_m(kind, ceiling));
  return opening;
}

std::vector<WallOpening> openings_in(const plan::Shell& shell, PointMm a, PointMm b, float length) {
  std::vector<WallOpening> list;
  bool on_wall = false;
  const plan::Wall wall = wall_of(shell, a, b, on_wall);
  if (!on_wall) return list;
  const bool horizontal = wall == plan::Wall::south || wall == plan::Wall::north;
  const int start = horizontal ? a[0] : a[1], end = horizontal ? b[0] : b[1];
  const double extent = horizontal ? shell.width_mm : shell.depth_mm;
  for (const plan::Opening& o : shell.openings) {
    if (o.wall != wall) continue;
    const double middle = std::fabs(o.center * extent - start) * 1e-3;
    const bool beyond = (o.center * extent - start) * (end - start) < 0;
    WallOpening opening = opening_heights(o.kind, static_cast<float>(shell.ceiling_mm) * 1e-3F);
    const float half = static_cast<float>(o.width_mm) * 0.5e-3F;
    opening.low = std::max(static_cast<float>(middle) - half, jamb_m);
    opening.high = std::min(static_cast<float>(middle) + half, length - jamb_m);
    if (!beyond && opening.high - opening.low > 0.3F) list.push_back(opening);
  }
  std::sort(list.begin(), list.end(), [](const WallOpening& p, const WallOpening& q) {
    return p.low < q.low;
  });
  for (std::size_t i = 1; i < list.size(); ++i)
    list[i].low = std::max(list[i].low, list[i - 1].high + jamb_m);
  std::erase_if(list, [](const WallOpening& o) { return o.high - o.low < 0.3F; });
  return list;
}

double cross_mm(PointMm o, PointMm a, PointMm b) {
  return static_cast<double>(a[0] - o[0]) * (b[1] - o[1]) -
         static_cast<double>(a[1] - o[1]) * (b[0] - o[0]);
}

bool is_ear(const PolygonMm& polygon, const std::vector<std::uint32_t>& ring, std::size_t i) {
  const std::size_t n = ring.size();
  const PointMm a = polygon[ring[(i + n - 1) % n]], b = polygon[ring[i]],
                c = polygon[ring[(i + 1) % n]];
  if (cross_mm(a, b, c) <= 0) return false;
  return std::none_of(ring.begin(), ring.end(), [&](std::uint32_t k) {
    const PointMm p = polygon[k];
    if (p == a || p == b || p == c) return false;
    return cross_mm(a, b, p) >= 0 && cross_mm(b, c, p) >= 0 && cross_mm(c, a, p) >= 0;
  });
}

void move_into(Mesh& mesh, const Placement& frame, std::size_t first_vertex) {
  for (std::size_t i = first_vertex; i < mesh.positions.size(); ++i) {
    mesh.positions[i] = frame(mesh.positions[i]);
    mesh.normals[i] = frame.turn(mesh.normals[i]);
  }
}

}  // namespace

Room room_of(const plan::Shell& shell) {
  Room room;
  room.outline = shell.outline_mm ? *shell.outline_mm
                                  : polygon_of(RectMm{0, 0, shell.width_mm, shell.depth_mm});
  room.ceiling = static_cast<float>(shell.ceiling_mm) * 1e-3F;
  for (std::size_t i = 0; i < room.outline.size(); ++i) {
    const PointMm a = room.outline[i], b = room.outline[(i + 1) % room.outline.size()];
    const Vec3f from{static_cast<float>(a[0]) * 1e-3F, static_cast<float>(a[1]) * 1e-3F, 0};
    const Vec3f to{static_cast<float>(b[0]) * 1e-3F, static_cast<float>(b[1]) * 1e-3F, 0};
    WallEdge edge;
    edge.length = length(to - from);
    const Vec3f along = normalized(to - from);
    edge.world_from_wall = {along, {-along.y, along.x, 0}, {0, 0, 1}, from};
    edge.openings = openings_in(shell, a, b, edge.length);
    if (edge.length > 0) room.walls.push_back(edge);
  }
  return room;
}

std::vector<std::array<std::uint32_t, 3>> triangulated(const PolygonMm& polygon) {
  std::vector<std::uint32_t> ring(polygon.size());
  for (std::size_t i = 0; i < ring.size(); ++i)
    ring[i] = static_cast<std::uint32_t>(i);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  while (ring.size() >= 3) {
    std::size_t ear = 0;
    while (ear < ring.size() && !is_ear(polygon, ring, ear))
      ++ear;
    if (ear == ring.size()) {  // no ear: a point on a straight line
      const std::size_t n = ring.size();
      for (ear = 0; ear < n && cross_mm(polygon[ring[(ear + n - 1) % n]],
                                        polygon[ring[ear]],
                                        polygon[ring[(ear + 1) % n]]) != 0;)
        ++ear;
      if (ear == n) break;
    } else {
      const std::size_t n = ring.size();
      triangles.push_back({ring[(ear + n - 1) % n], ring[ear], ring[(ear + 1) % n]});
    }
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return triangles;
}

void add_framed_box(Mesh& mesh,
                    const Placement& frame,
                    Vec3f low,
                    Vec3f high,
                    float bevel,
                    std::uint16_t surface,
                    float uv_extent) {
  const std::size_t first = mesh.positions.size();
  add_box(mesh, low, high, bevel, surface, 1 / uv_extent);
  move_into(mesh, frame, first);
}

void add_wall_picture(Mesh& mesh,
                      const Placement& frame,
                      float x0,
                      float x1,
                      float y,
                      float z0,
                      float z1,
                      std::uint16_t surface) {
  const std::size_t first = mesh.positions.size();
  // Seen from inside, the wall's x runs to the left.
  add_quad(mesh, {x1, y, z0}, {x0, y, z0}, {x0, y, z1}, {x1, y, z1}, surface);
  move_into(mesh, frame, first);
}

void add_wall_panel(Mesh& mesh,
                    const Placement& frame,
                    float x0,
                    float x1,
                    float y,
                    float z0,
                    float z1,
                    std::uint16_t surface,
                    float uv_extent) {
  const std::size_t first = mesh.uvs.size();
  add_wall_picture(mesh, frame, x0, x1, y, z0, z1, surface);
  const std::array<Vec2f, 4> at{Vec2f{-x1, -z0}, {-x0, -z0}, {-x0, -z1}, {-x1, -z1}};
  for (std::size_t i = 0; i < at.size(); ++i)
    mesh.uvs[first + i] = at[i] * (1 / uv_extent);
}

}  // namespace marketgen::render::raytrace
