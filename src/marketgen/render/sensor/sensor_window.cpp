#include "render/sensor/sensor_window.h"

#include <algorithm>
#include <bit>

namespace marketgen::render::raytrace {
namespace {

constexpr float window_plane_m = 0.006F, window_plane_per_m = 0.004F, window_facing = 0.85F;

}  // namespace

TileWindows::TileWindows(const SensorTile& tile) {
  for (std::size_t g = 0; g < sensor_tile_groups; ++g) {
    const std::size_t first = g * lane_count;
    const Surface8& s = tile.surface[g];
    s.position.x.store(&position_[0][first]);
    s.position.y.store(&position_[1][first]);
    s.position.z.store(&position_[2][first]);
    s.normal.x.store(&normal_[0][first]);
    s.normal.y.store(&normal_[1][first]);
    s.normal.z.store(&normal_[2][first]);
    tile.depth[g].store(&depth_[first]);
  }
}

float TileWindows::open_share(std::size_t i,
                              const TilePixels& sampled,
                              const TilePixels& blocked,
                              Window window) const {
  const WindowCorner corner(i, window);
  const int side = static_cast<int>(window);
  // Eight pixels of a row, of which the window has all or four.
  const int column = std::min(corner.column, sensor_tile_side - static_cast<int>(lane_count));
  const unsigned inside = ((1U << side) - 1) << (corner.column - column);
  const std::array<Float8, 3> normal{normal_[0][i], normal_[1][i], normal_[2][i]};
  const auto along = [&](const std::array<Numbers, 3>& of, std::size_t q) {
    return Float8::load(&of[0][q]) * normal[0] + Float8::load(&of[1][q]) * normal[1] +
           Float8::load(&of[2][q]) * normal[2];
  };
  const float here = position_[0][i] * normal_[0][i] + position_[1][i] * normal_[1][i] +
                     position_[2][i] * normal_[2][i];
  const Float8 plane = window_plane_m + window_plane_per_m * depth_[i];
  int count = 0, open = 0;
  for (int row = corner.row; row < corner.row + side; ++row) {
    const unsigned asked = sampled.eight(row, column) & inside;
    if (asked == 0) continue;
    const std::size_t q = SensorTile::number_of(column, row);
    const Float8 off = absolute(along(position_, q) - here);
    const unsigned counted =
        asked & ((along(normal_, q) >= Float8(window_facing)) & (plane >= off)).bits();
    count += std::popcount(counted);
    open += std::popcount(counted & ~blocked.eight(row, column));
  }
  return count > 0 ? static_cast<float>(open) / static_cast<float>(count) : 1;
}

}  // namespace marketgen::render::raytrace
