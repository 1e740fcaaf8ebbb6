// The parts of a GLB export that stand still: the room, the fixtures and the price labels.
#pragma once
#include "export/glb_materials.h"
#include "io/glb_document.h"
#include "scene/scene.h"

namespace marketgen::exporters {

// Each adds one group node with what belongs to it. Errors: assets.*, image.*.
Result<void> add_room(const scene::Scene& scene,
                      io::GlbDocument& document,
                      GlbMaterials& materials);
// A node per module, named by its id; equal modules share a mesh.
Result<void> add_fixtures(const scene::Scene& scene,
                          io::GlbDocument& document,
                          GlbMaterials& materials);

}  // namespace marketgen::exporters
