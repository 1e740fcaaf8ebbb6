// Parts of fixtures as meshes.
#pragma once
#include "assets/product_model.h"
#include "geometry/mesh.h"
#include "scene/scene.h"

namespace marketgen::exporters {

// The part's own look; a part with a row in Scene::materials shows that instead.
assets::Surface part_surface(const scene::ScenePart& part);

// Adds the part where `owner_from_part` says. UVs count repeats of `extent_m` metres.
void add_part(Mesh& mesh,
              const scene::ScenePart& part,
              const Pose& owner_from_part,
              std::uint16_t surface,
              double extent_m);

}  // namespace marketgen::exporters
