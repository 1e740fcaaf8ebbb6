// Edges of a sensor picture made smooth: pixels whose neighbours show something else get more rays.
//
// The light found for the pixels around is used again: a new ray asks for the surface alone.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "render/sensor/sensor_shading.h"

namespace marketgen::render::raytrace {

// What is kept of the shaded tiles of one picture, row by row. Rows are as long as whole tiles.
struct SensorPlanes {
  using Floats = std::vector<float>;
  using Halves = std::vector<std::uint16_t>;
  std::size_t stride = 0;
  std::array<Floats, 3> radiance, position;
  std::vector<std::uint32_t> number;  // Frame::instance
  std::vector<std::uint32_t> normal;  // three signed bytes; the fourth: whether a pane is before it
  std::array<Halves, 3> irradiance, gloss;       // with contact shadows; mirror side
  std::array<Halves, 3> transmittance, overlay;  // of the panes before it, where there are

  void resize(const View& view);
  void take(const World& world, const SensorTile& tile);
  // Where pixel number `i` of a tile is kept.
  std::size_t place_of(const SensorTile& tile, std::size_t i) const {
    return static_cast<std::size_t>(tile.y0 + SensorTile::row_of(i)) * stride +
           static_cast<std::size_t>(tile.x0 + SensorTile::column_of(i));
  }
};

// Pictures are resolved in strips of so many rows.
constexpr int sensor_strip_rows = 4;
inline int sensor_strips(const View& view) {
  return (view.height() + sensor_strip_rows - 1) / sensor_strip_rows;
}
// Writes colour of strip number `index` to the picture's `rgb`. Precondition: all tiles were taken.
void resolve_strip(const Lighting& lighting,
                   const View& view,
                   const SensorEffort& effort,
                   const SensorPlanes& planes,
                   int index,
                   std::uint8_t* rgb);

}  // namespace marketgen::render::raytrace
