// A scene made ready for ray tracing.
#pragma once
#include <memory>

#include "base/progress.h"
#include "base/result.h"
#include "render/stage/draft.h"
#include "render/stage/exhibit.h"
#include "render/stage/world.h"
#include "scene/scene.h"

namespace marketgen::render::raytrace {

// The world keeps nothing of `scene`. Errors: those of the
// product models and labels; io.out_of_memory when Embree fails.
Result<std::unique_ptr<World>> build_world(const scene::Scene& scene,
                                           const std::vector<Exhibit>& exhibits,
                                           Progress& progress,
                                           const WorldDetail& detail);

}  // namespace marketgen::render::raytrace
