#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <queue>
#include <utility>

#include "navigation/occupancy.h"

namespace marketgen::navigation {
namespace {

constexpr int snap_reach_mm = 1500;  // how far from a wanted end the path may begin or stop
constexpr int straight_cost = 1000,
              diagonal_cost = 1414;  // whole numbers: ties fall the same way everywhere
constexpr int unreached = std::numeric_limits<int>::max();

struct Cell {
  int column, row;
};
struct Step {
  int dx, dy, cost;
};
constexpr std::array<Step, 8> steps{{{1, 0, straight_cost},
                                     {0, 1, straight_cost},
                                     {-1, 0, straight_cost},
                                     {0, -1, straight_cost},
                                     {1, 1, diagonal_cost},
                                     {-1, 1, diagonal_cost},
                                     {-1, -1, diagonal_cost},
                                     {1, -1, diagonal_cost}}};

Cell cell_of(const OccupancyGrid& grid, std::size_t index) {
  return {static_cast<int>(index % static_cast<std::size_t>(grid.columns)),
          static_cast<int>(index / static_cast<std::size_t>(grid.columns))};
}

int octile(Cell a, Cell b) {
  const int dx = std::abs(a.column - b.column), dy = std::abs(a.row - b.row);
  return straight_cost * std::max(dx, dy) + (diagonal_cost - straight_cost) * std::min(dx, dy);
}

// A diagonal step needs both cells beside it: no squeezing past corners.
bool can_step(const OccupancyGrid& grid, Cell from, const Step& step) {
  if (!grid.free(from.column + step.dx, from.row + step.dy)) return false;
  return step.dx == 0 || step.dy == 0 ||
         (grid.free(from.column + step.dx, from.row) && grid.free(from.column, from.row + step.dy));
}

// Cells from start to goal, empty when there is no way. A*; equal costs are taken in cell order.
std::vector<std::size_t> search(const OccupancyGrid& grid, std::size_t start, std::size_t goal) {
  struct Open {
    int estimate;
    std::size_t cell;
    bool operator>(const Open& o) const {
      return estimate != o.estimate ? estimate > o.estimate : cell > o.cell;
    }
  };
  std::vector<int> cost(grid.blocked.size(), unreached);
  std::vector<std::size_t> parent(grid.blocked.size(), start);
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  const Cell target = cell_of(grid, goal);
  cost[start] = 0;
  open.push({octile(cell_of(grid, start), target), start});
  while (!open.empty()) {
    const Open best = open.top();
    open.pop();
    if (best.cell == goal) break;
    const Cell at = cell_of(grid, best.cell);
    if (best.estimate > cost[best.cell] + octile(at, target)) continue;  // an older, dearer entry
    for (const Step& step : steps) {
      if (!can_step(grid, at, step)) continue;
      const std::size_t next = grid.index(at.column + step.dx, at.row + step.dy);
      const int through = cost[best.cell] + step.cost;
      if (through >= cost[next]) continue;
      cost[next] = through;
      parent[next] = best.cell;
      open.push({through + octile(cell_of(grid, next), target), next});
    }
  }
  if (cost[goal] == unreached) return {};
  std::vector<std::size_t> cells{goal};
  while (cells.back() != start)
    cells.push_back(parent[cells.back()]);
  std::reverse(cells.begin(), cells.end());
  return cells;
}

// Every cell that the straight line between two cell centres touches is free.
bool in_sight(const OccupancyGrid& grid, Cell a, Cell b) {
  const int dx = std::abs(b.column - a.column), dy = std::abs(b.row - a.row);
  const int sx = b.column > a.column ? 1 : -1, sy = b.row > a.row ? 1 : -1;
  Cell at = a;
  int balance =
      dx - dy;  // which grid line the ray meets next: > 0 vertical, < 0 horizontal, 0 both
  for (int left = dx + dy; left > 0; --left) {
    if (balance > 0) {
      at.column += sx;
      balance -= 2 * dy;
    } else if (balance < 0) {
      at.row += sy;
      balance += 2 * dx;
    } else {
      if (!grid.free(at.column + sx, at.row) || !grid.free(at.column, at.row + sy)) return false;
      at = {at.column + sx, at.row + sy};
      balance += 2 * (dx - dy);
      --left;
    }
    if (!grid.free(at.column, at.row)) return false;
  }
  return true;
}

// Keeps only the corners: from each kept cell, the farthest cell along the path that it can see.
std::vector<std::size_t> pulled_straight(const OccupancyGrid& grid,
                                         const std::vector<std::size_t>& cells) {
  std::vector<std::size_t> kept{cells.front()};
  std::size_t at = 0;
  while (at + 1 < cells.size()) {
    std::size_t next = at + 1;
    while (next + 1 < cells.size() &&
           in_sight(grid, cell_of(grid, cells[at]), cell_of(grid, cells[next + 1]))) {
      ++next;
    }
    kept.push_back(cells[next]);
    at = next;
  }
  return kept;
}

}  // namespace

std::vector<float> distances_from(const OccupancyGrid& grid,
                                  const std::vector<std::size_t>& starts) {
  using Open = std::pair<int, std::size_t>;
  std::vector<int> cost(grid.blocked.size(), unreached);
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  for (const std::size_t start : starts) {
    cost[start] = 0;
    open.emplace(0, start);
  }
  while (!open.empty()) {
    const auto [so_far, cell] = open.top();
    open.pop();
    if (so_far > cost[cell]) continue;  // an older, dearer entry
    const Cell at = cell_of(grid, cell);
    for (const Step& step : steps) {
      if (!can_step(grid, at, step)) continue;
      const std::size_t next = grid.index(at.column + step.dx, at.row + step.dy);
      const int through = so_far + step.cost;
      if (through >= cost[next]) continue;
      cost[next] = through;
      open.emplace(through, next);
    }
  }
  std::vector<float> ways(cost.size(), std::numeric_limits<float>::infinity());
  const double mm_per_cost = static_cast<double>(grid.cell_mm) / straight_cost;
  for (std::size_t cell = 0; cell < cost.size(); ++cell)
    if (cost[cell] != unreached) ways[cell] = static_cast<float>(cost[cell] * mm_per_cost);
  return ways;
}

std::optional<GridPath> shortest_path(const OccupancyGrid& grid, PointMm from, PointMm to) {
  const std::optional<std::size_t> start = nearest_free(grid, from, snap_reach_mm);
  const std::optional<std::size_t> goal = nearest_free(grid, to, snap_reach_mm);
  if (!start || !goal) return std::nullopt;
  const std::vector<std::size_t> cells = search(grid, *start, *goal);
  if (cells.empty()) return std::nullopt;
  GridPath path;
  for (const std::size_t index : pulled_straight(grid, cells)) {
    const Cell cell = cell_of(grid, index);
    const PointMm point = grid.center(cell.column, cell.row);
    if (!path.points.empty()) {
      const double dx = point[0] - path.points.back()[0], dy = point[1] - path.points.back()[1];
      path.length_m += std::sqrt(dx * dx + dy * dy) * 1e-3;
    }
    path.points.push_back(point);
  }
  return path;
}

}  // namespace marketgen::navigation
