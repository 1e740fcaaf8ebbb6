#include "layout/relations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "layout/floor.h"

namespace marketgen {
namespace {

// Shares of the shop's diagonal.
constexpr double near_share = 0.2, far_share = 0.4, between_share = 0.15;
constexpr double near_least_m = 4;
constexpr double along_m = 1.5;  // a zone along a wall reaches at least this near
constexpr double facing_m = 6;   // across the widest aisle
constexpr double apart_m = 1.2;  // not adjacent: an aisle between

struct View {
  const Layout& layout;
  double diagonal_m;
  Side in_from;  // the entrance's wall
};

View view_of(const Layout& layout) {
  const double w = layout.shell.width_mm * 1e-3, d = layout.shell.depth_mm * 1e-3;
  const Floor floor = make_floor(layout.shell);
  const Doorway* door = entrance_of(floor, layout.shell);
  return {layout, std::sqrt(w * w + d * d), door == nullptr ? Side::south : door->wall};
}

std::optional<Side> wall_named(std::string_view name) {
  const auto wall = value_named<Wall>(name);
  return wall ? std::optional(side_of(*wall)) : std::nullopt;
}

double center_distance_m(const RectMm& a, const RectMm& b) {
  return distance_m(RectMm{a.center()[0], a.center()[1], a.center()[0], a.center()[1]}, b.center());
}

// How far the middle of a lies to the left of b's, and how far beyond it, for someone coming in.
double left_m(const View& view, const RectMm& a, const RectMm& b) {
  const double dx = (a.center()[0] - b.center()[0]) * 1e-3,
               dy = (a.center()[1] - b.center()[1]) * 1e-3;
  switch (view.in_from) {
    case Side::south:
      return -dx;
    case Side::north:
      return dx;
    case Side::west:
      return dy;
    case Side::east:
      return -dy;
  }
  return 0;
}

double behind_m(const View& view, const RectMm& a, const RectMm& b) {
  const double dx = (a.center()[0] - b.center()[0]) * 1e-3,
               dy = (a.center()[1] - b.center()[1]) * 1e-3;
  switch (view.in_from) {
    case Side::south:
      return dy;
    case Side::north:
      return -dy;
    case Side::west:
      return dx;
    case Side::east:
      return -dx;
  }
  return 0;
}

// Value, limit, and whether more is better.
struct Measure {
  double value = 0, limit = 0;
  bool at_least = false;
  bool holds() const { return at_least ? value >= limit : value <= limit; }
};

Measure measure(
    const View& view, RelationKind kind, const RectMm& a, const RectMm& b, const RectMm* c) {
  const double near = std::max(near_least_m, near_share * view.diagonal_m);
  switch (kind) {
    case RelationKind::near:
      return {distance_m(a, b), near, false};
    case RelationKind::far:
      return {center_distance_m(a, b), far_share * view.diagonal_m, true};
    case RelationKind::along:
      return {distance_m(a, b), along_m, false};
    case RelationKind::at:
      return {distance_m(a, b), std::min(near, near_least_m), false};
    case RelationKind::left_of:
      return {left_m(view, a, b), 0, true};
    case RelationKind::right_of:
      return {-left_m(view, a, b), 0, true};
    case RelationKind::behind:
      return {behind_m(view, a, b), 0, true};
    case RelationKind::facing:
      return {distance_m(a, b), facing_m, false};
    case RelationKind::between: {
      if (c == nullptr) return {0, 0, false};
      const double detour =
          center_distance_m(a, b) + center_distance_m(a, *c) - center_distance_m(b, *c);
      return {detour, between_share * view.diagonal_m, false};
    }
    case RelationKind::not_adjacent:
      return {distance_m(a, b), apart_m, true};
  }
  return {};
}

std::string words(const Relation& relation, const Measure& m) {
  std::string kind(name_of(relation.kind));
  std::ranges::replace(kind, '_', ' ');
  const std::string third = relation.c ? " and " + *relation.c : "";
  return fmt::format("{} should be {} {}{}; measured {:.1f} m, {} {:.1f} m holds",
                     relation.a,
                     kind,
                     relation.b,
                     third,
                     m.value,
                     m.at_least ? "at least" : "at most",
                     m.limit);
}

}  // namespace

double distance_m(const RectMm& a, const RectMm& b) {
  const double dx = std::max({a.x0 - b.x1, 0, b.x0 - a.x1}) * 1e-3;
  const double dy = std::max({a.y0 - b.y1, 0, b.y0 - a.y1}) * 1e-3;
  return std::sqrt(dx * dx + dy * dy);
}

double distance_m(const RectMm& a, PointMm b) {
  return distance_m(a, RectMm{b[0], b[1], b[0], b[1]});
}

std::vector<RectMm> places_named(const Layout& layout, std::string_view name) {
  const Floor floor = make_floor(layout.shell);
  std::vector<RectMm> places;
  if (const auto wall = wall_named(name)) return {strip_inside(floor.bounds, *wall, 0)};
  if (name == "center") {
    const PointMm c = floor.bounds.center();
    return {{c[0], c[1], c[0], c[1]}};
  }
  for (const LayoutZone& zone : layout.zones) {
    if (zone.id == name) return {bounds_of(zone.polygon_mm)};
    if (zone.type == name) places.push_back(bounds_of(zone.polygon_mm));
  }
  for (const Doorway& door : floor.doorways) {
    const Opening& opening = layout.shell.openings[door.opening];
    const RectMm at = cut_along(strip_inside(floor.bounds, door.wall, 0), door.wall, door.span);
    if (opening.id == name) return {at};
    if (name_of(opening.kind) == name) places.push_back(at);
  }
  return places;
}

RelationResult check_relation(const Layout& layout, const Relation& relation) {
  const std::vector<RectMm> as = places_named(layout, relation.a);
  const std::vector<RectMm> bs = places_named(layout, relation.b);
  const std::vector<RectMm> cs =
      relation.c ? places_named(layout, *relation.c) : std::vector<RectMm>{};
  RelationResult result{true, 0, 0, {}, {}};
  if (as.empty() || bs.empty() || (relation.c && cs.empty())) return result;
  const View view = view_of(layout);
  const bool all_must =
      relation.kind == RelationKind::far || relation.kind == RelationKind::not_adjacent;
  // One pair that holds is enough, except where nothing may be near.
  bool any = false, all = true;
  for (const RectMm& a : as) {
    for (const RectMm& b : bs) {
      if (a == b) continue;
      const Measure m = measure(view, relation.kind, a, b, cs.empty() ? nullptr : &cs.front());
      any = any || m.holds();
      all = all && m.holds();
      if (m.holds() && !all_must) return {true, m.value, m.limit, words(relation, m), a.center()};
      if (!m.holds()) result = {false, m.value, m.limit, words(relation, m), a.center()};
    }
  }
  result.holds = all_must ? all : any;
  return result;
}

}  // namespace marketgen
