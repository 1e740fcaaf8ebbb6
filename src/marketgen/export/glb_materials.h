// Materials of a GLB export: surfaces of packs, parts and the room as glTF's metallic-roughness
// materials.
#pragma once
#include <map>
#include <string>

#include "assets/product_model.h"
#include "io/glb_document.h"
#include "scene/scene.h"

namespace marketgen::exporters {

class GlbMaterials {
 public:
  GlbMaterials(const scene::Scene& scene, io::GlbDocument& document)
      : scene_(scene), document_(document) {}

  // `texture` is an index from GlbDocument::add_texture, -1 for none.
  int add(const assets::Surface& surface, int texture = -1);
  // A catalogue material, tiled by UVs in units of `extent_m(id)`; light plaster when the scene has
  // no such row. Errors: image.*.
  Result<int> add_tiled(const std::string& id);
  Result<int> add_tiled(const catalog::MaterialRow& material);
  double extent_m(const std::string& id) const;

 private:
  Result<io::GltfJson> textured(const catalog::MaterialRow& material);

  const scene::Scene& scene_;
  io::GlbDocument& document_;
  std::map<std::string, int> tiled_;
};

}  // namespace marketgen::exporters
