// What panes of glass and the walls of clear packs mirror to the eye.
#pragma once
#include "render/sensor_shading.h"

namespace marketgen::raytrace {

// A dimmer highlight of a ceiling panel, as a share of white, needs no shadow ray. Those rays end
// so far before the ceiling.
constexpr float least_panel_share = 0.012F, shadow_end_m = 0.02F;

// Fills TilePane::light of the tile's panes and walls. Part of shade_tile().
void light_panes(const Lighting& lighting,
                 const View& view,
                 const SensorEffort& effort,
                 SensorTile& tile);

}  // namespace marketgen::raytrace
