#include "intake/relation_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace marketgen::intake {
namespace {

constexpr double margin_share = 0.1, min_margin_m = 0.1;
constexpr double not_judged = 2;  // as bad as missed by the whole diagonal

// A few steps, and no more in a large shop than can be seen at once.
constexpr double steps_share = 0.12, fewest_steps_m = 2, max_steps_m = 6;
constexpr double aside_share = 0.5;  // of what it lies the other way
constexpr double plain_offset_m = 1;
constexpr double plain_gap_m = 2;       // between what is not adjacent
constexpr double off_line_share = 0.6;  // of the way to the nearer end
constexpr double middle_third[] = {0.36, 0.64};
constexpr double in_sight_m = 3.5;  // of fronts across an aisle: fixtures stand back in their zones
constexpr double in_sight_of_door_m = 10;
constexpr double opposite_m = 2.5;  // that two fronts share: two modules

struct Metres {
  double x = 0, y = 0;
};

Metres middle_of(const RectMm& rect) {
  const PointMm at = rect.center();
  return {1e-3 * at[0], 1e-3 * at[1]};
}

// What all places of a name have as their middle, each by its floor.
Metres common_middle(const std::vector<plan::NamedPlace>& places) {
  Metres sum;
  double weight = 0;
  for (const plan::NamedPlace& place : places) {
    const double m2 = std::max(0.01, place.rect.area_m2());
    const Metres at = middle_of(place.rect);
    sum.x += m2 * at.x;
    sum.y += m2 * at.y;
    weight += m2;
  }
  return {sum.x / weight, sum.y / weight};
}

double nearest_m(const std::vector<plan::NamedPlace>& as, const std::vector<plan::NamedPlace>& bs) {
  double nearest = HUGE_VAL;
  for (const plan::NamedPlace& a : as)
    for (const plan::NamedPlace& b : bs)
      if (!(a == b)) nearest = std::min(nearest, 1e-3 * distance_mm(a.rect, b.rect));
  return nearest;
}

// Lies `a` beyond `b` that way, and more so than across?
double aside_strain(Metres a, Metres b, Metres way, bool of_opening) {
  const double along = (a.x - b.x) * way.x + (a.y - b.y) * way.y;
  const double across = std::abs((a.x - b.x) * way.y - (a.y - b.y) * way.x);
  const double wanted = std::max(plain_offset_m, of_opening ? 0 : aside_share * across);
  return std::max(0.0, wanted - along);
}

double between_strain(Metres a, Metres b, Metres c) {
  const Metres way{c.x - b.x, c.y - b.y}, from{a.x - b.x, a.y - b.y};
  const double length = std::max(1e-6, std::hypot(way.x, way.y));
  const double along = (from.x * way.x + from.y * way.y) / length;
  const double off = std::abs(from.x * way.y - from.y * way.x) / length;
  const double end = std::min(along, length - along);
  return std::max(0.0, off - std::max(1.0, off_line_share * end)) +
         std::max(0.0, 0.15 * length - end);
}

double center_strain(Metres a, const RectMm& floor) {
  const double u = (a.x - 1e-3 * floor.x0) / (1e-3 * floor.width());
  const double v = (a.y - 1e-3 * floor.y0) / (1e-3 * floor.depth());
  const auto off = [](double share) {
    return std::max({0.0, middle_third[0] - share, share - middle_third[1]});
  };
  return off(u) * 1e-3 * floor.width() + off(v) * 1e-3 * floor.depth();
}

// "On the left" is said of what lies in that third of the floor.
double side_strain(Metres a, const RectMm& floor, plan::Wall wall) {
  constexpr double third = 0.3;
  const bool x = wall == plan::Wall::west || wall == plan::Wall::east;
  const bool low = wall == plan::Wall::west || wall == plan::Wall::south;
  const double length = 1e-3 * (x ? floor.width() : floor.depth());
  const double from_low = x ? a.x - 1e-3 * floor.x0 : a.y - 1e-3 * floor.y0;
  return std::max(0.0, (low ? from_low : length - from_low) - third * length);
}

// "Along the back wall" is said of what has its longer side there: in a corner, fixtures stand
// along that.
double along_strain(const std::vector<plan::NamedPlace>& as, const RectMm& floor, plan::Wall wall) {
  const bool runs_east = wall == plan::Wall::north || wall == plan::Wall::south;
  double strain = HUGE_VAL;
  for (const plan::NamedPlace& a : as) {
    const bool at_side = runs_east ? a.rect.x0 <= floor.x0 || a.rect.x1 >= floor.x1
                                   : a.rect.y0 <= floor.y0 || a.rect.y1 >= floor.y1;
    const int away = (a.rect.depth() - a.rect.width()) * (runs_east ? 1 : -1);
    strain = std::min(strain, at_side ? std::max(0, away) * 1e-3 : 0);
  }
  return strain == HUGE_VAL ? 0 : strain;
}

// The way into the shop, or to someone's left or right who comes in.
Metres way_of(plan::RelationKind kind, const plan::NamedFloor& floor) {
  const PointMm in =
      plan::inward_from(floor.openings.empty() ? plan::Wall::south : floor.openings.front().wall);
  const Metres inward{static_cast<double>(in[0]), static_cast<double>(in[1])};
  if (kind == plan::RelationKind::left_of) return {-inward.y, inward.x};
  if (kind == plan::RelationKind::right_of) return {inward.y, -inward.x};
  return inward;
}

double shared_m(const RectMm& a, const RectMm& b, plan::Axis axis) {
  const bool x = axis == plan::Axis::x;
  return 1e-3 * (x ? std::min(a.x1, b.x1) - std::max(a.x0, b.x0)
                   : std::min(a.y1, b.y1) - std::max(a.y0, b.y0));
}

// Fixtures on walls look away from them, in a corner from the longer one; those of a zone without
// walls can be turned. May those of `rect` look the way along `axis`, towards larger coordinates or
// smaller ones?
bool can_look(const RectMm& rect, const RectMm& floor, plan::Axis axis, bool up) {
  bool west = rect.x0 <= floor.x0, east = rect.x1 >= floor.x1;
  bool south = rect.y0 <= floor.y0, north = rect.y1 >= floor.y1;
  if (!west && !east && !south && !north) return true;
  const bool in_corner = (west || east) && (south || north);
  const bool runs_east = rect.width() >= rect.depth();
  if (in_corner && runs_east) west = east = false;
  if (in_corner && !runs_east) south = north = false;
  if (axis == plan::Axis::x) return up ? west : east;
  return up ? south : north;
}

// How far two places are from looking at one another along an axis. 0: they do.
double off_sight_m(const plan::NamedPlace& a,
                   const plan::NamedPlace& b,
                   const RectMm& floor,
                   plan::Axis axis) {
  constexpr double back_to_back_m = 3;  // our own: as bad as so far apart
  const plan::Axis other = axis == plan::Axis::x ? plan::Axis::y : plan::Axis::x;
  const bool door = b.kind == plan::PlaceKind::opening;
  const double beside = shared_m(a.rect, b.rect, other), across = shared_m(a.rect, b.rect, axis);
  const std::size_t k = axis == plan::Axis::x ? 0 : 1;
  const bool up = a.rect.center()[k] < b.rect.center()[k];
  const bool looks =
      can_look(a.rect, floor, axis, up) && (door || can_look(b.rect, floor, axis, !up));
  return std::max(0.0, (door ? 0.5 : opposite_m) - beside) +
         std::max(0.0, -across - (door ? in_sight_of_door_m : in_sight_m)) + std::max(0.0, across) +
         (looks ? 0 : back_to_back_m);
}

struct Sight {
  double off_m = HUGE_VAL;
  plan::Axis axis = plan::Axis::x;
};

// The way along which places are nearest to looking at one another. A door is looked at from ahead.
Sight best_sight(const std::vector<plan::NamedPlace>& as,
                 const std::vector<plan::NamedPlace>& bs,
                 const plan::NamedFloor& floor) {
  Sight best;
  for (const plan::NamedPlace& a : as) {
    for (const plan::NamedPlace& b : bs) {
      if (a == b) continue;
      const bool door = b.kind == plan::PlaceKind::opening;
      const plan::Axis ahead = b.rect.width() > b.rect.depth() ? plan::Axis::y : plan::Axis::x;
      for (const plan::Axis axis : {plan::Axis::x, plan::Axis::y}) {
        if (door && axis != ahead) continue;
        const double off = off_sight_m(a, b, floor.bounds, axis);
        if (off < best.off_m) best = {off, axis};
      }
    }
  }
  return best;
}

double facing_strain(const std::vector<plan::NamedPlace>& as,
                     const std::vector<plan::NamedPlace>& bs,
                     const plan::NamedFloor& floor) {
  const Sight best = best_sight(as, bs, floor);
  return best.off_m == HUGE_VAL ? 0 : best.off_m;
}

double strain_m(const plan::Requirement& wish,
                const plan::NamedFloor& floor,
                const std::vector<plan::NamedPlace>& as,
                const std::vector<plan::NamedPlace>& bs) {
  const double steps =
      std::clamp(steps_share * plan::diagonal_m(floor.bounds), fewest_steps_m, max_steps_m);
  const Metres a = common_middle(as), b = common_middle(bs);
  switch (wish.relation) {
    case plan::RelationKind::near:
      return std::max(0.0, nearest_m(as, bs) - steps);
    case plan::RelationKind::facing:
      return facing_strain(as, bs, floor);
    case plan::RelationKind::not_adjacent:
      return std::max(0.0, plain_gap_m - nearest_m(as, bs));
    case plan::RelationKind::left_of:
    case plan::RelationKind::right_of:
    case plan::RelationKind::behind:
      return aside_strain(
          a, b, way_of(wish.relation, floor), bs.front().kind == plan::PlaceKind::opening);
    case plan::RelationKind::at:
      if (wish.object == "center") return center_strain(a, floor.bounds);
      if (const auto wall = value_named<plan::Wall>(wish.object))
        return side_strain(a, floor.bounds, *wall);
      return 0;
    case plan::RelationKind::along:
      if (const auto wall = value_named<plan::Wall>(wish.object))
        return along_strain(as, floor.bounds, *wall);
      return 0;
    case plan::RelationKind::between: {
      const std::vector<plan::NamedPlace> cs = plan::places_named(floor, wish.second_object);
      return cs.empty() ? 0 : between_strain(a, b, common_middle(cs));
    }
    case plan::RelationKind::far:
      break;
  }
  return 0;
}

}  // namespace

plan::NamedFloor named_floor(const Candidate& candidate, const StoreProgram& program) {
  plan::NamedFloor floor{candidate.floor, candidate.openings, {}};
  floor.zones.reserve(program.zones.size());
  for (std::size_t i = 0; i < program.zones.size(); ++i)
    floor.zones.push_back({program.zones[i].id, program.zones[i].type->type, candidate.rects[i]});
  return floor;
}

double planner_margin_m(const plan::RelationMeasure& measure) {
  return std::max(min_margin_m, margin_share * measure.limit_m);
}

double miss_of(const plan::Requirement& wish, const plan::NamedFloor& floor) {
  const std::optional<plan::RelationMeasure> measure =
      plan::measure_relation(floor, plan::terms_of(wish));
  if (!measure) return not_judged;
  const double miss_m = planner_margin_m(*measure) - measure->slack_m();
  return miss_m <= 0 ? 0 : 1 + miss_m / plan::diagonal_m(floor.bounds);
}

std::optional<plan::Axis> sight_of(const plan::Requirement& wish, const plan::NamedFloor& floor) {
  if (wish.relation != plan::RelationKind::facing) return std::nullopt;
  const Sight best = best_sight(
      plan::places_named(floor, wish.subject), plan::places_named(floor, wish.object), floor);
  return best.off_m <= 0 ? std::optional(best.axis) : std::nullopt;
}

double strain_of(const plan::Requirement& wish, const plan::NamedFloor& floor) {
  const std::vector<plan::NamedPlace> as = plan::places_named(floor, wish.subject);
  const std::vector<plan::NamedPlace> bs = plan::places_named(floor, wish.object);
  if (as.empty() || bs.empty()) return 0;
  return std::min(1.0, strain_m(wish, floor, as, bs) / plan::diagonal_m(floor.bounds));
}

}  // namespace marketgen::intake
