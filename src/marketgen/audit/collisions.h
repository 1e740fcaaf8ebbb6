// COL and OOB: items inside one another, items outside their place.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "base/result.h"
#include "geometry/mesh.h"
#include "physics/settle/penetration.h"
#include "scene/scene.h"

namespace marketgen::audit {

struct DeepPair {
  physics::ProductPair items;
  double depth_m = 0;
};

struct CollisionCount {
  std::uint64_t near_pairs = 0;  // pairs whose boxes are less than 5 mm apart
  std::uint64_t colliding_pairs = 0;
  std::optional<DeepPair> deepest;  // of those that collide
};
// Boxes filter (their overlap bounds the depth from above), MuJoCo measures what is left.
Result<CollisionCount> count_collisions(const scene::Scene& scene,
                                        const std::vector<Bounds3>& bounds);

// Items more than 1 mm outside their shelf's width, depth or clearance, or outside the room; rows
// of scene.products.
std::vector<std::uint32_t> items_out_of_place(const scene::Scene& scene,
                                              const std::vector<Bounds3>& bounds);

}  // namespace marketgen::audit
