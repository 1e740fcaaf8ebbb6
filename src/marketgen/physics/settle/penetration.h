// How far two items are inside each other, measured by MuJoCo's collision code and not by ours.
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"

namespace marketgen::physics {

constexpr double penetration_limit_m =
    0.001;  // deeper counts as a collision (SceneSmith's and SAGE's definition)

using ProductPair = std::pair<std::uint32_t, std::uint32_t>;  // rows of scene.products

// Depth in metres for every pair, 0 when apart. Errors: physics.failed, assets.*.
Result<std::vector<double>> penetration_depths(const scene::Scene& scene,
                                               const std::vector<ProductPair>& pairs);

}  // namespace marketgen::physics
