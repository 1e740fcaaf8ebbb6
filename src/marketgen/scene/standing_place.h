// Where a robot's base stands before a shelf that it reaches into.
#pragma once
#include <cstdint>

#include "scene/scene.h"

namespace marketgen::scene {

constexpr int standing_mm = 700;  // base centre before the shelf's edge (arms reach 0.60-0.80 m)
constexpr int standing_reach_mm = 250;  // how far from that point it may stand

// Store frame.
PointMm standing_point(const Scene& scene, std::uint32_t shelf);

}  // namespace marketgen::scene
