#include "plan/relation.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace marketgen::plan {
namespace {

// What relations are measured against.
struct Yardstick {
  double diagonal_m;
  PointMm inward;
};

Wall entrance_wall(std::span<const Opening> openings) {
  for (const OpeningKind kind : {OpeningKind::entrance, OpeningKind::exit}) {
    const auto door = std::ranges::find(openings, kind, &Opening::kind);
    if (door != openings.end()) return door->wall;
  }
  return Wall::south;
}

RelationMeasure at_most(std::string_view what, double measured_m, double limit_m) {
  return {what, measured_m, limit_m, false, {}};
}

RelationMeasure at_least(std::string_view what, double measured_m, double limit_m) {
  return {what, measured_m, limit_m, true, {}};
}

// Both conditions are to hold: the one with less slack decides.
RelationMeasure both(const RelationMeasure& a, const RelationMeasure& b) {
  return b.slack_m() < a.slack_m() ? b : a;
}

double gap_m(const RectMm& a, const RectMm& b) {
  return 1e-3 * distance_mm(a, b);
}

// Common stretch of two rectangles along x and along y; negative where they are apart.
double shared_x_m(const RectMm& a, const RectMm& b) {
  return 1e-3 * (std::min(a.x1, b.x1) - std::max(a.x0, b.x0));
}
double shared_y_m(const RectMm& a, const RectMm& b) {
  return 1e-3 * (std::min(a.y1, b.y1) - std::max(a.y0, b.y0));
}

// How far the middle of `a` lies beyond that of `b`, in a direction along an axis.
double offset_m(const RectMm& a, const RectMm& b, PointMm direction) {
  const PointMm p = a.center(), q = b.center();
  return 1e-3 * (static_cast<double>(p[0] - q[0]) * direction[0] +
                 static_cast<double>(p[1] - q[1]) * direction[1]);
}

RelationMeasure measure_at(const RectMm& a, const NamedPlace& b) {
  if (b.kind == PlaceKind::zone || b.kind == PlaceKind::opening)
    return at_most("gap", gap_m(a, b.rect), beside_m);
  const double x = shared_x_m(a, b.rect), y = shared_y_m(a, b.rect);
  const bool runs_east = b.rect.width() > b.rect.depth();
  const double own_m = 1e-3 * (runs_east ? a.width() : a.depth());
  return both(at_least("depth shared", runs_east ? y : x, 0),
              at_least("length shared", runs_east ? x : y, 0.5 * own_m));
}

RelationMeasure measure_facing(const RectMm& a, const RectMm& b) {
  const double x = shared_x_m(a, b), y = shared_y_m(a, b);
  if (x > 0 && y > 0) return at_most("depth shared", std::min(x, y), 0);
  return both(at_least("length shared", std::max(x, y), in_line_m),
              at_most("gap", gap_m(a, b), facing_m));
}

double apart_m(PointMm p, PointMm q) {
  const double x = p[0] - q[0], y = p[1] - q[1];
  return 1e-3 * std::sqrt(x * x + y * y);
}

RelationMeasure measure_between(const RectMm& a,
                                const RectMm& b,
                                const RectMm& c,
                                double diagonal) {
  const PointMm p = a.center(), q = b.center(), r = c.center();
  const double x = r[0] - q[0], y = r[1] - q[1];
  const double length = std::sqrt(x * x + y * y);
  const double along = length > 0 ? ((p[0] - q[0]) * x + (p[1] - q[1]) * y) / length : 0;
  const double detour = apart_m(p, q) + apart_m(p, r) - apart_m(q, r);
  return both(
      at_least("way from the nearer one", 1e-3 * std::min(along, length - along), in_line_m),
      at_most("detour", detour, detour_share * diagonal));
}

RelationMeasure measure_pair(RelationKind kind,
                             const RectMm& a,
                             const NamedPlace& place,
                             const RectMm& c,
                             const Yardstick& yardstick) {
  const RectMm& b = place.rect;
  const PointMm in = yardstick.inward;
  const PointMm left{-in[1], in[0]}, right{in[1], -in[0]};
  const double diagonal = yardstick.diagonal_m;
  switch (kind) {
    case RelationKind::near:
      return at_most("gap", gap_m(a, b), std::max(min_near_m, near_share * diagonal));
    case RelationKind::far:
      return at_least("gap", gap_m(a, b), far_share * diagonal);
    case RelationKind::along:
    case RelationKind::at:
      return measure_at(a, place);
    case RelationKind::left_of:
      return at_least("offset", offset_m(a, b, left), in_line_m);
    case RelationKind::right_of:
      return at_least("offset", offset_m(a, b, right), in_line_m);
    case RelationKind::behind:
      return at_least("offset", offset_m(a, b, in), in_line_m);
    case RelationKind::facing:
      return measure_facing(a, b);
    case RelationKind::not_adjacent:
      return at_least("gap", gap_m(a, b), not_adjacent_m);
    case RelationKind::between:
      break;
  }
  return measure_between(a, b, c, diagonal);
}

bool is_for_every_pair(RelationKind kind) {
  return kind == RelationKind::far || kind == RelationKind::not_adjacent;
}

}  // namespace

RelationTerms terms_of(const Relation& relation) {
  return {relation.kind, relation.a, relation.b, relation.c ? *relation.c : std::string_view{}};
}

RelationTerms terms_of(const Requirement& wish) {
  const bool between = wish.relation == RelationKind::between;
  return {wish.relation,
          wish.subject,
          wish.object,
          between ? std::string_view(wish.second_object) : std::string_view{}};
}

std::optional<RelationMeasure> measure_relation(const NamedFloor& floor,
                                                const RelationTerms& relation) {
  const bool between = relation.kind == RelationKind::between;
  const Yardstick yardstick{diagonal_m(floor.bounds), inward_from(entrance_wall(floor.openings))};
  const std::vector<NamedPlace> as = places_named(floor, relation.a),
                                bs = places_named(floor, relation.b),
                                cs = between ? places_named(floor, relation.c)
                                             : std::vector<NamedPlace>(1);
  const bool every = is_for_every_pair(relation.kind);
  std::optional<RelationMeasure> decides;
  for (const NamedPlace& a : as) {
    for (const NamedPlace& b : bs) {
      if (a == b) continue;
      for (const NamedPlace& c : cs) {
        RelationMeasure m = measure_pair(relation.kind, a.rect, b, c.rect, yardstick);
        m.at_mm = a.rect.center();
        const bool more = decides && m.slack_m() > decides->slack_m();
        if (!decides || more != every) decides = m;
      }
    }
  }
  return decides;
}

std::string_view missing_place(const NamedFloor& floor, const RelationTerms& relation) {
  const auto missing = [&](std::string_view name) { return places_named(floor, name).empty(); };
  if (missing(relation.a)) return relation.a;
  if (missing(relation.b)) return relation.b;
  const bool third = relation.kind == RelationKind::between;
  return third && missing(relation.c) ? relation.c : std::string_view{};
}

std::string words_of(const NamedFloor& floor,
                     const RelationTerms& relation,
                     const std::optional<RelationMeasure>& measure) {
  std::string kind(name_of(relation.kind));
  std::ranges::replace(kind, '_', ' ');
  const std::string third = relation.c.empty() ? "" : fmt::format(" and {}", relation.c);
  const std::string said = fmt::format("{} {} {}{}", relation.a, kind, relation.b, third);
  if (measure) {
    return fmt::format("{}: {} {:.1f} m, {} {:.1f} m holds",
                       said,
                       measure->what,
                       measure->measured_m,
                       measure->at_least ? "at least" : "at most",
                       measure->limit_m);
  }
  const std::string_view missing = missing_place(floor, relation);
  return missing.empty() ? said + " cannot be judged: both names stand for the same place"
                         : fmt::format("{} cannot be judged: the store has no {}", said, missing);
}

double diagonal_m(const RectMm& floor) {
  const double w = floor.width(), d = floor.depth();
  return 1e-3 * std::sqrt(w * w + d * d);
}

}  // namespace marketgen::plan
