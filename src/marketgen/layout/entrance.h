// Beside doors: where units stand along their wall, and in whose zone.
#pragma once
#include <optional>

#include "layout/zone_build.h"

namespace marketgen::layout {

constexpr int reach_along_wall_mm = 6000;  // from a door: what is farther off is not found

// A unit beside the approach with its long side to the wall.
struct Stand {
  RectMm rect;
  Side front;
};

// The nearest free place along the door's wall, no farther than `reach_mm` from its approach.
// Trolleys are drawn out of the end of their bay, baskets are taken from the side that faces the
// shop.
std::optional<Stand> stand_beside(const Build& build,
                                  const Doorway& door,
                                  const ModuleSpec& spec,
                                  int reach_mm,
                                  bool low_side_first);

// The zone whose floor is nearest; null when no zone has any.
const ZoneBuild* nearest_zone(const Build& build, PointMm point);

}  // namespace marketgen::layout
