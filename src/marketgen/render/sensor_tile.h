// What the pixels of one tile of a sensor picture see: first hits, panes before them, and the light
// that reaches them. Filled step by step: trace_tile() here, then sensor_shading.h.
//
// Pixels lie in blocks of 4 x 4, the packets that are traced together: number = 16 * block + lane.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

#include "render/tracing.h"
#include "render/view.h"

namespace marketgen::raytrace {

constexpr int sensor_tile_side = 16, sensor_block_side = 4;
constexpr std::size_t sensor_tile_pixels = sensor_tile_side * sensor_tile_side;

// Panes of glass between the eye and what a pixel shows.
struct TilePane {
  std::uint16_t pixel = 0;
  Surface first;        // the nearest pane
  Vec3f transmittance;  // of all of them
  float reflected = 0;  // share that the nearest mirrors
};

struct SensorTile {
  int x0 = 0, y0 = 0, columns = 0, rows = 0;  // columns and rows lie inside the picture
  std::size_t pane_count = 0;
  std::array<float, sensor_tile_pixels> depth;  // along the optical axis; 0: nothing was hit
  std::array<Vec3f, sensor_tile_pixels> direction;
  std::array<Surface, sensor_tile_pixels> surface;       // valid where something was hit
  std::array<TilePane, sensor_tile_pixels> panes;        // the first `pane_count`
  std::array<std::int16_t, sensor_tile_pixels> pane_of;  // index into panes, -1 = none
  // Light: on the surface (diffuse), from its mirror side, and what panes mirror.
  std::array<Vec3f, sensor_tile_pixels> irradiance, gloss, overlay;
  std::array<float, sensor_tile_pixels> openness;  // 0..1: what contact shadows leave of irradiance

  static int column_of(std::size_t i) {
    return static_cast<int>(i / 16 % 4 * sensor_block_side + i % sensor_block_side);
  }
  static int row_of(std::size_t i) {
    return static_cast<int>(i / 64 * sensor_block_side + i / sensor_block_side % 4);
  }
  static std::size_t number_of(int column, int row) {
    return static_cast<std::size_t>((row / 4 * 4 + column / 4) * 16 + row % 4 * 4 + column % 4);
  }
  // Calls body(first pixel's number in the tile, its place in the picture, count) for each row of
  // each block, as far as it lies inside a picture of this width.
  template <class Body>
  void for_runs(int width, const Body& body) const {
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns; x += sensor_block_side) {
        const auto place = static_cast<std::size_t>(y0 + y) * static_cast<std::size_t>(width) +
                           static_cast<std::size_t>(x0 + x);
        body(number_of(x, y),
             place,
             static_cast<std::size_t>(std::min(sensor_block_side, columns - x)));
      }
    }
  }
  bool inside(std::size_t i) const { return column_of(i) < columns && row_of(i) < rows; }
  bool lit(std::size_t i) const { return depth[i] > 0 && inside(i); }
};

// What may be met and how finely it is looked at.
struct SensorDetail {
  unsigned opaque_mask = mask_opaque;
  TextureDetail textures = TextureDetail::full;
};

// Fills everything but the light of tile number `index` (row by row).
void trace_tile(
    const World& world, const View& view, int index, const SensorDetail& detail, SensorTile& tile);

inline int sensor_tiles_across(const View& view) {
  return (view.width() + sensor_tile_side - 1) / sensor_tile_side;
}
inline int sensor_tiles_down(const View& view) {
  return (view.height() + sensor_tile_side - 1) / sensor_tile_side;
}

}  // namespace marketgen::raytrace
