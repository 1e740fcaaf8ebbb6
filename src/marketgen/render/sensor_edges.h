// Edges of a sensor picture made smooth: pixels whose neighbours show something else get more rays.
//
// The light found for the pixels around is used again: a new ray asks for the surface alone.
#pragma once
#include <cstdint>
#include <vector>

#include "render/sensor_shading.h"

namespace marketgen::raytrace {

// What is kept of the shaded tiles of one picture, row by row.
struct SensorPlanes {
  int width = 0, height = 0;
  std::vector<Float4> radiance;
  std::vector<Float4> position;       // of what is seen; fourth lane: its number, as bits
  std::vector<std::uint32_t> normal;  // packed_normal()
  std::vector<std::uint64_t> irradiance, gloss;       // halves: with contact shadows; mirror side
  std::vector<std::uint64_t> transmittance, overlay;  // halves: of panes before it

  void resize(int w, int h);
  void take(const World& world, const SensorTile& tile);
};

// Writes colour of tile number `index` to the picture's `rgb`. Precondition: all tiles were taken.
void resolve_tile(const Lighting& lighting,
                  const View& view,
                  const SensorEffort& effort,
                  const SensorPlanes& planes,
                  int index,
                  std::uint8_t* rgb);

}  // namespace marketgen::raytrace
