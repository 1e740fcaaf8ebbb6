#include "assets/materials/cells.h"

#include <array>
#include <limits>
#include <string>

namespace marketgen::assets {
namespace {

struct Point {
  float x, y;
};

// Points of a jittered grid, in cells.
class PointGrid {
 public:
  PointGrid(int cells, float jitter, const Seed& seed) : cells_(cells) {
    Stream draw = seed.stream();
    const auto off = [&] { return 0.5F + jitter * static_cast<float>(draw.uniform(-0.5, 0.5)); };
    for (int i = 0; i < cells * cells; ++i) {
      const float x = off();
      points_.push_back({x, off()});
    }
  }

  // The cell under (x, y), both in cells from the top left.
  Cell at(float x, float y) const {
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    std::array<Point, 9> near;
    std::size_t nearest = 0;
    float least = std::numeric_limits<float>::max();
    for (std::size_t k = 0; k < near.size(); ++k) {
      near[k] =
          apart(column + static_cast<int>(k % 3) - 1, row + static_cast<int>(k / 3) - 1, x, y);
      const float squared = near[k].x * near[k].x + near[k].y * near[k].y;
      if (squared < least) {
        least = squared;
        nearest = k;
      }
    }
    const Point own = near[nearest];
    float border = std::numeric_limits<float>::max();
    for (std::size_t k = 0; k < near.size(); ++k) {
      if (k == nearest) continue;
      const Point between{near[k].x - own.x, near[k].y - own.y};
      const float length = std::sqrt(between.x * between.x + between.y * between.y);
      const float to_middle = (near[k].x + own.x) * between.x + (near[k].y + own.y) * between.y;
      border = std::min(border, to_middle / (2 * length));
    }
    const int at = wrapped(row + static_cast<int>(nearest / 3) - 1) * cells_ +
                   wrapped(column + static_cast<int>(nearest % 3) - 1);
    return {static_cast<std::uint32_t>(at), border, std::sqrt(least)};
  }

 private:
  int wrapped(int i) const { return (i % cells_ + cells_) % cells_; }
  // From (x, y) to the point of a cell.
  Point apart(int column, int row, float x, float y) const {
    const Point p = points_[static_cast<std::size_t>(wrapped(row) * cells_ + wrapped(column))];
    return {static_cast<float>(column) + p.x - x, static_cast<float>(row) + p.y - y};
  }

  int cells_;
  std::vector<Point> points_;
};

}  // namespace

std::vector<Cell> scatter_cells(
    const PatternSheet& sheet, std::string_view name, float size_mm, float jitter, float bend_mm) {
  // Fewer than four would meet themselves round the border.
  const int cells = std::max(4, sheet.count_of(size_mm));
  const PointGrid grid(cells, jitter, sheet.seed.child(name));
  const float scale = static_cast<float>(cells) / static_cast<float>(sheet.size_px);
  const float cell_mm = sheet.side_mm / static_cast<float>(cells);
  const TextureField bend_x = sheet.noise(std::string(name) + "-x", size_mm * 0.5F, 3);
  const TextureField bend_y = sheet.noise(std::string(name) + "-y", size_mm * 0.5F, 3);
  const float bend = 2 * bend_mm / cell_mm;
  const auto turn = static_cast<float>(cells);  // keeps coordinates positive; the grid repeats
  std::vector<Cell> field;
  field.reserve(sheet.look.mark.values.size());
  for (int y = 0; y < sheet.size_px; ++y) {
    for (int x = 0; x < sheet.size_px; ++x) {
      Cell cell =
          grid.at((static_cast<float>(x) + 0.5F) * scale + turn + (bend_x.row(y)[x] - 0.5F) * bend,
                  (static_cast<float>(y) + 0.5F) * scale + turn + (bend_y.row(y)[x] - 0.5F) * bend);
      cell.border_mm *= cell_mm;
      cell.middle_mm *= cell_mm;
      field.push_back(cell);
    }
  }
  return field;
}

}  // namespace marketgen::assets
