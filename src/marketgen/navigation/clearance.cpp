#include <algorithm>
#include <cmath>

#include "navigation/occupancy.h"

namespace marketgen::navigation {
namespace {

constexpr double far_cells2 =
    1e15;  // squared distance of a cell that no blocked cell has been seen from

// One line of the transform: out[i] = min over k of (i - k)^2 + in[k]. Lower envelope of parabolas,
// linear time.
class LineTransform {
 public:
  explicit LineTransform(std::size_t longest) : apex_(longest), from_(longest + 1) {}

  void run(const std::vector<double>& in, std::vector<double>& out, std::size_t count) {
    std::size_t top = 0;
    apex_[0] = 0;
    from_[0] = -far_cells2;
    from_[1] = far_cells2;
    for (std::size_t i = 1; i < count; ++i) {
      double meets = crossing(in, apex_[top], i);
      while (meets <= from_[top])
        meets = crossing(in, apex_[--top], i);
      apex_[++top] = i;
      from_[top] = meets;
      from_[top + 1] = far_cells2;
    }
    top = 0;
    for (std::size_t i = 0; i < count; ++i) {
      while (from_[top + 1] < static_cast<double>(i))
        ++top;
      const double away = static_cast<double>(i) - static_cast<double>(apex_[top]);
      out[i] = away * away + in[apex_[top]];
    }
  }

 private:
  static double crossing(const std::vector<double>& in, std::size_t a, std::size_t b) {
    const auto x = static_cast<double>(a), z = static_cast<double>(b);
    return ((in[b] + z * z) - (in[a] + x * x)) / (2 * z - 2 * x);
  }

  std::vector<std::size_t> apex_;
  std::vector<double> from_;
};

}  // namespace

std::vector<float> clearance_field(const OccupancyGrid& grid) {
  // A ring of blocked cells stands for the border.
  const std::size_t columns = static_cast<std::size_t>(grid.columns) + 2;
  const std::size_t rows = static_cast<std::size_t>(grid.rows) + 2;
  std::vector<double> squares(columns * rows, 0);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      if (!grid.free(column, row)) continue;
      squares[static_cast<std::size_t>(row + 1) * columns + static_cast<std::size_t>(column + 1)] =
          far_cells2;
    }
  }
  const std::size_t longest = std::max(columns, rows);
  LineTransform line(longest);
  std::vector<double> in(longest), out(longest);
  for (std::size_t column = 0; column < columns; ++column) {
    for (std::size_t row = 0; row < rows; ++row)
      in[row] = squares[row * columns + column];
    line.run(in, out, rows);
    for (std::size_t row = 0; row < rows; ++row)
      squares[row * columns + column] = out[row];
  }
  std::vector<float> field(grid.blocked.size());
  for (std::size_t row = 1; row + 1 < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      in[column] = squares[row * columns + column];
    }
    line.run(in, out, columns);
    for (std::size_t column = 1; column + 1 < columns; ++column) {
      const std::size_t cell = grid.index(static_cast<int>(column) - 1, static_cast<int>(row) - 1);
      field[cell] = static_cast<float>(std::sqrt(out[column]) * grid.cell_mm);
    }
  }
  return field;
}

}  // namespace marketgen::navigation
