// What the pixels of one tile of a sensor picture see: first hits, panes before them, and the light
// that reaches them. Filled step by step: trace_tile() here, then sensor_shading.h.
//
// Pixels lie row by row: number = 16 * row + column. Eight neighbours in a row are a group, worked
// on side by side: group = number / 8.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

#include "render/cameras/view.h"
#include "render/sensor/surface8.h"

namespace marketgen::render::raytrace {

constexpr int sensor_tile_side = 16;
constexpr std::size_t sensor_tile_pixels = sensor_tile_side * sensor_tile_side;
constexpr std::size_t sensor_tile_groups = sensor_tile_pixels / lane_count;

// What is clear between the eye and what a pixel shows: panes of glass, or a clear pack.
struct TilePane {
  std::uint16_t pixel = 0;
  std::uint32_t instance = 0;  // of a pack: its row in World::instances
  Surface first;               // the nearest pane, or the pack's wall
  Vec3f transmittance;         // of all of them
  Vec3f mirror;                // where the nearest mirrors to
  float reflected = 0;         // share that it mirrors
  Vec3f light;                 // that the eye sees in it
};

// One value for each of a tile's pixels.
using TileFloats = std::array<Float8, sensor_tile_groups>;
using TileVectors = std::array<Vec8, sensor_tile_groups>;

struct SensorTile {
  int x0 = 0, y0 = 0, columns = 0, rows = 0;  // columns and rows lie inside the picture
  std::size_t pane_count = 0, wall_count = 0;
  TileFloats depth;  // along the optical axis; 0: nothing was hit
  TileVectors direction;
  std::array<Surface8, sensor_tile_groups> surface;  // means something where something was hit
  std::array<TilePane, sensor_tile_pixels> panes;    // the first `pane_count`
  std::array<TilePane, sensor_tile_pixels> walls;    // of clear packs; the first `wall_count`
  std::array<std::int16_t, sensor_tile_pixels> pane_of, wall_of;  // indices; -1 = none
  // Light: on the surface (diffuse), and from its mirror side.
  TileVectors irradiance, gloss;
  TileFloats openness;  // 0..1: what contact shadows leave of irradiance

  static int column_of(std::size_t i) { return static_cast<int>(i % sensor_tile_side); }
  static int row_of(std::size_t i) { return static_cast<int>(i / sensor_tile_side); }
  static std::size_t number_of(int column, int row) {
    return static_cast<std::size_t>(row * sensor_tile_side + column);
  }

  Surface surface_of(std::size_t i) const {
    return surface_in(surface[i / lane_count], i % lane_count);
  }
  Vec3f direction_of(std::size_t i) const {
    return lane(direction[i / lane_count], i % lane_count);
  }
  bool inside(std::size_t i) const { return column_of(i) < columns && row_of(i) < rows; }
  // Lanes of a group that lie in the picture and show something.
  unsigned lit(std::size_t group) const {
    return (depth[group] > Float8()).bits() & inside_of(group);
  }
  // The wall that the left upper one of 2 x 2 pixels shows, where it is the same as `wall`; else
  // `wall` itself.
  const TilePane& model_of(const TilePane& wall) const;
  // Lanes of a group that look through a clear pack.
  unsigned walled(std::size_t group) const {
    unsigned lanes = 0;
    for (std::size_t k = 0; wall_count > 0 && k < lane_count; ++k)
      lanes |= (wall_of[group * lane_count + k] >= 0 ? 1U : 0U) << k;
    return lanes;
  }
  unsigned inside_of(std::size_t group) const {
    const int first = static_cast<int>(group % 2 * lane_count);
    if (static_cast<int>(group / 2) >= rows) return 0;
    return (1U << std::clamp(columns - first, 0, static_cast<int>(lane_count))) - 1;
  }
  // Calls body(group, its first pixel's place in the picture, count) for each group, as far as it
  // lies inside a picture of this width.
  template <class Body>
  void for_groups(int width, const Body& body) const {
    for (std::size_t g = 0; g < sensor_tile_groups; ++g) {
      const int row = static_cast<int>(g / 2), column = static_cast<int>(g % 2 * lane_count);
      if (row >= rows || column >= columns) continue;
      const auto place = static_cast<std::size_t>(y0 + row) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(x0 + column);
      body(g, place, std::min(lane_count, static_cast<std::size_t>(columns - column)));
    }
  }
};

// Calls body(lane) for each set bit.
template <class Body>
void for_lanes(unsigned bits, const Body& body) {
  for (; bits != 0; bits &= bits - 1)
    body(static_cast<std::size_t>(std::countr_zero(bits)));
}

// What may be met and how finely it is looked at.
struct SensorDetail {
  unsigned opaque_mask = mask_opaque;
  TextureDetail textures = TextureDetail::full;
  int packs_deep = 2;        // clear packs looked through one after another; 0: taken for opaque
  bool share_packs = false;  // a quarter of the pixels look, for their neighbours too
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

}  // namespace marketgen::render::raytrace
