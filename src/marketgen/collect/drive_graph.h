// The floor of a store that is free for a robot that drives.
//
// Fixtures whose parts all hang over the robot are no obstacle; the others are their footprint.
// Store frame.
#pragma once
#include <vector>

#include "motion/plan_drive.h"
#include "scene/scene.h"

namespace marketgen::collect {

// Made once for a store and an envelope. `more`: obstacles beside the store's. Errors: those of
// VisibilityGraph::make.
Result<navigation::VisibilityGraph> drive_graph(const scene::Scene& scene,
                                                const motion::BaseEnvelope& envelope,
                                                const std::vector<RectMm>& more = {},
                                                double margin_m = 0.03);

// All of the floor that nothing up to such a height stands on: what may be seen across it. Errors:
// those of FreeSpace::make.
Result<navigation::FreeSpace> open_floor(const scene::Scene& scene, double height_m);
// The floor that nothing up to such a height stands on, m2.
double free_floor_m2(const scene::Scene& scene, double height_m);

}  // namespace marketgen::collect
