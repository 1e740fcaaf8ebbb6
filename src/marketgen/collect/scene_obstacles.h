// What stands round a robot in a store, as an arm planner sees it.
#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "collect/goods_now.h"
#include "motion/collision_world.h"

namespace marketgen::collect {

// Shapes within `within_m` of `middle` (their boxes), store frame: fixtures, walls and floor. Doors
// and drawers are where their joints are now. Without what hangs on the joint `without`.
motion::Obstacles fixture_obstacles(const GoodsNow& store,
                                    Vec3 middle,
                                    double within_m,
                                    std::optional<std::uint32_t> without = {});

// The same for products, without the rows in `without`. Errors: assets.*.
Result<void> add_product_obstacles(const GoodsNow& goods,
                                   Vec3 middle,
                                   double within_m,
                                   std::span<const std::uint32_t> without,
                                   motion::Obstacles& obstacles);

}  // namespace marketgen::collect
