#include "render/light/lit_world.h"

#include <utility>

#include "render/shading_math.h"
#include "render/stage/build_world.h"

namespace marketgen::render::raytrace {
LitWorld::LitWorld(std::unique_ptr<World> built, const scene::Scene& scene, bool keep_light)
    : world(std::move(built)), lights(*world), field(*world, lights, scene, keep_light) {
  // As a camera is set once for a shop, by what it is to show: goods, from the aisle.
  const float goods = field.goods_median();
  const float metered = goods > 0 ? goods : field.floor_mean();
  if (metered > 0) world->exposure = pi / metered;
}

Result<std::unique_ptr<LitWorld>> light_world(const scene::Scene& scene,
                                              const std::vector<Exhibit>& exhibits,
                                              Progress& progress,
                                              const WorldDetail& detail,
                                              bool keep_light) {
  MARKETGEN_TRY(std::unique_ptr<World> world, build_world(scene, exhibits, progress, detail));
  return std::make_unique<LitWorld>(std::move(world), scene, keep_light);
}

}  // namespace marketgen::render::raytrace
