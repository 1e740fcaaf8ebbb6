#include "geometry/weld.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/flat_index.h"

namespace marketgen {
inline namespace geometry {
namespace {

using Cell = std::array<std::int64_t, 3>;

Cell cell_at(Vec3 p, double cell_size) {
  return {static_cast<std::int64_t>(std::floor(p.x / cell_size)),
          static_cast<std::int64_t>(std::floor(p.y / cell_size)),
          static_cast<std::int64_t>(std::floor(p.z / cell_size))};
}

bool within(Vec3 a, Vec3 b, double distance) {
  return std::abs(a.x - b.x) <= distance && std::abs(a.y - b.y) <= distance &&
         std::abs(a.z - b.z) <= distance;
}

// Positions by the cell they lie in. A cell is wider than the search cube, so one to eight cells
// hold all neighbours.
class CellIndex {
 public:
  CellIndex(const std::vector<Vec3f>& positions, double distance)
      : positions_(positions),
        distance_(distance),
        cell_size_(16.0 * distance),
        first_in_(positions.size()),
        next_(positions.size(), none) {}

  void add(std::uint32_t i) {
    auto [first, is_new] = first_in_.try_emplace(cell_at(to_double(positions_[i]), cell_size_), i);
    if (is_new) return;
    next_[i] = first;
    first = i;
  }

  // The lowest index within the distance of position i among those added; i itself when there is
  // none.
  std::uint32_t lowest_near(std::uint32_t i) const {
    const Vec3 p = to_double(positions_[i]), reach{distance_, distance_, distance_};
    const Cell low = cell_at(p - reach, cell_size_), high = cell_at(p + reach, cell_size_);
    std::uint32_t lowest = i;
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z)
          lowest = std::min(lowest, lowest_in({x, y, z}, p, lowest));
      }
    }
    return lowest;
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  std::uint32_t lowest_in(const Cell& cell, Vec3 p, std::uint32_t lowest) const {
    const std::uint32_t* first = first_in_.find(cell);
    if (first == nullptr) return lowest;
    for (std::uint32_t i = *first; i != none; i = next_[i]) {
      if (i < lowest && within(p, to_double(positions_[i]), distance_)) lowest = i;
    }
    return lowest;
  }

  const std::vector<Vec3f>& positions_;
  double distance_, cell_size_;
  FlatIndex<Cell> first_in_;
  std::vector<std::uint32_t> next_;  // in the same cell
};

}  // namespace

std::vector<std::uint32_t> weld_positions(const std::vector<Vec3f>& positions, double distance) {
  CellIndex kept(positions, distance);
  std::vector<std::uint32_t> lowest(positions.size());
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    lowest[i] = kept.lowest_near(i);
    if (lowest[i] == i) kept.add(i);
  }
  return lowest;
}

}  // namespace geometry
}  // namespace marketgen
