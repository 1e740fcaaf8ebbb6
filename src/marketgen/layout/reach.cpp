#include "layout/reach.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <queue>
#include <set>

#include "layout/side.h"

namespace marketgen::layout {
namespace {

constexpr int cell_mm = 50;
constexpr int entrance_reach_mm = 2500;
constexpr double min_pocket_m2 = 0.04;  // smaller pockets are rounding of the grid
constexpr int max_rounds = 60;
constexpr int open_cost = 1, blocked_cost = 50;  // a metre of fixture is worth a detour of 50 m

std::vector<RectMm> obstacles_of(const Floor& floor, const std::vector<Fixture>& fixtures) {
  std::vector<RectMm> obstacles = floor.columns;
  for (const Fixture& fixture : fixtures)
    obstacles.push_back(footprint_of(fixture));
  return obstacles;
}

// The largest part that is cut off from the entrance and is not in `given_up`; 0 if there is none.
int shut_off_label(const Reach& reach, const std::set<int>& given_up) {
  const double cell_m2 = 1e-6 * cell_mm * cell_mm;
  int best = 0;
  for (int label = 1; label < static_cast<int>(reach.components.cells.size()); ++label) {
    const int cells = reach.components.cells[static_cast<std::size_t>(label)];
    if (label == reach.from_entrance || given_up.contains(label)) continue;
    if (cells * cell_m2 < min_pocket_m2) continue;
    if (best == 0 || cells > reach.components.cells[static_cast<std::size_t>(best)]) best = label;
  }
  return best;
}

// The cheapest way from one labelled part to the entrance's, through fixtures where it must. Empty
// when walls are between.
std::vector<std::size_t> way_out(const Reach& reach,
                                 const navigation::OccupancyGrid& bare,
                                 int label) {
  using Entry = std::pair<int, std::size_t>;
  constexpr int unseen = std::numeric_limits<int>::max();
  std::vector<int> cost(bare.blocked.size(), unseen);
  std::vector<std::size_t> parent(bare.blocked.size(), 0);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (std::size_t cell = 0; cell < bare.blocked.size(); ++cell) {
    if (reach.components.label[cell] != label) continue;
    cost[cell] = 0;
    parent[cell] = cell;
    open.emplace(0, cell);
  }
  const int columns = bare.columns;
  while (!open.empty()) {
    const auto [so_far, cell] = open.top();
    open.pop();
    if (so_far > cost[cell]) continue;
    if (reach.reached(cell)) {
      std::vector<std::size_t> way{cell};
      while (parent[way.back()] != way.back())
        way.push_back(parent[way.back()]);
      return way;
    }
    const int column = static_cast<int>(cell % static_cast<std::size_t>(columns));
    const int row = static_cast<int>(cell / static_cast<std::size_t>(columns));
    for (const auto& [dx, dy] :
         std::array<std::pair<int, int>, 4>{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}}) {
      if (!bare.free(column + dx, row + dy)) continue;
      const std::size_t next = bare.index(column + dx, row + dy);
      const int through = so_far + (reach.grid.blocked[next] != 0 ? blocked_cost : open_cost);
      if (through >= cost[next]) continue;
      cost[next] = through;
      parent[next] = cell;
      open.emplace(through, next);
    }
  }
  return {};
}

bool near_way(const RectMm& rect,
              const std::vector<std::size_t>& way,
              const navigation::OccupancyGrid& grid,
              int radius_mm) {
  const std::int64_t limit = std::int64_t{radius_mm} * radius_mm;
  return std::ranges::any_of(way, [&](std::size_t cell) {
    const PointMm p = grid.center(static_cast<int>(cell % static_cast<std::size_t>(grid.columns)),
                                  static_cast<int>(cell / static_cast<std::size_t>(grid.columns)));
    const std::int64_t dx = std::max({rect.x0 - p[0], 0, p[0] - rect.x1});
    const std::int64_t dy = std::max({rect.y0 - p[1], 0, p[1] - rect.y1});
    return dx * dx + dy * dy < limit;
  });
}

// What ways may lead through: columns and the fixtures that stay are in the way.
navigation::OccupancyGrid bare_floor(const Design& design,
                                     const std::vector<Fixture>& fixtures,
                                     const std::set<std::string>& standing,
                                     int width_mm) {
  std::vector<RectMm> obstacles = design.floor.columns;
  for (const Fixture& fixture : fixtures) {
    if (standing.contains(fixture.zone)) obstacles.push_back(footprint_of(fixture));
  }
  return navigation::make_occupancy(design.floor.outline, obstacles, width_mm / 2, cell_mm);
}

// Removes fixtures until everything that is free for this width hangs together.
void join_parts(const Design& design,
                std::vector<Fixture>& fixtures,
                const std::set<std::string>& standing,
                int width_mm) {
  std::optional<navigation::OccupancyGrid> bare;  // made when something is shut off
  std::set<int> given_up;
  for (int round = 0; round < max_rounds; ++round) {
    const Reach reach = reach_of(design.floor, design.plan.shell, fixtures, width_mm);
    const int label = shut_off_label(reach, given_up);
    if (label == 0 || reach.from_entrance == 0) return;
    if (!bare) bare = bare_floor(design, fixtures, standing, width_mm);
    const std::vector<std::size_t> way = way_out(reach, *bare, label);
    const std::size_t before = fixtures.size();
    std::erase_if(fixtures, [&](const Fixture& fixture) {
      return !standing.contains(fixture.zone) &&
             near_way(footprint_of(fixture), way, *bare, width_mm / 2);
    });
    if (fixtures.size() == before) {
      given_up.insert(label);
    } else {
      given_up.clear();  // labels are numbered anew
    }
  }
}

void drop_unreachable(const Design& design,
                      std::vector<Fixture>& fixtures,
                      const std::set<std::string>& standing,
                      int width_mm) {
  const Reach reach = reach_of(design.floor, design.plan.shell, fixtures, width_mm);
  if (reach.from_entrance == 0) return;
  std::erase_if(fixtures, [&](const Fixture& fixture) {
    if (standing.contains(fixture.zone)) return false;
    for (int side = 0; side < fixture.sides; ++side) {
      if (!reach.reaches(standing_place(fixture, side, width_mm))) return true;
    }
    return false;
  });
}

}  // namespace

bool Reach::reaches(const RectMm& rect) const {
  if (from_entrance == 0) return false;
  const int size = grid.cell_mm;
  const int c0 = std::max(0, (rect.x0 - grid.bounds.x0) / size);
  const int c1 = std::min(grid.columns - 1, (rect.x1 - grid.bounds.x0) / size);
  const int r0 = std::max(0, (rect.y0 - grid.bounds.y0) / size);
  const int r1 = std::min(grid.rows - 1, (rect.y1 - grid.bounds.y0) / size);
  for (int row = r0; row <= r1; ++row) {
    for (int column = c0; column <= c1; ++column) {
      if (components.label[grid.index(column, row)] == from_entrance) return true;
    }
  }
  return false;
}

Reach reach_of(const Floor& floor,
               const plan::Shell& shell,
               const std::vector<Fixture>& fixtures,
               int width_mm) {
  return reach_on(navigation::make_occupancy(
                      floor.outline, obstacles_of(floor, fixtures), width_mm / 2, cell_mm),
                  floor,
                  shell);
}

Reach reach_on(navigation::OccupancyGrid grid, const Floor& floor, const plan::Shell& shell) {
  Reach reach;
  reach.grid = std::move(grid);
  reach.components = navigation::find_components(reach.grid);
  const Doorway* door = entrance_of(floor, shell);
  if (door == nullptr) {
    reach.from_entrance = reach.components.largest();
    return reach;
  }
  const auto cell =
      navigation::nearest_free(reach.grid, door->approach.center(), entrance_reach_mm);
  if (cell) reach.from_entrance = reach.components.label[*cell];
  return reach;
}

RectMm standing_place(const Fixture& fixture, int side, int width_mm) {
  const Side front = facing_of(fixture.yaw_deg);
  return strip_beyond(
      footprint_of(fixture), side == 0 ? front : opposite(front), width_mm / 2 + 2 * cell_mm);
}

std::vector<Fixture> opened_up(const Design& design,
                               std::vector<Fixture> fixtures,
                               const std::set<std::string>& standing) {
  const int wheelchair = design.profile.wheelchair_mm;
  for (const int width : {wheelchair, robot_width_mm})
    join_parts(design, fixtures, standing, width);
  drop_unreachable(design, fixtures, standing, wheelchair);
  return fixtures;
}

}  // namespace marketgen::layout
