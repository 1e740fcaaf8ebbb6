// COL and OOB: items inside one another, items outside their place.
#pragma once
#include <cstdint>
#include <vector>

#include "base/result.h"
#include "geometry/mesh.h"
#include "scene/scene.h"

namespace marketgen {

constexpr double penetration_limit_m =
    0.001;  // deeper counts as a collision (SceneSmith's and SAGE's definition)

struct CollisionCount {
  std::uint64_t near_pairs = 0;  // pairs whose boxes are less than 5 mm apart
  std::uint64_t colliding_pairs = 0;
};
// Boxes filter (their overlap bounds the depth from above), MuJoCo measures what is left.
Result<CollisionCount> count_collisions(const Scene& scene, const std::vector<Bounds3>& bounds);

// Items more than 1 mm outside their shelf's width, depth or clearance, or outside the room; rows
// of scene.products.
std::vector<std::uint32_t> items_out_of_place(const Scene& scene,
                                              const std::vector<Bounds3>& bounds);

}  // namespace marketgen
