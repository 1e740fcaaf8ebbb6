#include "render/light/lit_world.h"

#include <cmath>
#include <utility>

#include "render/shading_math.h"
#include "render/stage/build_world.h"

namespace marketgen::render::raytrace {
namespace {

constexpr float meter_share = 0.75F;

}  // namespace

LitWorld::LitWorld(std::unique_ptr<World> built, const scene::Scene& scene, bool keep_light)
    : world(std::move(built)), lights(*world), field(*world, lights, scene, keep_light) {
  // Exposed by the light meter, but not all the way: a dim shop should look dimmer than a bright
  // one.
  const float metered = field.floor_mean();
  const float meant = pi / world->exposure;  // irradiance that the look asks for
  if (metered > 0) world->exposure *= std::pow(meant / metered, meter_share);
}

Result<std::unique_ptr<LitWorld>> light_world(const scene::Scene& scene,
                                              const std::vector<Exhibit>& exhibits,
                                              Progress& progress,
                                              const RendererOptions& options) {
  MARKETGEN_TRY(std::unique_ptr<World> world,
                build_world(scene, exhibits, progress, options.print));
  return std::make_unique<LitWorld>(std::move(world), scene, options.keep_light);
}

}  // namespace marketgen::render::raytrace
