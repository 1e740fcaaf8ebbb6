// A room with one fixture in its middle and no goods: for pictures of the asset library and for
// checks of what moves.
#pragma once
#include "base/result.h"
#include "catalog/catalog.h"
#include "scene/scene.h"

namespace marketgen::scene {

// The row in its first width and its usual measures, both ends closed; its front faces south. The
// fixture's id is the row's kind. Errors: catalog.*, assets.*.
Result<Scene> stage_fixture(const catalog::FixtureKind& kind, const catalog::Catalog& catalog);

}  // namespace marketgen::scene
