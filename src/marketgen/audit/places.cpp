#include "audit/places.h"

#include <algorithm>
#include <cmath>

#include "audit/traffic.h"

namespace marketgen {
namespace {

constexpr int wall_strip_mm = 1500;  // how deep a wall reaches when something stands "along" it
constexpr double near_share = 0.20, far_share = 0.35;
constexpr double least_near_mm = 3000;

RectMm wall_strip(const Shell& shell, Wall wall) {
  switch (wall) {
    case Wall::south:
      return {0, 0, shell.width_mm, wall_strip_mm};
    case Wall::north:
      return {0, shell.depth_mm - wall_strip_mm, shell.width_mm, shell.depth_mm};
    case Wall::west:
      return {0, 0, wall_strip_mm, shell.depth_mm};
    default:
      return {shell.width_mm - wall_strip_mm, 0, shell.width_mm, shell.depth_mm};
  }
}

RectMm opening_place(const Shell& shell, const Opening& opening) {
  constexpr int half_mm = 500;
  const PointMm p = inside_of(shell, opening, half_mm);
  return RectMm{p[0], p[1], p[0], p[1]}.grown(half_mm);
}

RectMm middle_of(const Shell& shell) {
  return {shell.width_mm / 3, shell.depth_mm / 3, shell.width_mm * 2 / 3, shell.depth_mm * 2 / 3};
}

double distance_mm(const RectMm& a, const RectMm& b) {
  const double dx = std::max({0, a.x0 - b.x1, b.x0 - a.x1}),
               dy = std::max({0, a.y0 - b.y1, b.y0 - a.y1});
  return std::sqrt(dx * dx + dy * dy);
}

double diagonal_mm(const Scene& scene) {
  return std::hypot(scene.layout.shell.width_mm, scene.layout.shell.depth_mm);
}

RelationCheck nearness(const Scene& scene, const RectMm& a, const RectMm& b, bool wanted_near) {
  const double distance = distance_mm(a, b);
  const bool holds = wanted_near
                         ? distance <= std::max(least_near_mm, near_share * diagonal_mm(scene))
                         : distance >= far_share * diagonal_mm(scene);
  return {holds, distance * 1e-3};
}

// Touches the place, and with at least half of its longer side when that is a wall's strip.
RelationCheck along(const RectMm& a, const RectMm& strip) {
  const auto shared = intersection(a, strip);
  if (!shared) return {false, distance_mm(a, strip) * 1e-3};
  const bool strip_runs_east = strip.width() > strip.depth();
  const int length = strip_runs_east ? shared->width() : shared->depth();
  const int own = strip_runs_east ? a.width() : a.depth();
  return {2 * length >= own, length * 1e-3};
}

// Direction in which someone walks who comes in: from the first entrance's wall into the store.
PointMm inward(const Shell& shell) {
  for (const Opening& opening : shell.openings) {
    if (opening.kind != OpeningKind::entrance) continue;
    switch (opening.wall) {
      case Wall::south:
        return {0, 1};
      case Wall::north:
        return {0, -1};
      case Wall::west:
        return {1, 0};
      default:
        return {-1, 0};
    }
  }
  return {0, 1};
}

double offset_mm(const RectMm& a, const RectMm& b, PointMm direction) {
  const PointMm p = a.center(), q = b.center();
  return static_cast<double>(p[0] - q[0]) * direction[0] +
         static_cast<double>(p[1] - q[1]) * direction[1];
}

RelationCheck check_pair(const Scene& scene, RelationKind kind, const RectMm& a, const RectMm& b) {
  const PointMm in = inward(scene.layout.shell);
  const PointMm left{-in[1], in[0]};
  switch (kind) {
    case RelationKind::near:
      return nearness(scene, a, b, true);
    case RelationKind::far:
      return nearness(scene, a, b, false);
    case RelationKind::along:
    case RelationKind::at:
      return along(a, b);
    case RelationKind::left_of:
      return {offset_mm(a, b, left) > 0, offset_mm(a, b, left) * 1e-3};
    case RelationKind::right_of:
      return {offset_mm(a, b, left) < 0, -offset_mm(a, b, left) * 1e-3};
    case RelationKind::behind:
      return {offset_mm(a, b, in) > 0, offset_mm(a, b, in) * 1e-3};
    case RelationKind::facing: {
      const bool share = std::min(a.x1, b.x1) > std::max(a.x0, b.x0) ||
                         std::min(a.y1, b.y1) > std::max(a.y0, b.y0);
      return {share && !overlap(a, b), distance_mm(a, b) * 1e-3};
    }
    case RelationKind::not_adjacent:
      return {distance_mm(a, b) > 500, distance_mm(a, b) * 1e-3};
    case RelationKind::between:
      break;
  }
  return {};
}

RelationCheck check_between(const RectMm& a, const RectMm& b, const RectMm& c) {
  const double apart = distance_mm(b, c);
  const double worst = std::max(distance_mm(a, b), distance_mm(a, c));
  const PointMm p = a.center(), q = b.center(), r = c.center();
  const double along_line = static_cast<double>(p[0] - q[0]) * (r[0] - q[0]) +
                            static_cast<double>(p[1] - q[1]) * (r[1] - q[1]);
  const double whole = static_cast<double>(r[0] - q[0]) * (r[0] - q[0]) +
                       static_cast<double>(r[1] - q[1]) * (r[1] - q[1]);
  const bool inside = along_line > 0 && along_line < whole;
  return {inside && worst <= std::max(apart, least_near_mm), worst * 1e-3};
}

}  // namespace

std::vector<RectMm> places_named(const Scene& scene, std::string_view name) {
  const Layout& layout = scene.layout;
  std::vector<RectMm> places;
  if (const auto wall = value_named<Wall>(name)) places.push_back(wall_strip(layout.shell, *wall));
  if (name == "center") places.push_back(middle_of(layout.shell));
  for (const LayoutZone& zone : layout.zones) {
    const bool till = name == "checkout" && zone.type == "self_checkout";
    if (zone.id == name || zone.type == name || till) places.push_back(bounds_of(zone.polygon_mm));
  }
  for (const Opening& opening : layout.shell.openings) {
    if (opening.id == name || name_of(opening.kind) == name)
      places.push_back(opening_place(layout.shell, opening));
  }
  return places;
}

RelationCheck check_relation(const Scene& scene,
                             RelationKind kind,
                             std::string_view a,
                             std::string_view b,
                             std::string_view c) {
  RelationCheck best;
  bool first = true;
  const bool every = kind == RelationKind::far ||
                     kind == RelationKind::not_adjacent;  // holds for all pairs, others for one
  for (const RectMm& place_a : places_named(scene, a)) {
    for (const RectMm& place_b : places_named(scene, b)) {
      std::vector<RectMm> thirds =
          kind == RelationKind::between ? places_named(scene, c) : std::vector<RectMm>{RectMm{}};
      for (const RectMm& place_c : thirds) {
        const RelationCheck check = kind == RelationKind::between
                                        ? check_between(place_a, place_b, place_c)
                                        : check_pair(scene, kind, place_a, place_b);
        if (first || check.holds != every) best = check;
        first = false;
        if (check.holds != every) return best;
      }
    }
  }
  return best;
}

}  // namespace marketgen
