#include "physics/world/product_grid.h"

#include <algorithm>
#include <cmath>

namespace marketgen::physics {
namespace {

constexpr double cell_m = 0.3;     // a few facings wide
constexpr double max_cells = 1e6;  // far outside any store: keeps the indices small

int cell(double at) {
  return static_cast<int>(std::floor(std::clamp(at / cell_m, -max_cells, max_cells)));
}
std::int64_t key(int x, int y) {
  return (std::int64_t{x} << 32) ^ static_cast<std::uint32_t>(y);
}

}  // namespace

ProductGrid::Cells ProductGrid::cells_of(const Box3& box, double within) {
  return {cell(box.low.x - within),
          cell(box.low.y - within),
          cell(box.high.x + within),
          cell(box.high.y + within)};
}

void ProductGrid::put(std::uint32_t product, const Box3& box) {
  remove(product);
  boxes_[product] = box;
  present_[product] = true;
  const Cells c = cells_of(box, 0);
  for (int x = c.x0; x <= c.x1; ++x) {
    for (int y = c.y0; y <= c.y1; ++y)
      cells_[key(x, y)].push_back(product);
  }
}

void ProductGrid::remove(std::uint32_t product) {
  if (!present_[product]) return;
  present_[product] = false;
  const Cells c = cells_of(boxes_[product], 0);
  for (int x = c.x0; x <= c.x1; ++x) {
    for (int y = c.y0; y <= c.y1; ++y)
      std::erase(cells_[key(x, y)], product);
  }
}

// For boxes of more cells than there are products.
std::vector<std::uint32_t> ProductGrid::near_by_row(const Box3& box, double within) const {
  std::vector<std::uint32_t> found;
  for (std::uint32_t product = 0; product < boxes_.size(); ++product) {
    if (present_[product] && boxes_[product].meets(box, within)) found.push_back(product);
  }
  return found;
}

std::vector<std::uint32_t> ProductGrid::near(const Box3& box, double within) const {
  std::vector<std::uint32_t> found;
  const Cells c = cells_of(box, within);
  const double cells = (c.x1 - c.x0 + 1.0) * (c.y1 - c.y0 + 1.0);
  if (cells > static_cast<double>(boxes_.size())) return near_by_row(box, within);
  for (int x = c.x0; x <= c.x1; ++x) {
    for (int y = c.y0; y <= c.y1; ++y) {
      const auto at = cells_.find(key(x, y));
      if (at == cells_.end()) continue;
      for (const std::uint32_t product : at->second) {
        if (boxes_[product].meets(box, within)) found.push_back(product);
      }
    }
  }
  std::ranges::sort(found);
  found.erase(std::ranges::unique(found).begin(), found.end());
  return found;
}

}  // namespace marketgen::physics
