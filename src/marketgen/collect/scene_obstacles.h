// What stands round a robot in a store, as an arm planner sees it.
#pragma once
#include <cstdint>
#include <span>

#include "collect/goods_now.h"
#include "motion/collision_world.h"

namespace marketgen::collect {

// Shapes of the scene within `within_m` of `middle` (their boxes), store frame: fixtures, walls and
// floor. Doors and drawers as in the scene.
motion::Obstacles fixture_obstacles(const scene::Scene& scene, Vec3 middle, double within_m);

// The same for products, without the rows in `without`. Errors: assets.*.
Result<void> add_product_obstacles(const GoodsNow& goods,
                                   Vec3 middle,
                                   double within_m,
                                   std::span<const std::uint32_t> without,
                                   motion::Obstacles& obstacles);

}  // namespace marketgen::collect
