// One fixture alone in a bright room: pictures for the asset library.
#pragma once
#include "base/result.h"
#include "geometry/image.h"
#include "scene/scene.h"

namespace marketgen::render {

// Three-quarter view of `stage`, which scene/fixture_stage.h made, with its parts where they are:
// opened with scene_at() or not. `size_px` a side. Errors: camera.*.
Result<Image> draw_fixture(const scene::Scene& stage, int size_px);

}  // namespace marketgen::render
