// What stands in the way of a robot that drives over the floor.
#pragma once
#include <vector>

#include "scene/scene.h"

namespace marketgen::scene {

// Fixtures of which some part is lower than `height_m`, in the layout's order: those that hang over
// a robot of that height are no obstacle. In the way is all of their footprint.
std::vector<layout::Fixture> fixtures_below(const Scene& scene, double height_m);

}  // namespace marketgen::scene
