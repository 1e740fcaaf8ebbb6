#include "physics/settle/let_go.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/interrupt.h"
#include "physics/goods/contact_shape.h"
#include "physics/world/store_model.h"
#include "physics/world/world.h"
#include "scene/placements.h"

namespace marketgen::physics {
namespace {

// Bodies for what stands beside the region and is pushed.
constexpr int neighbours = 64;
constexpr int steps_at_once = 25;  // between looks whether someone wants it to end

Result<std::vector<std::uint32_t>> rows_in(const scene::Scene& scene,
                                           const std::array<double, 4>& region_m) {
  const auto& [x0, y0, x1, y1] = region_m;
  std::vector<std::uint32_t> rows;
  for (std::uint32_t row = 0; row < scene.products.size(); ++row) {
    const Vec3 p = scene::world_from_product(scene.products[row]).position;
    if (p.x >= x0 && p.x <= x1 && p.y >= y0 && p.y <= y1) rows.push_back(row);
  }
  if (rows.size() > max_pool)
    return Error{"physics.bad_command",
                 "region",
                 fmt::format("{} products stand there; at most {} can move at once: take a "
                             "smaller region",
                             rows.size(),
                             max_pool)};
  return rows;
}

WorldOptions world_for(int count, const LetGoOptions& options) {
  WorldOptions world;
  world.pool = std::clamp(count + neighbours, 1, max_pool);
  world.soft_pool = options.soft ? std::min(count, max_soft_pool) : 0;
  world.frictions = options.frictions;
  world.keep_commands = false;
  return world;
}

Result<void> free_it(World& world, const scene::Scene& scene, std::uint32_t row, double lift_m) {
  if (lift_m == 0 || hangs_on_hook(scene, row)) return world.wake(row);
  Pose raised = scene::world_from_product(scene.products[row]);
  raised.position.z += lift_m;
  return world.place(row, raised);
}

bool at_rest(const ProductMotion& motion) {
  return length(motion.velocity_m_s) == 0 && length(motion.angular_rad_s) == 0;
}

}  // namespace

Result<std::vector<LetGoProduct>> let_go(const scene::Scene& scene,
                                         const LetGoOptions& options,
                                         Progress& progress) {
  MARKETGEN_TRY(const std::vector<std::uint32_t> rows, rows_in(scene, options.region_m));
  if (rows.empty()) return std::vector<LetGoProduct>();
  MARKETGEN_TRY(World world,
                World::create(scene, world_for(static_cast<int>(rows.size()), options)));
  for (const std::uint32_t row : rows)
    MARKETGEN_CHECK(free_it(world, scene, row, options.lift_m));
  const int steps = static_cast<int>(std::lround(options.seconds / time_step_s));
  progress.begin("settle", static_cast<std::size_t>(steps));
  for (int done = 0; done < steps; done += steps_at_once) {
    MARKETGEN_CHECK(check_interrupt());
    const int now = std::min(steps_at_once, steps - done);
    MARKETGEN_CHECK(world.step(now));
    progress.advance(static_cast<std::size_t>(now));
  }
  progress.end();
  std::vector<LetGoProduct> ends;
  for (const std::uint32_t row : rows)
    ends.push_back({row, world.product_pose(row), at_rest(world.product_motion(row))});
  return ends;
}

}  // namespace marketgen::physics
