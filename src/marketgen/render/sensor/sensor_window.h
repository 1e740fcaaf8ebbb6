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

// Pixels a side. A wide window has four numbers for each of a narrow one's: see wide_numbers().
enum class Window { narrow = 4, wide = 8 };

// The same for each pixel of an 8 x 8 block: the pair of its place in a 4 x 4 block, aside by what
// is different in each of the four.
inline std::array<float, 2> wide_numbers(std::size_t i) {
  constexpr std::array<float, 4> first_aside{-1.5F / 64, 0.5F / 64, 1.5F / 64, -0.5F / 64},
      second_aside{0.5F / 64, 1.5F / 64, -0.5F / 64, -1.5F / 64};
  const auto quarter = static_cast<std::size_t>(SensorTile::row_of(i) / 4 % 2 * 2 +
                                                SensorTile::column_of(i) / 4 % 2);
  const std::size_t number = number_in_block(i);
  return {first_numbers[number] + first_aside[quarter],
          second_numbers[number] + second_aside[quarter]};
}

// The pixels around one, moved into the tile where they would stand over its edge.
struct WindowCorner {
  int column = 0, row = 0;
  explicit WindowCorner(std::size_t i, Window window = Window::narrow)
      : column(inside(SensorTile::column_of(i), static_cast<int>(window))),
        row(inside(SensorTile::row_of(i), static_cast<int>(window))) {}

 private:
  static int inside(int place, int side) {
    return std::clamp(place - side / 2, 0, sensor_tile_side - side);
  }
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
  // The same for eight.
  unsigned eight(int row, int column) const {
    return static_cast<unsigned>(rows_[static_cast<std::size_t>(row)]) >> column & 255U;
  }
  // Whether one of the window around a pixel is in it.
  bool near(std::size_t i, Window window) const {
    const WindowCorner corner(i, window);
    const int side = static_cast<int>(window);
    unsigned rows = 0;
    for (int row = corner.row; row < corner.row + side; ++row)
      rows |= static_cast<unsigned>(rows_[static_cast<std::size_t>(row)]) >> corner.column;
    return (rows & ((1U << side) - 1)) != 0;
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
  float open_share(std::size_t i,
                   const TilePixels& sampled,
                   const TilePixels& blocked,
                   Window window = Window::narrow) const;

 private:
  using Numbers = std::array<float, sensor_tile_pixels>;
  alignas(32) std::array<Numbers, 3> position_, normal_;
  alignas(32) Numbers depth_;
};

}  // namespace marketgen::render::raytrace
