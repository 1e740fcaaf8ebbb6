#include "intake/draft_score.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "intake/relation_geometry.h"

namespace marketgen::intake {
namespace {

// Penalty points. Missed wishes outweigh everything but floors that cannot be built.
constexpr double unbuildable = 1000;
constexpr double must_missed = 60, prefer_missed = 25;
constexpr double crowding_per_m = 30;
constexpr double waste_per_m2 = 0.3;
constexpr double area_off = 3, max_area_off = 5;
constexpr double stressed_factor = 3;    // "lots of" cold drinks need their floor most
constexpr double strained = 0.3;         // of a wish missed: what holds, but few would say so
constexpr double aside_but_remote = 20;  // "left of the entrance" is said of what is close to it
constexpr double asked_area_off = 90;    // floor that was asked for in numbers
constexpr double asked_area_missed = 30;
constexpr double asked_area_tolerance = 0.06;
constexpr double short_core_per_m = 8;  // gondola runs shorter than a few sections
constexpr double aisle_missed = 12;     // each aisle more or less than asked for
constexpr double min_run_mm = 3800;
constexpr double tills_off_floor = 120,
                 zone_off_floor = 40;  // altogether, on a floor that was drawn
constexpr double door_off_per_m = 3;   // between the drafted entrance and the drawn one
// What people call the end and the middle of a wall, as shares of its length.
constexpr double end_of_wall = 0.32, middle_of_wall = 0.1;

// Adjacency in shop design, in points: our own weights of what planners of shops advise.
constexpr double produce_far_from_entrance = 7;  // over the diagonal
constexpr double bakery_far_from_entrance = 3;
constexpr double destination_near_entrance =
    4;                                       // dairy, meat and the like pull shoppers to the rear
constexpr double frozen_far_from_tills = 3;  // frozen goods are taken last
constexpr double cold_group = 5;             // refrigeration is grouped
constexpr double raw_beside_ready = 3;
constexpr double chemicals_beside_food = 5;
constexpr double beside_mm = 800;  // a divider between two cabinets is less, an aisle more
constexpr double same_group_mm = 3500;

bool is_type(const ProgramZone& zone, std::initializer_list<std::string_view> types) {
  return std::ranges::find(types, zone.type->type) != types.end();
}

// How far apart, in diagonals, things are that were said to be beside, behind or opposite one
// another.
double remoteness_of(const plan::Requirement& wish, const plan::NamedFloor& floor) {
  constexpr plan::RelationKind kinds[] = {plan::RelationKind::left_of,
                                          plan::RelationKind::right_of,
                                          plan::RelationKind::behind,
                                          plan::RelationKind::facing};
  if (std::ranges::find(kinds, wish.relation) == std::ranges::end(kinds)) return 0;
  const double diagonal = 1e3 * plan::diagonal_m(floor.bounds);
  double nearest = diagonal;
  for (const plan::NamedPlace& a : plan::places_named(floor, wish.subject)) {
    for (const plan::NamedPlace& b : plan::places_named(floor, wish.object)) {
      nearest = std::min(nearest, distance_mm(a.rect, b.rect));
    }
  }
  return nearest / diagonal;
}

double wish_penalty(const Candidate& candidate,
                    const plan::NamedFloor& floor,
                    const ScoreInput& input) {
  double sum = 0;
  for (const plan::Requirement& wish : input.understanding.requirements) {
    const double weight = wish.strength == plan::Strength::must ? must_missed : prefer_missed;
    if (wish.kind == plan::RequirementKind::relation) {
      const double strain = strain_of(wish, floor);
      sum += weight * miss_of(wish, floor) + aside_but_remote * remoteness_of(wish, floor) +
             weight * (strain > 0 ? strained + strain : 0);
    }
    if (wish.kind != plan::RequirementKind::opening || wish.second_object.empty()) continue;
    if (wish.subject != "entrance" && wish.subject != "exit") continue;
    const std::size_t place = wish.subject == "entrance" ? 0 : 1;
    if (place >= candidate.openings.size()) continue;  // a floor plan with one door
    const plan::Opening& door = candidate.openings[place];
    if (!wish.object.empty() && wish.object != name_of(door.wall)) continue;  // of another one
    const bool low_end = wish.second_object == "west" || wish.second_object == "south";
    const bool middle = wish.second_object == "center";
    const double wanted = middle ? 0.5 : (low_end ? 0.0 : 1.0);
    const double off = std::abs(door.center - wanted) - (middle ? middle_of_wall : end_of_wall);
    if (off > 0) sum += weight * (1 + off);
  }
  return sum;
}

// The share of a zone's rectangle that is no floor.
double off_floor(const RectMm& rect, const StoreProgram& program) {
  if (program.outside.empty() || rect.empty()) return 0;
  std::int64_t gone = 0;
  for (const RectMm& outside : program.outside)
    if (const auto both = intersection(rect, outside)) gone += both->area_mm2();
  return static_cast<double>(gone) / static_cast<double>(rect.area_mm2());
}

// Floor with its share of the aisles around it.
double area_with_aisles(const RectMm& rect, const RectMm& floor, int aisle_mm) {
  const RectMm grown = rect.grown(aisle_mm / 2);
  return intersection(grown, floor).value_or(rect).area_m2();
}

// The share by which a zone is larger or smaller than it was asked to be, beyond the tolerance.
double asked_area_miss(const ProgramZone& zone, double area_m2) {
  const double off = area_m2 / *zone.wanted_m2 - 1;
  if (zone.wanted_how == plan::Comparison::at_least) return std::max(0.0, -off);
  if (zone.wanted_how == plan::Comparison::at_most) return std::max(0.0, off);
  return std::max(0.0, std::abs(off) - asked_area_tolerance);
}

double room_penalty(const Candidate& candidate, const ScoreInput& input) {
  double sum = crowding_per_m * candidate.drafted.crowding +
               waste_per_m2 * candidate.drafted.waste_m2 + door_off_per_m * candidate.door_off_m;
  for (std::size_t i = 0; i < input.program.zones.size(); ++i) {
    const ProgramZone& zone = input.program.zones[i];
    const RectMm& rect = candidate.rects[i];
    if (rect.empty() || std::min(rect.width(), rect.depth()) < 1000) sum += unbuildable;
    const double lost = off_floor(rect, input.program);
    sum += (zone.stance == Stance::front ? tills_off_floor : zone_off_floor) * lost * lost;
    if (is_type(zone, {"checkout", "self_checkout", "customer_service"})) continue;
    if (zone.wanted_m2) {
      const double miss = asked_area_miss(zone, rect.area_m2());
      sum += asked_area_off * miss + (miss > 0 ? asked_area_missed : 0);
      if (zone.wanted_how != plan::Comparison::at_most) continue;
    }
    const double area =
        (1 - lost) * area_with_aisles(rect, candidate.floor, candidate.drafted.run_aisle_mm);
    const double target = std::max(1.0, zone.target_m2);
    const double ratio = std::max(area / target, target / std::max(0.1, area));
    const bool stressed = zone.stressed && area < target;
    sum += area_off * (stressed ? stressed_factor : 1) * std::min(max_area_off, ratio - 1);
  }
  return sum;
}

double core_penalty(const FloorDraft& draft, const Candidate& candidate, const ScoreInput& input) {
  const bool along_y = front_runs_east(candidate);
  double sum = 0;
  for (const int zone : draft.band(Band::core)) {
    const RectMm& rect = candidate.rects[static_cast<std::size_t>(zone)];
    const int run = along_y ? rect.depth() : rect.width();
    sum += short_core_per_m * 1e-3 * std::max(0.0, min_run_mm - run);
  }
  // Counted runs have no room along a wall.
  for (const Band band : {Band::front, Band::west, Band::east, Band::north}) {
    for (const int index : draft.band(band)) {
      const ProgramZone& zone = input.program.zones[static_cast<std::size_t>(index)];
      const bool counted = zone.main.runs || zone.main.count;
      if (zone.stance == Stance::central && counted) sum += must_missed;
    }
  }
  if (input.program.aisles)
    sum += std::abs(candidate.drafted.runs + 1 - *input.program.aisles) * aisle_missed;
  return sum;
}

// Distances to doors and tills, over the diagonal.
double flow_penalty(const Candidate& candidate,
                    const plan::NamedFloor& floor,
                    const ScoreInput& input) {
  const double diagonal = 1e3 * plan::diagonal_m(candidate.floor);
  const PointMm door = plan::point_inside(candidate.floor, candidate.openings[0], 0);
  const RectMm entrance{door[0], door[1], door[0], door[1]};
  const std::vector<plan::NamedPlace> tills = plan::places_named(floor, "checkout");
  double sum = 0;
  for (std::size_t i = 0; i < input.program.zones.size(); ++i) {
    const ProgramZone& zone = input.program.zones[i];
    const double from_door = distance_mm(candidate.rects[i], entrance) / diagonal;
    if (is_type(zone, {"produce", "promo"})) sum += produce_far_from_entrance * from_door;
    if (is_type(zone, {"bakery"})) sum += bakery_far_from_entrance * from_door;
    if (is_type(zone, {"dairy", "meat_fish"})) sum += destination_near_entrance * (1 - from_door);
    if (is_type(zone, {"frozen"}) && !tills.empty()) {
      sum += frozen_far_from_tills * distance_mm(candidate.rects[i], tills[0].rect) / diagonal;
    }
  }
  return sum;
}

// Refrigerated zones that lie near one another are one group: they share piping.
int cold_groups(const Candidate& candidate, const std::vector<ProgramZone>& zones) {
  std::vector<std::size_t> group(zones.size());
  int groups = 0;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    group[i] = i;
    if (!zones[i].cold) continue;
    ++groups;
    for (std::size_t k = 0; k < i; ++k) {
      const bool near = zones[k].cold && group[k] != group[i] &&
                        distance_mm(candidate.rects[i], candidate.rects[k]) < same_group_mm;
      if (!near) continue;
      --groups;
      const std::size_t from = group[k], to = group[i];
      std::replace(group.begin(), group.end(), from, to);
    }
  }
  return groups;
}

double neighbour_penalty(const Candidate& candidate, const ScoreInput& input) {
  const std::vector<ProgramZone>& zones = input.program.zones;
  double sum = 0;
  for (std::size_t a = 0; a < zones.size(); ++a) {
    for (std::size_t b = 0; b < zones.size(); ++b) {
      if (a == b) continue;
      const double gap = distance_mm(candidate.rects[a], candidate.rects[b]);
      if (gap >= beside_mm) continue;
      const bool ready = is_type(zones[b], {"bakery", "deli", "cafe"});
      const bool food = zones[b].type->food && !zones[b].type->categories.empty() &&
                        zones[b].type->type != "checkout";
      if (is_type(zones[a], {"meat_fish"}) && ready) sum += raw_beside_ready;
      if (is_type(zones[a], {"household"}) && food) sum += chemicals_beside_food;
    }
  }
  return sum + cold_group * std::max(0, cold_groups(candidate, zones) - 1);
}

double habit_penalty(const FloorDraft& draft, const ScoreInput& input) {
  double sum = 0;
  for (std::size_t b = 0; b < band_count; ++b) {
    for (const int index : draft.bands[b]) {
      const auto i = static_cast<std::size_t>(index);
      sum += band_habit(input.program.zones[i], static_cast<Band>(b)) + input.taste[i][b];
    }
  }
  return sum;
}

}  // namespace

double band_habit(const ProgramZone& zone, Band band) {
  //                              front west east north core
  constexpr std::array<std::array<double, band_count>, 4> habits = {{
      {12, 3, 3, 4, 0},  // central
      {5, 0, 0, 0, 6},   // wall
      {0, 2, 2, 4, 3},   // hall
      {0, 9, 9, 9, 12},  // front
  }};
  double points = habits[static_cast<std::size_t>(zone.stance)][index_of(band)];
  const std::string& anchor = zone.type->anchor;
  if (anchor == "entrance" && band == Band::front) points -= 3;
  if (anchor == "entrance" && band == Band::north) points += 3;
  if (anchor == "north" && band != Band::north) points += 2;
  if (zone.cold && band == Band::front) points += 5;
  if (zone.kind == nullptr && band != Band::north) points += 5;  // storage lies at the back
  return points;
}

double penalty_of(const FloorDraft& draft,
                  const Candidate& candidate,
                  const ScoreInput& input,
                  double accepted) {
  // Only the habits can be less than nothing. The quick ones come first, the wishes last.
  constexpr double rounding = 1e-6;
  const double habits = habit_penalty(draft, input);
  const double core = core_penalty(draft, candidate, input);
  const double room = room_penalty(candidate, input);
  if (habits + core + room > accepted + rounding) return HUGE_VAL;
  const plan::NamedFloor floor = named_floor(candidate, input.program);
  const double flow = flow_penalty(candidate, floor, input);
  const double neighbours = neighbour_penalty(candidate, input);
  if (habits + core + room + flow + neighbours > accepted + rounding) return HUGE_VAL;
  const double sum =
      wish_penalty(candidate, floor, input) + room + core + flow + neighbours + habits;
  return sum > accepted ? HUGE_VAL : sum;
}

}  // namespace marketgen::intake
