#include "navigation/occupancy.h"

#include <algorithm>
#include <cmath>

namespace marketgen::navigation {
namespace {

std::int64_t squared(std::int64_t v) {
  return v * v;
}

// Cells from..to (inclusive) whose centres can lie within [low, high] along one axis.
struct CellSpan {
  int from = 0, to = -1;
};

CellSpan cells_within(int low, int high, int origin, int cell_mm, int count) {
  const int half = cell_mm / 2;
  const auto cell = [&](int at) {
    return static_cast<int>(std::floor(static_cast<double>(at - origin - half) / cell_mm));
  };
  return {std::max(0, cell(low)), std::min(count - 1, cell(high) + 1)};
}

// Cells whose centres lie at `low` to `high` along one axis, both included; low > high is none.
CellSpan cells_between(int low, int high, int origin, int cell_mm, int count) {
  const int first = origin + cell_mm / 2;
  const auto rounded_up = [&](int mm) { return (mm + cell_mm - 1) / cell_mm; };
  const int from = low > first ? rounded_up(low - first) : 0;
  const int to = high >= first ? (high - first) / cell_mm : -1;
  return {from, std::min(count - 1, to)};
}

// The largest k >= 0 with k * k < limit. Precondition: limit > 0.
int below_root(std::int64_t limit) {
  auto k = static_cast<std::int64_t>(std::sqrt(static_cast<double>(limit)));
  while (k * k >= limit)
    --k;
  while ((k + 1) * (k + 1) < limit)
    ++k;
  return static_cast<int>(k);
}

void fill_row(OccupancyGrid& grid, int row, CellSpan columns, std::uint8_t value) {
  if (columns.from > columns.to) return;
  const auto at = grid.blocked.begin() + static_cast<std::ptrdiff_t>(grid.index(columns.from, row));
  std::fill(at, at + (columns.to - columns.from + 1), value);
}

// How far beside the obstacle a row of centres at this y is blocked; nothing when it is not. A
// clearance of 0 still blocks the obstacle's own floor: -1 leaves its edges free.
std::optional<int> reach_beside(const RectMm& obstacle, int y, int clearance_mm) {
  const int dy = std::max({obstacle.y0 - y, 0, y - obstacle.y1});
  if (dy < clearance_mm) return below_root(squared(clearance_mm) - squared(dy));
  const bool own_floor = y > obstacle.y0 && y < obstacle.y1;
  return own_floor ? std::optional(-1) : std::nullopt;
}

void block_rectangle(OccupancyGrid& grid, const RectMm& obstacle, int clearance_mm) {
  const RectMm& bounds = grid.bounds;
  const CellSpan ys = cells_between(
      obstacle.y0 - clearance_mm, obstacle.y1 + clearance_mm, bounds.y0, grid.cell_mm, grid.rows);
  for (int row = ys.from; row <= ys.to; ++row) {
    const auto reach = reach_beside(obstacle, grid.center(0, row)[1], clearance_mm);
    if (!reach) continue;
    const CellSpan xs = cells_between(
        obstacle.x0 - *reach, obstacle.x1 + *reach, bounds.x0, grid.cell_mm, grid.columns);
    fill_row(grid, row, xs, 1);
  }
}

// Squared distance from p to the segment a-b, compared exactly: true when it is below limit.
bool nearer_than(PointMm p, PointMm a, PointMm b, int clearance_mm) {
  const std::int64_t dx = b[0] - a[0], dy = b[1] - a[1];
  const std::int64_t px = p[0] - a[0], py = p[1] - a[1];
  const std::int64_t length2 = dx * dx + dy * dy;
  const std::int64_t along = px * dx + py * dy;
  const std::int64_t limit = squared(clearance_mm);
  if (along <= 0) return px * px + py * py < limit;
  if (along >= length2) return squared(p[0] - b[0]) + squared(p[1] - b[1]) < limit;
  const double across = static_cast<double>(px * dy - py * dx);
  return across * across < static_cast<double>(limit) * static_cast<double>(length2);
}

// Where a row of cells at this y may lie nearer than the clearance to the segment a-b: the part of
// it that is no higher or lower than that, and the clearance beside it.
CellSpan cells_near(const OccupancyGrid& grid, PointMm a, PointMm b, int y, int clearance_mm) {
  double from = 0, to = 1;  // along the segment
  if (a[1] != b[1]) {
    const double one = static_cast<double>(y - clearance_mm - a[1]) / (b[1] - a[1]);
    const double other = static_cast<double>(y + clearance_mm - a[1]) / (b[1] - a[1]);
    from = std::clamp(std::min(one, other), 0.0, 1.0);
    to = std::clamp(std::max(one, other), 0.0, 1.0);
  }
  const auto x_at = [&](double share) { return a[0] + share * (b[0] - a[0]); };
  const double reach = clearance_mm + 1;  // rounding
  return cells_within(static_cast<int>(std::floor(std::min(x_at(from), x_at(to)) - reach)),
                      static_cast<int>(std::ceil(std::max(x_at(from), x_at(to)) + reach)),
                      grid.bounds.x0,
                      grid.cell_mm,
                      grid.columns);
}

void block_edge(OccupancyGrid& grid, PointMm a, PointMm b, int clearance_mm) {
  const RectMm reach =
      RectMm{std::min(a[0], b[0]), std::min(a[1], b[1]), std::max(a[0], b[0]), std::max(a[1], b[1])}
          .grown(clearance_mm);
  const CellSpan ys = cells_within(reach.y0, reach.y1, grid.bounds.y0, grid.cell_mm, grid.rows);
  for (int row = ys.from; row <= ys.to; ++row) {
    const CellSpan xs = cells_near(grid, a, b, grid.center(0, row)[1], clearance_mm);
    for (int column = xs.from; column <= xs.to; ++column) {
      if (nearer_than(grid.center(column, row), a, b, clearance_mm)) {
        grid.blocked[grid.index(column, row)] = 1;
      }
    }
  }
}

// Sets the cells whose centres lie inside the polygon, row by row between the crossings of its
// edges.
void fill_inside(OccupancyGrid& grid, const PolygonMm& floor, std::uint8_t value) {
  std::vector<double> crossings;
  const RectMm reach = bounds_of(floor);
  const CellSpan ys = cells_within(reach.y0, reach.y1, grid.bounds.y0, grid.cell_mm, grid.rows);
  for (int row = ys.from; row <= ys.to; ++row) {
    const int y = grid.center(0, row)[1];
    crossings.clear();
    for (std::size_t i = 0; i < floor.size(); ++i) {
      const PointMm& a = floor[i];
      const PointMm& b = floor[(i + 1) % floor.size()];
      if ((a[1] > y) == (b[1] > y)) continue;
      const double share = static_cast<double>(y - a[1]) / static_cast<double>(b[1] - a[1]);
      crossings.push_back(a[0] + share * (b[0] - a[0]));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      // Centres strictly between the two crossings.
      const CellSpan xs = cells_between(static_cast<int>(std::floor(crossings[i])) + 1,
                                        static_cast<int>(std::ceil(crossings[i + 1])) - 1,
                                        grid.bounds.x0,
                                        grid.cell_mm,
                                        grid.columns);
      fill_row(grid, row, xs, value);
    }
  }
}

// The cells of the grid that meet `area`, as a grid of their own.
OccupancyGrid cropped(const OccupancyGrid& grid, const RectMm& area) {
  const CellSpan xs = cells_within(area.x0, area.x1, grid.bounds.x0, grid.cell_mm, grid.columns);
  const CellSpan ys = cells_within(area.y0, area.y1, grid.bounds.y0, grid.cell_mm, grid.rows);
  OccupancyGrid part;
  part.cell_mm = grid.cell_mm;
  part.columns = std::max(0, xs.to - xs.from + 1);
  part.rows = std::max(0, ys.to - ys.from + 1);
  const int x0 = grid.bounds.x0 + xs.from * grid.cell_mm;
  const int y0 = grid.bounds.y0 + ys.from * grid.cell_mm;
  part.bounds = {x0, y0, x0 + part.columns * grid.cell_mm, y0 + part.rows * grid.cell_mm};
  for (int row = 0; row < part.rows; ++row) {
    const auto first =
        grid.blocked.begin() + static_cast<std::ptrdiff_t>(grid.index(xs.from, ys.from + row));
    part.blocked.insert(part.blocked.end(), first, first + part.columns);
  }
  return part;
}

}  // namespace

OccupancyGrid make_occupancy(const PolygonMm& floor,
                             const std::vector<RectMm>& obstacles,
                             int clearance_mm,
                             int cell_mm) {
  OccupancyGrid grid;
  grid.bounds = bounds_of(floor);
  grid.cell_mm = cell_mm;
  grid.columns = (grid.bounds.width() + cell_mm - 1) / cell_mm;
  grid.rows = (grid.bounds.depth() + cell_mm - 1) / cell_mm;
  grid.blocked.assign(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows),
                      1);
  fill_inside(grid, floor, 0);
  for (std::size_t i = 0; i < floor.size(); ++i) {
    block_edge(grid, floor[i], floor[(i + 1) % floor.size()], clearance_mm);
  }
  for (const RectMm& obstacle : obstacles)
    block_rectangle(grid, obstacle, clearance_mm);
  return grid;
}

OccupancyGrid with_blocked(OccupancyGrid grid, const std::vector<PolygonMm>& polygons) {
  for (const PolygonMm& polygon : polygons)
    fill_inside(grid, polygon, 1);
  return grid;
}

OccupancyGrid with_obstacle(OccupancyGrid grid, const RectMm& obstacle, int clearance_mm) {
  block_rectangle(grid, obstacle, clearance_mm);
  return grid;
}

bool stays_joined(const OccupancyGrid& grid,
                  const RectMm& obstacle,
                  int clearance_mm,
                  int reach_mm) {
  OccupancyGrid part = cropped(grid, obstacle.grown(clearance_mm + reach_mm));
  const Components before = find_components(part);
  const Components after = find_components(with_obstacle(std::move(part), obstacle, clearance_mm));
  std::vector<int> became(before.cells.size(), 0);  // by label before: the one label after
  for (std::size_t cell = 0; cell < after.label.size(); ++cell) {
    const int now = after.label[cell];
    if (now == 0) continue;
    int& known = became[static_cast<std::size_t>(before.label[cell])];
    if (known != 0 && known != now) return false;
    known = now;
  }
  return true;
}

std::optional<std::size_t> nearest_free(const OccupancyGrid& grid, PointMm point, int reach_mm) {
  const RectMm reach = RectMm{point[0], point[1], point[0], point[1]}.grown(reach_mm);
  const CellSpan xs = cells_within(reach.x0, reach.x1, grid.bounds.x0, grid.cell_mm, grid.columns);
  const CellSpan ys = cells_within(reach.y0, reach.y1, grid.bounds.y0, grid.cell_mm, grid.rows);
  std::optional<std::size_t> best;
  std::int64_t best_distance = squared(reach_mm) + 1;
  for (int row = ys.from; row <= ys.to; ++row) {
    for (int column = xs.from; column <= xs.to; ++column) {
      if (!grid.free(column, row)) continue;
      const PointMm p = grid.center(column, row);
      const std::int64_t distance = squared(p[0] - point[0]) + squared(p[1] - point[1]);
      if (distance >= best_distance) continue;
      best_distance = distance;
      best = grid.index(column, row);
    }
  }
  return best;
}

}  // namespace marketgen::navigation
