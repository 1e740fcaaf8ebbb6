// The pattern that sensor pictures are sampled in, and windows over it.
//
// Every pixel of a 4 x 4 block has its own numbers, the same in all blocks: whatever window of that
// size is averaged, all sixteen are in it, and what is drawn has no noise.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

#include "render/sensor_tile.h"

namespace marketgen::raytrace {

// One number in [0, 1) for each pixel of a 4 x 4 block, two ways: each 2 x 2 quarter is stratified
// by itself (bit-reversed order, and the same turned).
inline constexpr std::array<float, 16> first_numbers = {0.5F / 16,
                                                        8.5F / 16,
                                                        2.5F / 16,
                                                        10.5F / 16,
                                                        12.5F / 16,
                                                        4.5F / 16,
                                                        14.5F / 16,
                                                        6.5F / 16,
                                                        3.5F / 16,
                                                        11.5F / 16,
                                                        1.5F / 16,
                                                        9.5F / 16,
                                                        15.5F / 16,
                                                        7.5F / 16,
                                                        13.5F / 16,
                                                        5.5F / 16};
inline constexpr std::array<float, 16> second_numbers = {0.5F / 16,
                                                         13.5F / 16,
                                                         10.5F / 16,
                                                         7.5F / 16,
                                                         4.5F / 16,
                                                         1.5F / 16,
                                                         14.5F / 16,
                                                         11.5F / 16,
                                                         8.5F / 16,
                                                         5.5F / 16,
                                                         2.5F / 16,
                                                         15.5F / 16,
                                                         12.5F / 16,
                                                         9.5F / 16,
                                                         6.5F / 16,
                                                         3.5F / 16};

// Calls body(pixel) for the 4 x 4 pixels around one, moved into the tile where they would stand
// over its edge.
struct WindowCorner {
  int column = 0, row = 0;
  explicit WindowCorner(std::size_t i)
      : column(std::clamp(SensorTile::column_of(i) - 2, 0, sensor_tile_side - 4)),
        row(std::clamp(SensorTile::row_of(i) - 2, 0, sensor_tile_side - 4)) {}
};
template <class Body>
void for_window(std::size_t i, const Body& body) {
  const WindowCorner corner(i);
  for (int y = corner.row; y < corner.row + 4; ++y) {
    for (int x = corner.column; x < corner.column + 4; ++x)
      body(SensorTile::number_of(x, y));
  }
}

// A set of a tile's pixels.
class TilePixels {
 public:
  void add(std::size_t i) {
    rows_[static_cast<std::size_t>(SensorTile::row_of(i))] |=
        static_cast<std::uint16_t>(1U << SensorTile::column_of(i));
  }
  bool has(std::size_t i) const {
    return (rows_[static_cast<std::size_t>(SensorTile::row_of(i))] >> SensorTile::column_of(i) &
            1) != 0;
  }
  // Whether one of the window around a pixel is in it.
  bool near(std::size_t i) const {
    const WindowCorner corner(i);
    const auto row = static_cast<std::size_t>(corner.row);
    const unsigned rows =
        static_cast<unsigned>(rows_[row]) | rows_[row + 1] | rows_[row + 2] | rows_[row + 3];
    return (rows >> corner.column & 15U) != 0;
  }

 private:
  std::array<std::uint16_t, sensor_tile_side> rows_{};
};

}  // namespace marketgen::raytrace
