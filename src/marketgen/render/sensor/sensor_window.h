// The pattern that sensor pictures are sampled in, and windows over it.
//
// Every pixel of a 4 x 4 block has its own numbers, the same in all blocks: whatever window of that
// size is averaged, all sixteen are in it, and what is drawn has no noise.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

#include "render/sensor/sensor_tile.h"

namespace marketgen::render::raytrace {

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

// Its place in both.
inline std::size_t number_in_block(std::size_t i) {
  return static_cast<std::size_t>(SensorTile::row_of(i) % 4 * 4 + SensorTile::column_of(i) % 4);
}

// The 4 x 4 pixels around one, moved into the tile where they would stand over its edge.
struct WindowCorner {
  int column = 0, row = 0;
  explicit WindowCorner(std::size_t i)
      : column(std::clamp(SensorTile::column_of(i) - 2, 0, sensor_tile_side - 4)),
        row(std::clamp(SensorTile::row_of(i) - 2, 0, sensor_tile_side - 4)) {}
};

// A set of a tile's pixels.
class TilePixels {
 public:
  bool any() const {
    return std::any_of(rows_.begin(), rows_.end(), [](std::uint16_t row) { return row != 0; });
  }
  void add(std::size_t i) {
    rows_[static_cast<std::size_t>(SensorTile::row_of(i))] |=
        static_cast<std::uint16_t>(1U << SensorTile::column_of(i));
  }
  void set_group(std::size_t group, unsigned bits) {
    std::uint16_t& row = rows_[group / 2];
    const unsigned shift = group % 2 * lane_count;
    row = static_cast<std::uint16_t>((row & ~(255U << shift)) | bits << shift);
  }
  unsigned group(std::size_t g) const { return rows_[g / 2] >> g % 2 * lane_count & 255U; }
  // Bit k: column + k of that row.
  unsigned four(int row, int column) const {
    return static_cast<unsigned>(rows_[static_cast<std::size_t>(row)]) >> column & 15U;
  }
  // Whether one of the window around a pixel is in it.
  bool near(std::size_t i) const {
    const WindowCorner corner(i);
    unsigned rows = 0;
    for (int row = corner.row; row < corner.row + 4; ++row)
      rows |= four(row, corner.column);
    return rows != 0;
  }

 private:
  std::array<std::uint16_t, sensor_tile_side> rows_{};
};

// Averages over windows of the pixels that lie on the same face.
class TileWindows {
 public:
  // Takes over where the tile's faces lie.
  explicit TileWindows(const SensorTile& tile);

  // Share of a pixel's window that is not blocked, of what was sampled there; 1 where nothing was.
  float open_share(std::size_t i, const TilePixels& sampled, const TilePixels& blocked) const;

 private:
  using Numbers = std::array<float, sensor_tile_pixels>;
  alignas(32) std::array<Numbers, 3> position_, normal_;
  alignas(32) Numbers depth_;
};

}  // namespace marketgen::render::raytrace
