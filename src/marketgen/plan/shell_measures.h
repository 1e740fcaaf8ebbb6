// How a shop's walls, doors and windows are built: what a plan does not say of its shell.
//
// Pictures, physics and exports all build from these, so that what is seen is what is touched.
// Metres. A wall's inner face lies on the outline; its depths count from there outwards.
#pragma once
#include <algorithm>

#include "plan/plan.h"

namespace marketgen::plan {

// Masonry and insulated panels of shops: 0.2 m is the order of both; our own choice.
constexpr double wall_thickness_m = 0.2;
// Clear heights: automatic sliding doors of shops 2.2-2.5 m.
constexpr double door_height_m = 2.3, service_door_height_m = 2.1;
constexpr double window_sill_m = 0.9, window_top_m = 2.5;
constexpr double min_lintel_m = 0.25;  // openings end this far below the ceiling

// Depths of what closes an opening: frames of windows and sliding doors, and steel leaves. Our own
// choice: in the middle of the wall and nearer to its inner face.
constexpr double glazing_front_m = 0.05, glazing_back_m = 0.12;
constexpr double door_leaf_front_m = 0.04, door_leaf_back_m = 0.10;

// Height of an opening's upper edge over the floor.
constexpr double opening_top_m(OpeningKind kind, double ceiling_m) {
  const bool shop_door = kind == OpeningKind::entrance || kind == OpeningKind::exit;
  const double usual = kind == OpeningKind::window ? window_top_m
                       : shop_door                 ? door_height_m
                                                   : service_door_height_m;
  return std::min(usual, ceiling_m - min_lintel_m);
}
constexpr double opening_sill_m(OpeningKind kind) {
  return kind == OpeningKind::window ? window_sill_m : 0;
}

}  // namespace marketgen::plan
