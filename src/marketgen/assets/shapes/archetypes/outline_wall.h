// Upright walls over a closed outline: the film of multipacks, a wedge of cheese.
#pragma once
#include <vector>

#include "assets/shapes/archetypes/pack_builder.h"

namespace marketgen::assets {

// A point of the outline with the direction outwards; `along` counts metres from the side's start.
struct OutlinePoint {
  Vec2f at, out;
  float along = 0;
};

// A stretch of the outline, ending where the next begins, counter-clockwise seen from above.
struct OutlineSide {
  std::vector<OutlinePoint> points;
  const Panel* panel = nullptr;  // of its printed levels
};
void measure(OutlineSide& side);  // sets `along`

// A level of the wall: drawn in by `inset_m`. The surface is that of the band that starts here, of
// the cover for the last.
struct WallLevel {
  float z = 0, inset_m = 0;
  std::uint16_t surface = 0;
};

// Closed at both ends by flat covers about `middle`, from which the whole outline must be seen.
// Printed levels must follow one another; v runs from 0 at the highest to 1 at the lowest.
void add_outline_wall(PackBuilder& pack,
                      const std::vector<OutlineSide>& sides,
                      const std::vector<WallLevel>& levels,
                      Vec2f middle = {});

}  // namespace marketgen::assets
