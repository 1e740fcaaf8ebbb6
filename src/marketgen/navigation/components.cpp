#include <array>

#include "navigation/occupancy.h"

namespace marketgen {
namespace {

// Labels everything that is connected to `start`; returns how many cells that is.
int flood(const OccupancyGrid& grid, std::size_t start, int label, Components& found) {
  const auto columns = static_cast<std::size_t>(grid.columns);
  std::vector<std::size_t> pending{start};
  found.label[start] = label;
  int cells = 0;
  while (!pending.empty()) {
    const std::size_t cell = pending.back();
    pending.pop_back();
    ++cells;
    const std::size_t column = cell % columns, row = cell / columns;
    const auto visit = [&](std::size_t next) {
      if (grid.blocked[next] != 0 || found.label[next] != 0) return;
      found.label[next] = label;
      pending.push_back(next);
    };
    if (column > 0) visit(cell - 1);
    if (column + 1 < columns) visit(cell + 1);
    if (row > 0) visit(cell - columns);
    if (row + 1 < static_cast<std::size_t>(grid.rows)) visit(cell + columns);
  }
  return cells;
}

}  // namespace

Components find_components(const OccupancyGrid& grid) {
  Components found;
  found.label.assign(grid.blocked.size(), 0);
  found.cells.push_back(0);
  for (std::size_t cell = 0; cell < grid.blocked.size(); ++cell) {
    if (grid.blocked[cell] != 0 || found.label[cell] != 0) continue;
    const int label = static_cast<int>(found.cells.size());
    found.cells.push_back(flood(grid, cell, label, found));
  }
  return found;
}

int Components::largest() const {
  int best = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (best == 0 || cells[i] > cells[static_cast<std::size_t>(best)]) best = static_cast<int>(i);
  }
  return best;
}

}  // namespace marketgen
