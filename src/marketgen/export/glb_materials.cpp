#include "export/glb_materials.h"

#include <algorithm>

#include "export/material_pictures.h"

namespace marketgen::exporters {

int GlbMaterials::add(const assets::Surface& surface, int texture) {
  const Vec3f c = surface.color;
  io::GltfJson pbr;
  io::GltfJson material;
  if (surface.kind == assets::SurfaceKind::emissive) {  // glTF's emission ends at 1
    const float most = std::max({c.x, c.y, c.z, 1.0F});
    pbr["baseColorFactor"] = {0, 0, 0, 1};
    material["emissiveFactor"] = io::json_array(std::array{c.x / most, c.y / most, c.z / most});
  } else {
    const bool glass = surface.kind == assets::SurfaceKind::glass;
    const auto share = [](float v) { return std::clamp(v, 0.0F, 1.0F); };
    pbr["baseColorFactor"] =
        io::json_array(std::array{share(c.x), share(c.y), share(c.z), glass ? glass_alpha : 1.0F});
    if (glass) material["alphaMode"] = "BLEND";
  }
  if (texture >= 0) pbr["baseColorTexture"] = {{"index", texture}};
  pbr["metallicFactor"] = io::json_number(surface.metallic);
  pbr["roughnessFactor"] = io::json_number(surface.roughness);
  material["pbrMetallicRoughness"] = std::move(pbr);
  return document_.add_material(material);
}

Result<int> GlbMaterials::add_tiled(const std::string& id) {
  const catalog::MaterialRow* material = scene_material(scene_, id);
  return material == nullptr ? add(plain_plaster()) : add_tiled(*material);
}

Result<int> GlbMaterials::add_tiled(const catalog::MaterialRow& material) {
  const auto known = tiled_.find(material.id);
  if (known != tiled_.end()) return known->second;
  MARKETGEN_TRY(const io::GltfJson gltf, textured(material));
  const int index = document_.add_material(gltf);
  tiled_.emplace(material.id, index);
  return index;
}

Result<io::GltfJson> GlbMaterials::textured(const catalog::MaterialRow& material) {
  MARKETGEN_TRY(const MaterialPictures pictures, material_pictures(material));
  // A value of its own until it is whole: a reference into an ordered object does not outlive the
  // next insertion.
  io::GltfJson pbr{
      {"baseColorTexture", {{"index", document_.add_texture(pictures.color)}}},
      {"metallicRoughnessTexture", {{"index", document_.add_texture(pictures.gloss)}}}};
  const bool clear = material.transmission > 0;
  if (clear) pbr["baseColorFactor"] = {1, 1, 1, 1 - material.transmission};
  io::GltfJson gltf{{"name", material.id}, {"pbrMetallicRoughness", std::move(pbr)}};
  gltf["normalTexture"] = {{"index", document_.add_texture(pictures.normal)}};
  if (clear) gltf["alphaMode"] = "BLEND";
  return gltf;
}

double GlbMaterials::extent_m(const std::string& id) const {
  return material_repeat_m(scene_, id);
}

}  // namespace marketgen::exporters
