#include <algorithm>
#include <numeric>

#include "navigation/occupancy.h"

namespace marketgen::navigation {
namespace {

// Free cells side by side in one row.
struct Run {
  int from = 0, to = 0;  // columns, `to` excluded
};

// Which runs hang together. A part is known by the first of its runs, in scan order.
class Parts {
 public:
  explicit Parts(std::size_t runs) : first_(runs) { std::iota(first_.begin(), first_.end(), 0U); }

  std::size_t of(std::size_t run) {
    while (first_[run] != run)
      run = first_[run] = first_[first_[run]];
    return run;
  }
  void join(std::size_t a, std::size_t b) {
    a = of(a);
    b = of(b);
    first_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> first_;
};

struct Runs {
  std::vector<Run> runs;               // row by row, west to east
  std::vector<std::size_t> row_begin;  // of each row in `runs`, and one past the last
};

Runs runs_of(const OccupancyGrid& grid) {
  Runs found;
  const auto columns = static_cast<std::size_t>(grid.columns);
  for (int row = 0; row < grid.rows; ++row) {
    found.row_begin.push_back(found.runs.size());
    const auto begin = grid.blocked.begin() + static_cast<std::ptrdiff_t>(grid.index(0, row));
    const auto end = begin + static_cast<std::ptrdiff_t>(columns);
    for (auto from = std::find(begin, end, 0); from != end;) {
      const auto to = std::find_if(from, end, [](std::uint8_t blocked) { return blocked != 0; });
      found.runs.push_back({static_cast<int>(from - begin), static_cast<int>(to - begin)});
      from = std::find(to, end, 0);
    }
  }
  found.row_begin.push_back(found.runs.size());
  return found;
}

// Joins the runs of a row with those of the row south of it that they touch.
void join_row(const Runs& all, std::size_t row, Parts& parts) {
  std::size_t south = all.row_begin[row - 1];
  const std::size_t south_end = all.row_begin[row];
  for (std::size_t run = all.row_begin[row]; run < all.row_begin[row + 1]; ++run) {
    while (south < south_end && all.runs[south].to <= all.runs[run].from)
      ++south;
    for (std::size_t s = south; s < south_end && all.runs[s].from < all.runs[run].to; ++s)
      parts.join(s, run);
  }
}

}  // namespace

Components find_components(const OccupancyGrid& grid) {
  const Runs all = runs_of(grid);
  Parts parts(all.runs.size());
  const auto rows = static_cast<std::size_t>(grid.rows);
  for (std::size_t row = 1; row < rows; ++row)
    join_row(all, row, parts);
  Components found;
  found.label.assign(grid.blocked.size(), 0);
  found.cells.push_back(0);
  std::vector<int> labels(all.runs.size(), 0);  // of the first run of each part
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = all.row_begin[row]; i < all.row_begin[row + 1]; ++i) {
      int& label = labels[parts.of(i)];
      if (label == 0) {
        label = static_cast<int>(found.cells.size());
        found.cells.push_back(0);
      }
      const Run run = all.runs[i];
      found.cells[static_cast<std::size_t>(label)] += run.to - run.from;
      const auto at = found.label.begin() +
                      static_cast<std::ptrdiff_t>(grid.index(run.from, static_cast<int>(row)));
      std::fill(at, at + (run.to - run.from), label);
    }
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

}  // namespace marketgen::navigation
