// Occupancy grids and shortest paths on them: used by layout rules, the audit and the Nav2 export.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/rectangle.h"

namespace marketgen::navigation {

// Square cells of `cell_mm` over `bounds`; cell (0, 0) is south-west. 1 = blocked.
struct OccupancyGrid {
  RectMm bounds;
  int cell_mm = 50;
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> blocked;

  bool inside(int column, int row) const {
    return column >= 0 && row >= 0 && column < columns && row < rows;
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  bool free(int column, int row) const {
    return inside(column, row) && blocked[index(column, row)] == 0;
  }
  PointMm center(int column, int row) const {
    return {bounds.x0 + column * cell_mm + cell_mm / 2, bounds.y0 + row * cell_mm + cell_mm / 2};
  }
};

// Cells whose centre is nearer than `clearance_mm` to an obstacle, or outside `floor` shrunk by it,
// are blocked. Euclidean distance to rectangles. Deterministic.
OccupancyGrid make_occupancy(const PolygonMm& floor,
                             const std::vector<RectMm>& obstacles,
                             int clearance_mm,
                             int cell_mm = 50);

// The grid, with the cells blocked whose centres lie inside any of the polygons.
OccupancyGrid with_blocked(OccupancyGrid grid, const std::vector<PolygonMm>& polygons);

// The grid with one obstacle more, cells nearer than `clearance_mm` to it blocked.
OccupancyGrid with_obstacle(OccupancyGrid grid, const RectMm& obstacle, int clearance_mm);

// 4-connected components of the free cells: label per cell (0 = blocked, 1.. in scan order) and
// cells per label.
struct Components {
  std::vector<int> label;
  std::vector<int> cells;  // cells[label]; cells[0] unused
  int largest() const;     // label, 0 if there is none
};
Components find_components(const OccupancyGrid& grid);

// Whether what is free round a new obstacle still hangs together once it stands, seen no farther
// than `reach_mm` beyond what it blocks: then it cuts nothing off. Where the only way round is
// longer than that, the answer is no.
bool stays_joined(const OccupancyGrid& grid,
                  const RectMm& obstacle,
                  int clearance_mm,
                  int reach_mm);

// Free cell nearest to a point within `reach_mm`, as cell index.
std::optional<std::size_t> nearest_free(const OccupancyGrid& grid, PointMm point, int reach_mm);

struct GridPath {
  std::vector<PointMm> points;
  double length_m = 0;
};
// Shortest 8-connected path by A*, then shortened by line of sight. Nothing when unreachable.
std::optional<GridPath> shortest_path(const OccupancyGrid& grid, PointMm from, PointMm to);

// Way in mm from each free cell to the nearest of `starts`, by steps to the eight cells round it;
// infinity where there is none. Dijkstra.
std::vector<float> distances_from(const OccupancyGrid& grid,
                                  const std::vector<std::size_t>& starts);

// Distance in mm from each free cell to the nearest blocked cell or border, by an exact Euclidean
// transform (Felzenszwalb & Huttenlocher 2012).
std::vector<float> clearance_field(const OccupancyGrid& grid);

}  // namespace marketgen::navigation
