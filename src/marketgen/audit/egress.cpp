#include "audit/egress.h"

#include <cmath>

#include "audit/traffic.h"
#include "navigation/occupancy.h"
#include "plan/bsp.h"
#include "plan/egress.h"
#include "plan/floor_places.h"

namespace marketgen::audit {
namespace {

constexpr int person_radius_mm = 225, square_mm = 200;

// The free squares just inside the doors.
std::vector<std::size_t> thresholds(const layout::Layout& layout,
                                    const navigation::OccupancyGrid& grid) {
  constexpr int search_mm = 1500;
  std::vector<std::size_t> cells;
  for (const plan::Opening& opening : layout.shell.openings) {
    if (!plan::leads_outside(opening)) continue;
    const PointMm inside =
        plan::point_inside(plan::shell_rect(layout.shell), opening, person_radius_mm + square_mm);
    if (const auto cell = navigation::nearest_free(grid, inside, search_mm)) cells.push_back(*cell);
  }
  return cells;
}

}  // namespace

Egress measure_egress(const layout::Layout& layout) {
  Egress egress;
  const PolygonMm floor = plan::floor_of(layout.shell);
  const navigation::OccupancyGrid grid =
      navigation::make_occupancy(floor, obstacles_of(layout), person_radius_mm, square_mm);
  const std::vector<float> ways = navigation::distances_from(grid, thresholds(layout, grid));
  for (std::size_t cell = 0; cell < ways.size(); ++cell) {
    if (!std::isfinite(ways[cell]) || ways[cell] * 1e-3 <= egress.longest_m) continue;
    egress.longest_m = ways[cell] * 1e-3;
    const auto columns = static_cast<std::size_t>(grid.columns);
    egress.farthest =
        grid.center(static_cast<int>(cell % columns), static_cast<int>(cell / columns));
  }
  return egress;
}

}  // namespace marketgen::audit
