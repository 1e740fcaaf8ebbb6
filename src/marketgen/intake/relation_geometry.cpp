#include "intake/relation_geometry.h"

#include <algorithm>
#include <cmath>

namespace marketgen {
namespace {

constexpr int wall_strip_mm = 1500;
constexpr double near_share = 0.20, far_share = 0.36, between_share = 0.15;  // of the diagonal
constexpr double least_near_mm = 3000;
constexpr double not_adjacent_mm = 1200;  // an aisle between
constexpr double facing_mm = 6000;        // across the widest aisle
constexpr double at_center_mm = 4000;
constexpr int threshold_mm = 500;  // half of the square that stands for a door
// Candidates are held to a little more than the audit asks: layouts shift by some decimetres.
constexpr double margin = 0.9;

RectMm wall_strip(const RectMm& floor, Wall wall) {
  switch (wall) {
    case Wall::north:
      return {floor.x0, floor.y1 - wall_strip_mm, floor.x1, floor.y1};
    case Wall::south:
      return {floor.x0, floor.y0, floor.x1, floor.y0 + wall_strip_mm};
    case Wall::east:
      return {floor.x1 - wall_strip_mm, floor.y0, floor.x1, floor.y1};
    case Wall::west:
      break;
  }
  return {floor.x0, floor.y0, floor.x0 + wall_strip_mm, floor.y1};
}

RectMm middle_third(const RectMm& floor) {
  return {floor.width() / 3, floor.depth() / 3, floor.width() * 2 / 3, floor.depth() * 2 / 3};
}

RectMm door_square(const Opening& opening, const RectMm& floor) {
  PointMm p = threshold_of(opening, floor);
  p[0] = std::clamp(p[0], floor.x0 + threshold_mm, floor.x1 - threshold_mm);
  p[1] = std::clamp(p[1], floor.y0 + threshold_mm, floor.y1 - threshold_mm);
  return RectMm{p[0], p[1], p[0], p[1]}.grown(threshold_mm);
}

double diagonal_mm(const RectMm& floor) {
  const double w = floor.width(), d = floor.depth();
  return std::sqrt(w * w + d * d);
}

// The way someone walks who comes in.
PointMm inward(const Candidate& candidate) {
  switch (candidate.openings.front().wall) {
    case Wall::north:
      return {0, -1};
    case Wall::east:
      return {-1, 0};
    case Wall::west:
      return {1, 0};
    case Wall::south:
      break;
  }
  return {0, 1};
}

double offset_mm(const RectMm& a, const RectMm& b, PointMm direction) {
  const PointMm p = a.center(), q = b.center();
  return static_cast<double>(p[0] - q[0]) * direction[0] +
         static_cast<double>(p[1] - q[1]) * direction[1];
}

// Misses are measured in millimetres here: 0 or less when the relation holds.
double miss_at(const RectMm& a, const RectMm& place) {
  const auto shared = intersection(a, place);
  if (!shared) return distance_mm(a, place) + 1;
  const bool runs_east = place.width() > place.depth();
  const int length = runs_east ? shared->width() : shared->depth();
  const int own = runs_east ? a.width() : a.depth();
  return 0.5 * own - length;
}

RectMm point_rect(PointMm p) {
  return {p[0], p[1], p[0], p[1]};
}

double miss_at_center(const RectMm& a, const RectMm& floor) {
  return std::max(miss_at(a, middle_third(floor)),
                  distance_mm(a, point_rect(floor.center())) - at_center_mm * margin);
}

double miss_facing(const RectMm& a, const RectMm& b) {
  const int beside_x = std::max(a.x0, b.x0) - std::min(a.x1, b.x1);
  const int beside_y = std::max(a.y0, b.y0) - std::min(a.y1, b.y1);
  return std::max(std::min(beside_x, beside_y) + 1.0, distance_mm(a, b) - facing_mm * margin);
}

double miss_between(const RectMm& a, const RectMm& b, const RectMm& c, double diagonal) {
  const PointMm p = a.center(), q = b.center(), r = c.center();
  const double x = r[0] - q[0], y = r[1] - q[1];
  const double along = (p[0] - q[0]) * x + (p[1] - q[1]) * y;
  const double whole = x * x + y * y;
  const double outside = whole > 0 ? std::max(-along, along - whole) / std::sqrt(whole) : 1;
  const double worst = std::max(distance_mm(a, b), distance_mm(a, c));
  const double allowed = std::max(distance_mm(b, c), least_near_mm) * margin;
  const auto apart = [](PointMm m, PointMm n) { return distance_mm(point_rect(m), point_rect(n)); };
  const double detour = apart(p, q) + apart(p, r) - apart(q, r);
  return std::max({outside + 1, worst - allowed, detour - between_share * diagonal * margin});
}

double miss_pair(RelationKind kind, const RectMm& a, const RectMm& b, const Candidate& candidate) {
  const double diagonal = diagonal_mm(candidate.floor);
  const PointMm in = inward(candidate);
  const PointMm left{-in[1], in[0]};
  constexpr double aside_mm = 200;
  switch (kind) {
    case RelationKind::near:
      return distance_mm(a, b) - std::max(least_near_mm, near_share * diagonal) * margin;
    case RelationKind::far:
      return far_share * diagonal / margin - distance_mm(a, b);
    case RelationKind::along:
    case RelationKind::at:
      return b == middle_third(candidate.floor) ? miss_at_center(a, candidate.floor)
                                                : miss_at(a, b);
    case RelationKind::left_of:
      return aside_mm - offset_mm(a, b, left);
    case RelationKind::right_of:
      return aside_mm + offset_mm(a, b, left);
    case RelationKind::behind:
      return aside_mm - offset_mm(a, b, in);
    case RelationKind::facing:
      return miss_facing(a, b);
    case RelationKind::not_adjacent:
      return not_adjacent_mm / margin - distance_mm(a, b);
    case RelationKind::between:
      break;
  }
  return 0;
}

}  // namespace

double distance_mm(const RectMm& a, const RectMm& b) {
  const double dx = std::max({0, a.x0 - b.x1, b.x0 - a.x1});
  const double dy = std::max({0, a.y0 - b.y1, b.y0 - a.y1});
  return std::sqrt(dx * dx + dy * dy);
}

std::vector<RectMm> places_named(const Candidate& candidate,
                                 const StoreProgram& program,
                                 std::string_view name) {
  std::vector<RectMm> places;
  if (const auto wall = value_named<Wall>(name)) {
    places.push_back(wall_strip(candidate.floor, *wall));
  }
  if (name == "center") places.push_back(middle_third(candidate.floor));
  for (std::size_t i = 0; i < program.zones.size(); ++i) {
    const std::string& type = program.zones[i].type->type;
    const bool till = name == "checkout" && type == "self_checkout";
    if ((type == name || till) && !candidate.rects[i].empty()) places.push_back(candidate.rects[i]);
  }
  for (const Opening& opening : candidate.openings) {
    if (name_of(opening.kind) == name) places.push_back(door_square(opening, candidate.floor));
  }
  return places;
}

const std::vector<RectMm>& Places::named(std::string_view name) {
  const auto known = known_.find(name);
  if (known != known_.end()) return known->second;
  return known_.emplace(name, places_named(candidate_, program_, name)).first->second;
}

double miss_of(const Requirement& wish, Places& places) {
  static const std::vector<RectMm> nowhere_needed{RectMm{}};
  const Candidate& candidate = places.candidate();
  const std::vector<RectMm>& as = places.named(wish.subject);
  const std::vector<RectMm>& bs = places.named(wish.object);
  const bool every =
      wish.relation == RelationKind::far || wish.relation == RelationKind::not_adjacent;
  const bool between = wish.relation == RelationKind::between;
  const std::vector<RectMm>& cs = between ? places.named(wish.second_object) : nowhere_needed;
  if (as.empty() || bs.empty() || cs.empty()) return every ? 0 : 2;
  double worst = -HUGE_VAL, best = HUGE_VAL;
  for (const RectMm& a : as) {
    for (const RectMm& b : bs) {
      for (const RectMm& c : cs) {
        const double miss = between ? miss_between(a, b, c, diagonal_mm(candidate.floor))
                                    : miss_pair(wish.relation, a, b, candidate);
        worst = std::max(worst, miss);
        best = std::min(best, miss);
      }
    }
  }
  const double miss = every ? worst : best;
  return miss <= 0 ? 0 : 1 + miss / diagonal_mm(candidate.floor);
}

}  // namespace marketgen
