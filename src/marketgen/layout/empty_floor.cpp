#include "layout/empty_floor.h"

#include <algorithm>

namespace marketgen::layout {
namespace {

constexpr int coarse_cell_mm = 200;

std::vector<RectMm> solid(const Floor& floor, const std::vector<Fixture>& fixtures) {
  std::vector<RectMm> taken = floor.columns;
  for (const Fixture& fixture : fixtures)
    taken.push_back(footprint_of(fixture));
  return taken;
}

}  // namespace

EmptyFloor::EmptyFloor(const Floor& floor, const std::vector<Fixture>& fixtures)
    : grid_(navigation::make_occupancy(floor.outline, solid(floor, fixtures), 0, coarse_cell_mm)),
      radius_mm_(navigation::clearance_field(grid_)) {}

std::optional<EmptyDisc> EmptyFloor::largest_in(const RectMm& area) const {
  std::optional<EmptyDisc> best;
  const auto cell = [&](int at, int from) { return std::max(0, (at - from) / grid_.cell_mm); };
  const int rows = std::min(grid_.rows, cell(area.y1, grid_.bounds.y0) + 1);
  const int columns = std::min(grid_.columns, cell(area.x1, grid_.bounds.x0) + 1);
  for (int row = cell(area.y0, grid_.bounds.y0); row < rows; ++row) {
    for (int column = cell(area.x0, grid_.bounds.x0); column < columns; ++column) {
      const auto radius = static_cast<int>(radius_mm_[grid_.index(column, row)]);
      if (radius > (best ? best->radius_mm : 0)) best = {grid_.center(column, row), radius};
    }
  }
  return best;
}

void EmptyFloor::add(const RectMm& footprint) {
  for (int row = 0; row < grid_.rows; ++row) {
    for (int column = 0; column < grid_.columns; ++column) {
      float& radius = radius_mm_[grid_.index(column, row)];
      const double away = distance_mm(footprint, point_rect(grid_.center(column, row)));
      radius = std::min(radius, static_cast<float>(away));
    }
  }
}

}  // namespace marketgen::layout
