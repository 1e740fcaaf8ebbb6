// Another look for a finished store: materials, colours and light change, nothing moves.
#pragma once
#include "base/result.h"
#include "catalog/catalog.h"
#include "scene/scene.h"

namespace marketgen::scene {

// The scene in the look of `style`. Shelving that had the old look's material takes the new one's;
// fixtures with a finish of their own keep it. scene_hash stays what it was.
// Errors: catalog.*, assets.*; scene.wrong_version when the fixtures were made by other rows than
// `catalog` has, so that their parts cannot be told.
Result<Scene> reskin(Scene scene, const catalog::StyleRow& style, const catalog::Catalog& catalog);

}  // namespace marketgen::scene
