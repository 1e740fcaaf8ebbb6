// Heaps of loose goods: settled once in MuJoCo (`marketgen assets heaps`), kept as rows of
// data/heaps.json, cut to measure when a shelf is filled.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/fields.h"
#include "geometry/pose.h"

namespace marketgen::catalog {

// One for each shape and size. Its frame: X along the shelf, Y away from the shopper, Z up, the
// origin at the corner of the footprint.
struct HeapRow {
  std::string archetype;
  std::array<int, 3> size_mm{};
  int width_mm = 0, depth_mm = 0;
  // Seven numbers a piece, the lowest piece first: x, y, z of the product's origin in 0.1 mm, then
  // w, x, y, z of its rotation in 1/10,000.
  std::vector<int> poses;
  // What each piece lies on: how many pieces, then which; the board carries those with none.
  std::vector<int> supports;

  static constexpr auto fields = field_list(
      field("archetype", &HeapRow::archetype, "shape of the pieces", identifier(), required()),
      field("size_mm", &HeapRow::size_mm, "width, depth, height of a piece", required()),
      field("width_mm", &HeapRow::width_mm, "of the footprint", range(1, 10000), required()),
      field("depth_mm", &HeapRow::depth_mm, "of the footprint", range(1, 10000), required()),
      field("poses", &HeapRow::poses, "x y z in 0.1 mm, w x y z in 1/10,000, a piece", required()),
      field("supports", &HeapRow::supports, "count and numbers of the pieces below", required()));
};

struct HeapPiece {
  Pose pose;  // heap_from_product
  std::vector<std::uint32_t> lies_on;
};

// The row as pieces; empty when its numbers do not fit together.
std::vector<HeapPiece> pieces_of(const HeapRow& row);
// The other way round. `lies_on` must name earlier pieces.
HeapRow heap_row(const std::string& archetype,
                 const std::array<int, 3>& size_mm,
                 const std::array<int, 2>& footprint_mm,
                 const std::vector<HeapPiece>& pieces);

}  // namespace marketgen::catalog
