#include "render/sensor/sensor_window.h"

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
  const auto along = [&](const std::array<Numbers, 3>& of, std::size_t q) {
    __m128 sum = _mm_setzero_ps();
    for (std::size_t c = 0; c < 3; ++c)
      sum = _mm_add_ps(sum, _mm_mul_ps(_mm_loadu_ps(&of[c][q]), _mm_set1_ps(normal_[c][i])));
    return sum;
  };
  const float here = position_[0][i] * normal_[0][i] + position_[1][i] * normal_[1][i] +
                     position_[2][i] * normal_[2][i];
  const __m128 plane = _mm_set1_ps(window_plane_m + window_plane_per_m * depth_[i]);
  int count = 0, open = 0;
  for (int part = 0; part < side * side / 4; ++part) {  // four pixels of a row
    const int row = corner.row + part % side, column = corner.column + part / side * 4;
    const unsigned asked = sampled.four(row, column);
    if (asked == 0) continue;
    const std::size_t q = SensorTile::number_of(column, row);
    const __m128 off =
        _mm_andnot_ps(_mm_set1_ps(-0.0F), _mm_sub_ps(along(position_, q), _mm_set1_ps(here)));
    const __m128 alike = _mm_and_ps(_mm_cmpge_ps(along(normal_, q), _mm_set1_ps(window_facing)),
                                    _mm_cmple_ps(off, plane));
    const unsigned counted = asked & static_cast<unsigned>(_mm_movemask_ps(alike));
    count += std::popcount(counted);
    open += std::popcount(counted & ~blocked.four(row, column));
  }
  return count > 0 ? static_cast<float>(open) / static_cast<float>(count) : 1;
}

}  // namespace marketgen::render::raytrace
