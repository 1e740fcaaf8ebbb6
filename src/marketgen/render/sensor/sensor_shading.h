// Light on a tile of a sensor picture, without noise: stored irradiance, panels mirrored in gloss,
// mirror rays on polished floors and panes, contact shadows.
//
// Deterministic by construction: what is sampled is sampled in a fixed pattern of 4 x 4 pixels, and
// averaged over windows of that size.
#pragma once
#include "render/light/stored_light.h"
#include "render/sensor/sensor_tile.h"

namespace marketgen::render::raytrace {

// What a picture is made with beside its first hits.
struct SensorEffort {
  SensorDetail detail;
  bool mirror_panes = true;   // by a ray; else stored light stands for what they mirror
  bool mirror_floor = false;  // polished, by rays; else stored light and panels
  bool panel_shadows = true;  // whether something hides the panels that gloss would mirror
  bool contact_shadows = true;
  bool all_contact_pixels = false;  // else every other pixel
  int edge_samples = 2;             // more, on pixels with an edge
  Vec3f light{1, 1, 1};             // RenderOptions::light
};

// Fills the tile's light: irradiance, gloss, overlay, openness. Precondition: trace_tile().
void shade_tile(const Lighting& lighting,
                const View& view,
                const SensorEffort& effort,
                SensorTile& tile);

// Radiance of a group of a shaded tile, and of any surfaces lit as pixels are.
Vec8 radiance_of(const World& world, const SensorTile& tile, std::size_t group);
Vec8 lit_radiance(const Surface8& surfaces,
                  const Vec8& direction,
                  const Vec8& irradiance,
                  const Vec8& gloss);

}  // namespace marketgen::render::raytrace
