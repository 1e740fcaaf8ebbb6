// A scene's world with the light stored in its air, exposed: what pictures are taken of, and what a
// viewer is given of a store.
#pragma once
#include <memory>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "render/light/irradiance.h"
#include "render/light/light_grid.h"
#include "render/stage/draft.h"
#include "render/stage/exhibit.h"
#include "render/stage/world.h"
#include "scene/scene.h"

namespace marketgen::render::raytrace {

struct LitWorld {
  LitWorld(std::unique_ptr<World> built, const scene::Scene& scene, bool keep_light);

  std::unique_ptr<World> world;
  LightGrid lights;
  IrradianceField field;
};

// Builds the world, bakes its light (or takes it from the disk: `keep_light`) and sets
// World::exposure by it: a white sheet in the light on the goods (IrradianceField::goods_median())
// is 1, or on the floor of a store without shelves. All cameras of a store have the same exposure.
// Packs that are shaped as from afar need much less memory (the server's first opening:
// docs/figures.md), and the light differs by a byte of 255 in the mean. Errors: as build_world.
Result<std::unique_ptr<LitWorld>> light_world(const scene::Scene& scene,
                                              const std::vector<Exhibit>& exhibits,
                                              Progress& progress,
                                              const WorldDetail& detail,
                                              bool keep_light);

}  // namespace marketgen::render::raytrace
