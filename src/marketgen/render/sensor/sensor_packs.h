// What sensor pictures show through clear packs: rays go on behind the wall that they met, bent and
// coloured by what fills the pack, to the first thing that is not clear.
//
// Depth, object numbers, normals and matter stay those of the wall, as a person would annotate
// them.
#pragma once
#include "render/sensor/sensor_tile.h"

namespace marketgen::render::raytrace {

// Replaces what the pixels of tile.walls show by what lies behind, with the colour that is left.
// Precondition: trace_tile(), and the tile's geometry is written: it is lost here.
void look_through_packs(const World& world,
                        const View& view,
                        const SensorDetail& detail,
                        SensorTile& tile);

}  // namespace marketgen::render::raytrace
