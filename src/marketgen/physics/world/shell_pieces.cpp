#include "physics/world/shell_pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "layout/floor.h"
#include "plan/shell_measures.h"

namespace marketgen::physics {
namespace {

// An opening on one wall: its stretch along the wall and its heights, metres.
struct Hole {
  double from, to, bottom, top;
  const plan::Opening* opening;
};

// One side of the outline with the floor on its left; metres.
struct WallLine {
  std::string id;
  Vec3 start, along, outward;  // unit vectors
  double length;
  bool ends_at_outer_corner;  // filled by lengthening this wall, not the next
};

bool turns_left(const PolygonMm& outline, std::size_t corner) {
  const std::size_t n = outline.size();
  const PointMm &a = outline[(corner + n - 1) % n], &b = outline[corner],
                &c = outline[(corner + 1) % n];
  return std::int64_t{b[0] - a[0]} * (c[1] - b[1]) - std::int64_t{b[1] - a[1]} * (c[0] - b[0]) > 0;
}

WallLine wall_line(const PolygonMm& outline, std::size_t i) {
  const PointMm &a = outline[i], &b = outline[(i + 1) % outline.size()];
  const Vec3 start{a[0] * 1e-3, a[1] * 1e-3, 0}, end{b[0] * 1e-3, b[1] * 1e-3, 0};
  const Vec3 along = normalized(end - start);
  return {fmt::format("wall-{}", i),
          start,
          along,
          {along.y, -along.x, 0},
          length(end - start),
          turns_left(outline, (i + 1) % outline.size())};
}

Hole hole_of(const layout::Doorway& door,
             const plan::Opening& opening,
             const WallLine& wall,
             const layout::Floor& floor,
             double ceiling_m) {
  const layout::Span span = door.span;
  const double line = layout::coordinate(floor.bounds, door.wall) * 1e-3;
  const bool along_x = layout::lies_along_x(door.wall);
  const auto place = [&](int at) {
    const Vec3 point = along_x ? Vec3{at * 1e-3, line, 0} : Vec3{line, at * 1e-3, 0};
    return dot(point - wall.start, wall.along);
  };
  const auto [from, to] = std::minmax({place(span.from), place(span.to)});
  return {from,
          to,
          plan::opening_sill_m(opening.kind),
          plan::opening_top_m(opening.kind, ceiling_m),
          &opening};
}

// Openings in this wall, from its start to its end. An opening belongs to the part of the bounding
// box's side it lies on.
std::vector<Hole> holes_in(const WallLine& wall,
                           const layout::Floor& floor,
                           const plan::Shell& shell) {
  std::vector<Hole> holes;
  for (const layout::Doorway& door : floor.doorways) {
    const Vec3 threshold{door.threshold[0] * 1e-3, door.threshold[1] * 1e-3, 0};
    const Vec3 offset = threshold - wall.start;
    const double along = dot(offset, wall.along), beside = dot(offset, wall.outward);
    if (std::abs(beside) > 1e-3 || along < 0 || along > wall.length) continue;
    holes.push_back(
        hole_of(door, shell.openings[door.opening], wall, floor, shell.ceiling_mm * 1e-3));
  }
  std::ranges::sort(holes, {}, &Hole::from);
  return holes;
}

// What lies between two depths behind a wall's inner face.
struct Slab {
  double front, back;
};

// A box that covers from..to along the wall and bottom..top.
ShellPiece piece(
    const WallLine& wall, std::string id, ShellPieceKind kind, const Hole& area, Slab slab) {
  const Vec3 middle = wall.start + wall.along * ((area.from + area.to) / 2) +
                      wall.outward * ((slab.front + slab.back) / 2);
  const double yaw = std::atan2(wall.along.y, wall.along.x);
  const double quarters = yaw / (std::acos(-1.0) / 2), nearest = std::round(quarters);
  const Quaternion turn = std::abs(quarters - nearest) < 1e-9
                              ? yaw_from_quarter_turns(static_cast<int>(nearest))
                              : rotation_about({0, 0, 1}, yaw);
  return {std::move(id),
          kind,
          {{middle.x, middle.y, (area.bottom + area.top) / 2}, turn},
          {(area.to - area.from) / 2, (slab.back - slab.front) / 2, (area.top - area.bottom) / 2}};
}

void add_wall(std::vector<ShellPiece>& pieces,
              const WallLine& wall,
              const std::vector<Hole>& holes,
              double ceiling_m) {
  int count = 0;
  const auto add = [&](double from, double to, double bottom, double top) {
    if (to - from < 1e-3 || top - bottom < 1e-3) return;
    pieces.push_back(piece(wall,
                           fmt::format("{}/piece-{}", wall.id, count++),
                           ShellPieceKind::wall,
                           {from, to, bottom, top, nullptr},
                           {0, plan::wall_thickness_m}));
  };
  double from = 0;
  for (const Hole& hole : holes) {
    add(from, hole.from, 0, ceiling_m);
    add(hole.from, hole.to, 0, hole.bottom);
    add(hole.from, hole.to, hole.top, ceiling_m);
    from = hole.to;
  }
  add(from, wall.length + (wall.ends_at_outer_corner ? plan::wall_thickness_m : 0), 0, ceiling_m);
}

void add_closures(std::vector<ShellPiece>& pieces,
                  const WallLine& wall,
                  const std::vector<Hole>& holes) {
  for (const Hole& hole : holes) {
    const plan::OpeningKind kind = hole.opening->kind;
    if (kind == plan::OpeningKind::entrance || kind == plan::OpeningKind::exit) continue;
    const bool window = kind == plan::OpeningKind::window;
    pieces.push_back(piece(wall,
                           fmt::format("{}/{}", window ? "pane" : "door", hole.opening->id),
                           window ? ShellPieceKind::pane : ShellPieceKind::door,
                           hole,
                           window ? Slab{plan::glazing_front_m, plan::glazing_back_m}
                                  : Slab{plan::door_leaf_front_m, plan::door_leaf_back_m}));
  }
}

}  // namespace

std::vector<ShellPiece> shell_pieces(const plan::Shell& shell) {
  const layout::Floor floor = layout::make_floor(shell);
  const double ceiling_m = shell.ceiling_mm * 1e-3;
  std::vector<ShellPiece> pieces;
  for (std::size_t i = 0; i < floor.outline.size(); ++i) {
    const WallLine wall = wall_line(floor.outline, i);
    const std::vector<Hole> holes = holes_in(wall, floor, shell);
    add_wall(pieces, wall, holes, ceiling_m);
    add_closures(pieces, wall, holes);
  }
  for (std::size_t i = 0; i < floor.columns.size(); ++i) {
    const RectMm& c = floor.columns[i];
    pieces.push_back({fmt::format("column-{}", i),
                      ShellPieceKind::column,
                      {{(c.x0 + c.x1) * 5e-4, (c.y0 + c.y1) * 5e-4, ceiling_m / 2}, {}},
                      {c.width() * 5e-4, c.depth() * 5e-4, ceiling_m / 2}});
  }
  return pieces;
}

}  // namespace marketgen::physics
