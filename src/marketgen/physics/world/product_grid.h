// Which products are near a place: their bounding boxes in a grid over the floor.
#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geometry/vector.h"

namespace marketgen::physics {

struct Box3 {
  Vec3 low, high;
  bool meets(const Box3& other, double within) const {
    return low.x <= other.high.x + within && other.low.x <= high.x + within &&
           low.y <= other.high.y + within && other.low.y <= high.y + within &&
           low.z <= other.high.z + within && other.low.z <= high.z + within;
  }
};

class ProductGrid {
 public:
  explicit ProductGrid(std::size_t products) : boxes_(products), present_(products, false) {}

  void put(std::uint32_t product, const Box3& box);  // moves it when it is there already
  void remove(std::uint32_t product);
  const Box3& box(std::uint32_t product) const { return boxes_[product]; }

  // Those whose boxes are within `within` of `box`, by row.
  std::vector<std::uint32_t> near(const Box3& box, double within) const;

 private:
  struct Cells {
    int x0, y0, x1, y1;
  };
  std::vector<std::uint32_t> near_by_row(const Box3& box, double within) const;
  static Cells cells_of(const Box3& box, double within);

  std::vector<Box3> boxes_;
  std::vector<bool> present_;
  std::unordered_map<std::int64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace marketgen::physics
