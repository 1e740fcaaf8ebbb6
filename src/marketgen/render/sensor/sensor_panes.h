// What panes of glass and the walls of clear packs mirror to the eye.
#pragma once
#include "render/sensor/sensor_shading.h"

namespace marketgen::render::raytrace {

// A dimmer highlight of a ceiling panel, as a share of white, needs no shadow ray. Those rays end
// so far before the ceiling.
constexpr float min_panel_share = 0.012F, shadow_end_m = 0.02F;

// Fills TilePane::light of the tile's panes and walls. Part of shade_tile().
void light_panes(const Lighting& lighting,
                 const View& view,
                 const SensorEffort& effort,
                 SensorTile& tile);

// Packs are opaque to stored light. What a clear one lets in besides, to a surface facing `normal`
// that is seen through it: as much as there is more light before the pack than `behind` it, as far
// as that gets through. Nothing for pixels that look through none.
Vec3f light_let_in(const Lighting& lighting,
                   const SensorTile& tile,
                   std::size_t pixel,
                   Vec3f normal,
                   Vec3f behind);

}  // namespace marketgen::render::raytrace
