// A part of a store as a scene of its own.
#pragma once
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace marketgen::scene {

// These fixtures (rows, ascending) with all that is on them, in the whole room: its shell, look,
// zones, aisles and materials stay. Of the catalogue, what is left of the goods. Products of no
// facing (scene/placements.h) stay where they lie within the footprint of a fixture that stays.
// Violations are of the whole store, and go. Everything keeps its order and stands where it stood.
Scene cropped(const Scene& scene, const std::vector<std::uint32_t>& fixtures);

}  // namespace marketgen::scene
