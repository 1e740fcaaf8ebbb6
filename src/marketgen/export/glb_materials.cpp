#include "export/glb_materials.h"

#include <algorithm>

#include "assets/material_texture.h"
#include "io/png.h"

namespace marketgen {
namespace {

constexpr int tile_px = 256;
constexpr float glass_alpha = 0.25F;

}  // namespace

int GlbMaterials::add(const Surface& surface, int texture) {
  const Vec3f c = surface.color;
  GltfJson pbr;
  GltfJson material;
  if (surface.kind == SurfaceKind::emissive) {  // glTF's emission ends at 1
    const float most = std::max({c.x, c.y, c.z, 1.0F});
    pbr["baseColorFactor"] = {0, 0, 0, 1};
    material["emissiveFactor"] = json_array(std::array{c.x / most, c.y / most, c.z / most});
  } else {
    const bool glass = surface.kind == SurfaceKind::glass;
    const auto share = [](float v) { return std::clamp(v, 0.0F, 1.0F); };
    pbr["baseColorFactor"] =
        json_array(std::array{share(c.x), share(c.y), share(c.z), glass ? glass_alpha : 1.0F});
    if (glass) material["alphaMode"] = "BLEND";
  }
  if (texture >= 0) pbr["baseColorTexture"] = {{"index", texture}};
  pbr["metallicFactor"] = json_number(surface.metallic);
  pbr["roughnessFactor"] = json_number(surface.roughness);
  material["pbrMetallicRoughness"] = std::move(pbr);
  return document_.add_material(material);
}

const MaterialRow* GlbMaterials::row(const std::string& id) const {
  const auto found = std::ranges::find(scene_.materials, id, &MaterialRow::id);
  return found == scene_.materials.end() ? nullptr : &*found;
}

Result<int> GlbMaterials::add_tiled(const std::string& id) {
  const MaterialRow* material = row(id);
  if (material == nullptr)
    return add({.color = {0.8F, 0.8F, 0.78F}, .roughness = 0.8F, .texture = ""});
  const auto known = tiled_.find(id);
  if (known != tiled_.end()) return known->second;
  MARKETGEN_TRY(const std::string png, encode_png(draw_material(*material, tile_px)));
  const int index = add({.color = {1, 1, 1},
                         .roughness = static_cast<float>(material->roughness),
                         .metallic = static_cast<float>(material->metallic),
                         .texture = ""},
                        document_.add_texture(png));
  tiled_.emplace(id, index);
  return index;
}

double GlbMaterials::extent_m(const std::string& id) const {
  const MaterialRow* material = row(id);
  return material == nullptr ? 1 : material_extent_m(*material);
}

}  // namespace marketgen
