#include "intake/candidate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "plan/egress.h"

namespace marketgen::intake {
namespace {

constexpr int entrance_door_mm = 1600;
constexpr int service_door_mm = 1500;
constexpr int window_mm = 2500;
constexpr int corner_margin_mm = 400;         // no door right in a corner
constexpr double service_door_from_m2 = 150;  // smaller shops take deliveries through the front
constexpr double fraction_digits = 1e4;

int quarter_turns_to(plan::Wall wall) {
  switch (wall) {
    case plan::Wall::east:
      return 1;
    case plan::Wall::north:
      return 2;
    case plan::Wall::west:
      return 3;
    case plan::Wall::south:
      break;
  }
  return 0;
}

// A quarter turn counter-clockwise: what was south becomes east.
Slice turned(Slice slice) {
  if (slice.zone >= 0) return slice;
  for (Slice& part : slice.parts)
    part = turned(std::move(part));
  if (slice.axis == plan::Axis::y) {  // north becomes west
    std::ranges::reverse(slice.parts);
    std::ranges::reverse(slice.sizes_mm);
    std::ranges::reverse(slice.gaps_mm);
  }
  slice.axis = slice.axis == plan::Axis::x ? plan::Axis::y : plan::Axis::x;
  return slice;
}

bool runs_east(plan::Wall wall) {
  return wall == plan::Wall::north || wall == plan::Wall::south;
}

int wall_length(plan::Wall wall, const RectMm& floor) {
  return runs_east(wall) ? floor.width() : floor.depth();
}

double rounded(double fraction) {
  return std::floor(fraction * fraction_digits + 0.5) / fraction_digits;
}

plan::Opening make_opening(
    std::string id, plan::OpeningKind kind, plan::Wall wall, double center, int width_mm) {
  plan::Opening opening;
  opening.id = std::move(id);
  opening.kind = kind;
  opening.wall = wall;
  opening.center = rounded(center);
  opening.width_mm = width_mm;
  return opening;
}

// Where the middle of a door may be along a wall: every 100 mm from `first_mm` to `last_mm`.
struct DoorSteps {
  int first_mm, last_mm;

  // The step within [from, to] that is nearest to `wanted`, the lower one of two.
  std::optional<int> nearest(int wanted, int from, int to) const {
    constexpr int step_mm = 100;
    const int low = std::max(0, (from - first_mm + step_mm - 1) / step_mm);
    const int end = std::min(to, last_mm) - first_mm;
    if (end < 0 || low > end / step_mm) return std::nullopt;
    const int below = std::clamp((wanted - first_mm) / step_mm, low, end / step_mm);
    const int above = std::min(below + 1, end / step_mm);
    const auto at = [&](int step) { return first_mm + step * step_mm; };
    const bool up = std::abs(at(above) - wanted) < std::abs(at(below) - wanted);
    return at(up ? above : below);
  }
};

class DoorPlacer {
 public:
  DoorPlacer(Candidate& candidate, const StoreProgram& program, const Understanding& found)
      : candidate_(candidate), program_(program), found_(found) {}

  void run(plan::Wall front) {
    front_ = front;
    const DraftedFloor& drafted = candidate_.drafted;
    // Turning keeps the order along the wall for south and east, and reverses it for north and
    // west.
    const bool reversed = front == plan::Wall::north || front == plan::Wall::west;
    const auto fraction = [&](int at_mm) {
      const double f = static_cast<double>(at_mm) / drafted.width_mm;
      return reversed ? 1 - f : f;
    };
    place_all(fraction(drafted.entrance_mm),
              drafted.entrance_width_mm,
              fraction(drafted.exit_mm),
              drafted.exit_width_mm);
  }

  // The same with usual doors at these fractions along the wall.
  void run(plan::Wall front, double entrance, double exit) {
    front_ = front;
    place_all(entrance, entrance_door_mm, exit, entrance_door_mm);
  }

 private:
  void place_all(double entrance, int entrance_mm, double exit, int exit_mm) {
    if (take_drawn(entrance)) return;
    place_door("entrance", plan::OpeningKind::entrance, entrance, entrance_mm);
    place_door("exit", plan::OpeningKind::exit, exit, exit_mm);
    place_further(plan::OpeningKind::entrance, entrance_mm);
    place_further(plan::OpeningKind::exit, exit_mm);
    place_service();
    place_wished(plan::OpeningKind::emergency, plan::emergency_door_mm);
    place_wished(plan::OpeningKind::window, window_mm);
  }

  // The doors and windows of a floor plan, and those that the words ask for besides. False when it
  // shows no way in: then all is placed as in a shop that nobody drew.
  bool take_drawn(double drafted_entrance) {
    if (!program_.shell || program_.shell->openings.empty()) return false;
    candidate_.openings = program_.shell->openings;
    if (candidate_.openings.front().kind != plan::OpeningKind::entrance) {
      place_door("entrance", plan::OpeningKind::entrance, drafted_entrance, entrance_door_mm);
      std::ranges::rotate(candidate_.openings, candidate_.openings.end() - 1);
    }
    const plan::Opening& entrance = candidate_.openings.front();
    candidate_.door_off_m =
        1e-3 * std::abs(entrance.center - drafted_entrance) * wall_length(front_, candidate_.floor);
    for (const plan::OpeningKind kind : {plan::OpeningKind::exit,
                                         plan::OpeningKind::service,
                                         plan::OpeningKind::emergency,
                                         plan::OpeningKind::window}) {
      const auto drawn = [&](const plan::Opening& one) { return one.kind == kind; };
      if (std::ranges::none_of(candidate_.openings, drawn)) place_wished(kind, width_of(kind));
    }
    return true;
  }

  static int width_of(plan::OpeningKind kind) {
    if (kind == plan::OpeningKind::service) return service_door_mm;
    if (kind == plan::OpeningKind::window) return window_mm;
    return kind == plan::OpeningKind::emergency ? plan::emergency_door_mm : entrance_door_mm;
  }

  // Where one opening was asked for, as far as it was said.
  struct Spot {
    std::optional<plan::Wall> wall;
    std::optional<double> center;  // along its wall
  };

  // Where along a wall a wish puts an opening.
  static std::optional<double> wished_center(const std::string& side) {
    constexpr double near_end = 0.15;
    if (side.empty()) return std::nullopt;
    if (side == "west" || side == "south") return near_end;
    if (side == "east" || side == "north") return 1 - near_end;
    return 0.5;
  }

  // One for each opening that was asked for, those with a place first.
  std::vector<Spot> spots_of(plan::OpeningKind kind) const {
    std::vector<Spot> spots;
    std::size_t wanted = 0;
    for (const plan::Requirement& wish : found_.requirements) {
      const bool none = wish.comparison == plan::Comparison::at_most;
      if (wish.kind != plan::RequirementKind::opening || wish.subject != name_of(kind) || none)
        continue;
      const auto count = static_cast<std::size_t>(std::max(1.0, wish.value));
      wanted = std::max(wanted, count);
      if (wish.object.empty() && wish.second_object.empty()) continue;
      const Spot spot{value_named<plan::Wall>(wish.object), wished_center(wish.second_object)};
      const auto same = std::ranges::count_if(spots, [&](const Spot& other) {
        return other.wall == spot.wall && other.center == spot.center;
      });
      for (auto made = static_cast<std::size_t>(same); made < count; ++made)
        spots.push_back(spot);
    }
    spots.resize(std::max(spots.size(), wanted));
    return spots;
  }

  // Entrance and exit stand where the draft has them, unless the exit is to be in another wall.
  void place_door(const std::string& id, plan::OpeningKind kind, double center, int width_mm) {
    const std::vector<Spot> spots = spots_of(kind);
    const Spot spot = spots.empty() ? Spot{} : spots.front();
    const plan::Wall wall = kind == plan::OpeningKind::exit ? spot.wall.value_or(front_) : front_;
    if (wall == front_ && program_.outside.empty()) {
      candidate_.openings.push_back(make_opening(id, kind, wall, center, width_mm));
      return;
    }
    const std::size_t before = candidate_.openings.size();
    const double wanted = spot.center.value_or(wall == front_ ? center : beside_tills(wall));
    place_free(id, kind, wall, wanted, width_mm);
    if (candidate_.openings.size() == before)  // every shop has its doors
      candidate_.openings.push_back(make_opening(id, kind, wall, wanted, width_mm));
  }

  // The fraction along another wall at which the tills are nearest.
  double beside_tills(plan::Wall wall) const {
    for (std::size_t i = 0; i < program_.zones.size(); ++i) {
      if (program_.zones[i].stance != Stance::front) continue;
      const PointMm center = candidate_.rects[i].center();
      const int along = runs_east(wall) ? center[0] : center[1];
      return static_cast<double>(along) / wall_length(wall, candidate_.floor);
    }
    return 0.5;
  }

  // A second entrance or exit, and more.
  void place_further(plan::OpeningKind kind, int width_mm) {
    const std::vector<Spot> spots = spots_of(kind);
    const double usual = kind == plan::OpeningKind::entrance ? 0.08 : 0.92;
    for (std::size_t i = 1; i < spots.size(); ++i)
      place_free(std::string(name_of(kind)) + "-" + std::to_string(i + 1),
                 kind,
                 spots[i].wall.value_or(front_),
                 spots[i].center.value_or(usual),
                 width_mm);
  }

  void place_service() {
    std::vector<Spot> spots = spots_of(plan::OpeningKind::service);
    if (spots.empty() && program_.area_m2() < service_door_from_m2) return;
    if (spots.empty()) spots.emplace_back();
    const plan::Wall back = opposite(front_);
    const double fallback = behind_longest(back);
    for (std::size_t i = 0; i < spots.size(); ++i)
      place_free(i == 0 ? "dock" : "dock-" + std::to_string(i + 1),
                 plan::OpeningKind::service,
                 spots[i].wall.value_or(back),
                 spots[i].center.value_or(fallback),
                 service_door_mm);
  }

  // The fraction along a wall where a door costs least: at an end of the longest zone there, the
  // one nearer to a corner.
  double behind_longest(plan::Wall wall) const {
    constexpr int reach_mm = 300;
    const double length = wall_length(wall, candidate_.floor);
    int best_from = 0, best_to = 0;
    for (const RectMm& rect : candidate_.rects) {
      const RectMm& floor = candidate_.floor;
      const int away = wall == plan::Wall::north   ? floor.y1 - rect.y1
                       : wall == plan::Wall::south ? rect.y0
                       : wall == plan::Wall::east  ? floor.x1 - rect.x1
                                                   : rect.x0;
      const int from = runs_east(wall) ? rect.x0 : rect.y0;
      const int to = runs_east(wall) ? rect.x1 : rect.y1;
      if (away > reach_mm || to - from <= best_to - best_from) continue;
      best_from = from;
      best_to = to;
    }
    const int half = service_door_mm / 2 + corner_margin_mm;
    const bool low_corner_nearer = best_from < length - best_to;
    return (low_corner_nearer ? best_from + half : best_to - half) / length;
  }

  // Those without an end of their wall share the wall out among them.
  void place_wished(plan::OpeningKind kind, int width_mm) {
    const std::vector<Spot> spots = spots_of(kind);
    const plan::Wall usual = kind == plan::OpeningKind::window ? front_ : opposite(front_);
    const auto wall_of = [&](const Spot& spot) { return spot.wall.value_or(usual); };
    for (std::size_t i = 0; i < spots.size(); ++i) {
      const auto same_wall = [&](const Spot& other) { return wall_of(other) == wall_of(spots[i]); };
      const auto before =
          std::count_if(spots.begin(), spots.begin() + static_cast<std::ptrdiff_t>(i), same_wall);
      const auto count = std::ranges::count_if(spots, same_wall);
      const double spread = (static_cast<double>(before) + 1) / (static_cast<double>(count) + 1);
      std::string id(name_of(kind));
      if (i > 0) id += "-" + std::to_string(i + 1);
      place_free(id, kind, wall_of(spots[i]), spots[i].center.value_or(spread), width_mm);
    }
  }

  static plan::Wall opposite(plan::Wall wall) {
    switch (wall) {
      case plan::Wall::north:
        return plan::Wall::south;
      case plan::Wall::south:
        return plan::Wall::north;
      case plan::Wall::east:
        return plan::Wall::west;
      case plan::Wall::west:
        break;
    }
    return plan::Wall::east;
  }

  // Where along the wall the middle of a door this wide must not be: nearer than the margin to
  // another opening. Sorted, open at both ends.
  std::vector<std::array<int, 2>> taken(plan::Wall wall, int half_mm) const {
    std::vector<std::array<int, 2>> stretches;
    for (const plan::Opening& other : candidate_.openings) {
      if (other.wall != wall) continue;
      const auto middle =
          static_cast<int>(std::lround(other.center * wall_length(wall, candidate_.floor)));
      const int away = other.width_mm / 2 + corner_margin_mm + half_mm;
      stretches.push_back({middle - away, middle + away});
    }
    for (const RectMm& gone : program_.outside) {  // where there is no wall to be in
      const RectMm& floor = candidate_.floor;
      const bool at_wall = wall == plan::Wall::north   ? gone.y1 == floor.y1
                           : wall == plan::Wall::south ? gone.y0 == floor.y0
                           : wall == plan::Wall::east  ? gone.x1 == floor.x1
                                                       : gone.x0 == floor.x0;
      if (!at_wall) continue;
      const int away = corner_margin_mm + half_mm;
      const auto [from, to] =
          runs_east(wall) ? std::pair{gone.x0, gone.x1} : std::pair{gone.y0, gone.y1};
      stretches.push_back({from - away, to + away});
    }
    std::ranges::sort(stretches);
    return stretches;
  }

  // The free place along the wall that is nearest to `center`, the lower one of two; no opening
  // when there is none.
  void place_free(
      const std::string& id, plan::OpeningKind kind, plan::Wall wall, double center, int width_mm) {
    const int length = wall_length(wall, candidate_.floor);
    const int wanted = static_cast<int>(std::lround(center * length));
    const int half = width_mm / 2;
    const DoorSteps steps{corner_margin_mm + half, length - corner_margin_mm - half};
    std::optional<int> best;
    const auto consider = [&](int at) {
      if (!best || std::abs(at - wanted) < std::abs(*best - wanted)) best = at;
    };
    // The steps of each stretch between two taken ones, of which the nearest is all that counts.
    int from = steps.first_mm;
    const auto consider_until = [&](int to) {
      if (const auto at = steps.nearest(wanted, from, to)) consider(*at);
    };
    for (const auto& [begin, end] : taken(wall, half)) {
      consider_until(begin);
      from = std::max(from, end);
    }
    consider_until(steps.last_mm);
    if (!best) return;
    candidate_.openings.push_back(
        make_opening(id, kind, wall, static_cast<double>(*best) / length, width_mm));
  }

  Candidate& candidate_;
  const StoreProgram& program_;
  const Understanding& found_;
  plan::Wall front_ = plan::Wall::south;
};

}  // namespace

bool front_runs_east(const Candidate& candidate) {
  const plan::Wall front = candidate.openings.front().wall;
  return front == plan::Wall::south || front == plan::Wall::north;
}

plan::Wall entrance_wall_of(const Understanding& found) {
  if (found.drawn_front) return *found.drawn_front;
  for (const plan::Requirement& wish : found.requirements) {
    if (wish.kind != plan::RequirementKind::opening || wish.subject != "entrance") continue;
    if (const auto wall = value_named<plan::Wall>(wish.object)) return *wall;
  }
  return plan::Wall::south;
}

Candidate make_candidate(Slice root, const StoreProgram& program, const Understanding& found) {
  constexpr double at_one_end = 0.2;
  const plan::Wall front = entrance_wall_of(found);
  Candidate candidate;
  candidate.floor = {0, 0, program.width_mm, program.depth_mm};
  candidate.root = std::move(root);
  candidate.rects = zone_rects(candidate.root, candidate.floor, program.zones.size());
  candidate.drafted.run_aisle_mm = program.aisle_mm.value_or(program.profile->secondary_aisle_mm);
  double exit = 1 - at_one_end;
  for (std::size_t i = 0; i < program.zones.size(); ++i) {
    if (program.zones[i].stance != Stance::front || candidate.rects[i].empty()) continue;
    const PointMm center = candidate.rects[i].center();
    exit =
        static_cast<double>(center[runs_east(front) ? 0 : 1]) / wall_length(front, candidate.floor);
    break;
  }
  DoorPlacer(candidate, program, found).run(front, exit > 0.5 ? at_one_end : 1 - at_one_end, exit);
  return candidate;
}

Candidate make_candidate(const FloorDraft& draft,
                         const StoreProgram& program,
                         const Understanding& found,
                         const catalog::Catalog& catalog) {
  const plan::Wall front = entrance_wall_of(found);
  const int turns = quarter_turns_to(front);
  const bool swapped = turns % 2 != 0;
  Candidate candidate;
  candidate.floor = {0, 0, program.width_mm, program.depth_mm};
  candidate.drafted = build_floor(draft,
                                  program,
                                  catalog,
                                  swapped ? program.depth_mm : program.width_mm,
                                  swapped ? program.width_mm : program.depth_mm);
  candidate.root = candidate.drafted.root;
  for (int i = 0; i < turns; ++i)
    candidate.root = turned(std::move(candidate.root));
  candidate.rects = zone_rects(candidate.root, candidate.floor, program.zones.size());
  DoorPlacer(candidate, program, found).run(front);
  return candidate;
}

}  // namespace marketgen::intake
