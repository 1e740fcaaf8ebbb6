#include "motion/way_round.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace marketgen::motion {
namespace {

constexpr int cell_mm = 250, cells = 49;  // 6 m to each side
constexpr double far_mm = 3000;
constexpr int max_off_mm = 60;  // the ways of a base that was stopped
constexpr double let_past_s = 4, look_again_s = 2;
constexpr double beside_base_m = 0.65;  // people keep about so much of it

double apart_mm(PointMm a, PointMm b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

// The floor about the base in cells, and what may be reached in it.
class NearFloor {
 public:
  using Cells = std::vector<bool>;

  NearFloor(const navigation::FreeSpace& space, PointMm middle) : middle_(middle) {
    for (int i = 0; i < cells * cells; ++i)
      free_.push_back(space.on_floor(point(i)) && space.free(point(i)));
  }

  PointMm point(int cell) const {
    return {middle_[0] + (cell % cells - cells / 2) * cell_mm,
            middle_[1] + (cell / cells - cells / 2) * cell_mm};
  }
  bool is_free(int cell) const { return free_[static_cast<std::size_t>(cell)]; }

  // From the free cell nearest to `from`, never within `room_mm` of what stands at `past`; somebody
  // who is nearer to it comes no nearer.
  Cells reached(PointMm from, PointMm past, double room_mm) const {
    Cells seen(free_.size(), false);
    std::vector<int> open;
    const double room = std::min(room_mm, apart_mm(from, past) - cell_mm);
    const auto visit = [&](int cell) {
      const auto i = static_cast<std::size_t>(cell);
      if (!free_[i] || seen[i] || apart_mm(point(cell), past) < room) return;
      seen[i] = true;
      open.push_back(cell);
    };
    if (const int first = nearest(from); first >= 0) visit(first);
    while (!open.empty()) {
      const int cell = open.back(), column = cell % cells;
      open.pop_back();
      if (column > 0) visit(cell - 1);
      if (column + 1 < cells) visit(cell + 1);
      if (cell >= cells) visit(cell - cells);
      if (cell + cells < cells * cells) visit(cell + cells);
    }
    return seen;
  }

 private:
  int nearest(PointMm to) const {
    int best = -1;
    for (int cell = 0; cell < cells * cells; ++cell)
      if (is_free(cell) && (best < 0 || apart_mm(point(cell), to) < apart_mm(point(best), to)))
        best = cell;
    return best;
  }

  PointMm middle_;
  Cells free_;
};

const MovingDisc& nearest_to(PointMm base, std::span<const MovingDisc> people) {
  return *std::ranges::min_element(people, {}, [&](const MovingDisc& person) {
    return apart_mm(floor_mm(person.position), base);
  });
}

// Past those people if they stand: where the base is too near to somebody already, its ways lead
// nearer past them than it drives.
bool gets_there(BaseFollower way, std::span<const MovingDisc> people) {
  constexpr double step_s = 0.05, max_way_s = 300;
  std::vector<MovingDisc> standing(people.begin(), people.end());
  for (MovingDisc& person : standing)
    person.speed = 0;
  for (double t = 0; t < max_way_s && !way.done(); t += step_s) {
    way.step(step_s, standing);
    if (way.waits()) return false;
  }
  return way.done();
}

bool opens_more(const NearFloor::Cells& with, const NearFloor::Cells& without) {
  for (std::size_t i = 0; i < with.size(); ++i)
    if (with[i] && !without[i]) return true;
  return false;
}

}  // namespace

std::optional<PointMm> passing_place(const navigation::FreeSpace& space,
                                     PointMm base,
                                     std::span<const MovingDisc> people,
                                     int room_mm) {
  if (people.empty()) return {};
  const PointMm person = floor_mm(nearest_to(base, people).position);
  const NearFloor floor(space, base);
  const NearFloor::Cells all = floor.reached(person, {base[0] + 1'000'000, base[1]}, 0);
  const NearFloor::Cells now = floor.reached(person, base, room_mm);
  // What the base itself stands on, they cannot miss.
  const auto misses = [&](PointMm at, const NearFloor::Cells& reached) {
    for (int cell = 0; cell < cells * cells; ++cell) {
      const auto i = static_cast<std::size_t>(cell);
      if (all[i] && !reached[i] && apart_mm(floor.point(cell), at) >= room_mm + cell_mm)
        return true;
    }
    return false;
  };
  if (!misses(base, now)) return {};
  const NearFloor::Cells own = floor.reached(base, person, room_mm);
  const double min_mm = std::min<double>(room_mm, apart_mm(base, person));
  const auto keeps_off = [&](PointMm at) { return apart_mm(at, person) >= min_mm; };
  std::vector<int> places;
  for (int cell = 0; cell < cells * cells; ++cell)
    if (own[static_cast<std::size_t>(cell)] && keeps_off(floor.point(cell))) places.push_back(cell);
  std::ranges::stable_sort(places, {}, [&](int cell) { return apart_mm(floor.point(cell), base); });
  for (const int cell : places) {
    const PointMm at = floor.point(cell);
    const NearFloor::Cells then = floor.reached(person, at, room_mm);
    if (opens_more(then, now) && !misses(at, then)) return at;
  }
  return {};
}

std::optional<PointMm> place_away(const navigation::FreeSpace& space,
                                  PointMm base,
                                  std::span<const MovingDisc> people,
                                  int room_mm) {
  if (people.empty()) return {};
  const PointMm person = floor_mm(nearest_to(base, people).position);
  const NearFloor floor(space, base);
  const NearFloor::Cells own = floor.reached(base, person, room_mm);
  std::optional<PointMm> best;
  const auto is_better = [&](PointMm at) {
    if (!best) return apart_mm(at, person) > apart_mm(base, person) + cell_mm;
    const double now = std::min(apart_mm(*best, person), far_mm);
    const double then = std::min(apart_mm(at, person), far_mm);
    return then > now || (then == now && apart_mm(at, base) < apart_mm(*best, base));
  };
  for (int cell = 0; cell < cells * cells; ++cell)
    if (own[static_cast<std::size_t>(cell)] && is_better(floor.point(cell)))
      best = floor.point(cell);
  return best;
}

Result<WayRound> plan_way_round(const navigation::VisibilityGraph& graph,
                                const robots::Robot& robot,
                                std::span<const double> state,
                                const FloorPlace& from,
                                const FloorPlace& to,
                                std::span<const MovingDisc> people,
                                bool waited) {
  const PointMm stands = graph.space().nearest_free(floor_mm(from.position), max_off_mm);
  const FloorPlace here{{stands[0] * 1e-3, stands[1] * 1e-3}, from.heading};
  auto past = plan_drive(graph, robot, state, here, to, people);
  if (past.ok() && gets_there(past->follower, people))
    return WayRound{.on = std::move(past->follower)};
  const int room_mm = graph.space().clearance_mm() +
                      static_cast<int>(std::lround((person_radius_m + beside_base_m) * 1e3));
  std::vector<std::optional<PointMm>> places{passing_place(graph.space(), stands, people, room_mm)};
  if (waited) places.insert(places.begin(), place_away(graph.space(), stands, people, room_mm));
  for (const std::optional<PointMm>& place : places) {
    if (!place) continue;
    const FloorPlace aside{{(*place)[0] * 1e-3, (*place)[1] * 1e-3}, from.heading};
    auto there = plan_drive(graph, robot, state, here, aside, people);
    auto on = plan_drive(graph, robot, state, aside, to);
    if (there.ok() && on.ok() && gets_there(there->follower, people))
      return WayRound{std::move(there->follower), let_past_s, std::move(on->follower)};
  }
  MARKETGEN_TRY(DrivePlan later, plan_drive(graph, robot, state, here, to));
  return WayRound{.wait_s = look_again_s, .on = std::move(later.follower)};
}

}  // namespace marketgen::motion
