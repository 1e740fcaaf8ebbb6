// What each pixel of a tile sees first: the surface behind any glass, and the glass before it.
#pragma once
#include <array>
#include <optional>

#include "render/film.h"
#include "render/render.h"
#include "render/tracing.h"
#include "render/view.h"

namespace marketgen::raytrace {

constexpr int tile_size = 16;
constexpr std::size_t tile_pixels = tile_size * tile_size;

// Panes between the eye and a surface.
struct GlassLayer {
  Surface pane;           // the nearest
  Vec3f transmittance;    // of all of them
  float reflectance = 0;  // of the nearest
};

struct FirstHit {
  Ray ray;
  Surface surface;  // valid when `any`
  bool any = false;
  std::optional<GlassLayer> glass;
};

struct Tile {
  int x0 = 0, y0 = 0, columns = 0, rows = 0;
  std::array<FirstHit, tile_pixels> hits;  // row-major, tile_size a row
  int x_of(std::size_t i) const { return x0 + static_cast<int>(i) % tile_size; }
  int y_of(std::size_t i) const { return y0 + static_cast<int>(i) / tile_size; }
  bool inside(std::size_t i) const {
    return static_cast<int>(i) % tile_size < columns && static_cast<int>(i) / tile_size < rows;
  }
};

int tiles_across(const View& view);
int tiles_down(const View& view);

// Fills tile number `index` (row by row) with the hits of rays through pixel centres that
// `opaque_mask` lets them meet.
void find_first_hits(
    const World& world, const View& view, int index, unsigned opaque_mask, Tile& tile);
// Writes geometry planes of the film, and the parts of the picture that need no light: albedo,
// reflectance, emission, glass.
void store_first_hits(const World& world, const View& view, const Tile& tile, Film& film);
// Of a surface that is no pane.
Matter matter_of(const World& world, const Surface& surface);
// The panes before `far` on a ray; nothing when there are none.
std::optional<GlassLayer> glass_before(const World& world, const Ray& ray, float far);

}  // namespace marketgen::raytrace
