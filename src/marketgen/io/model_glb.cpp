#include "io/model_glb.h"

#include <fmt/format.h>

#include "io/glb_document.h"
#include "io/png.h"

namespace marketgen::io {
namespace {

constexpr float clear_alpha = 0.25F;

// From the model's frame (Y up) to the document's (Z up).
Vec3f upright(Vec3f p) {
  return {p.x, -p.z, p.y};
}

Mesh upright(Mesh mesh) {
  for (Vec3f& p : mesh.positions)
    p = upright(p);
  for (Vec3f& n : mesh.normals)
    n = upright(n);
  return mesh;
}

GltfJson json_of(const ModelMaterial& material, int texture) {
  GltfJson pbr;
  const float alpha = material.clear ? clear_alpha : 1;
  pbr["baseColorFactor"] =
      json_array(std::array{material.color.x, material.color.y, material.color.z, alpha});
  if (texture >= 0) pbr["baseColorTexture"] = {{"index", texture}};
  pbr["metallicFactor"] = json_number(material.metallic);
  pbr["roughnessFactor"] = json_number(material.roughness);
  GltfJson json{{"name", material.name}};
  if (material.clear) json["alphaMode"] = "BLEND";
  json["pbrMetallicRoughness"] = std::move(pbr);
  return json;
}

}  // namespace

Result<std::string> encode_glb(const OutsideModel& model, const std::string& name) {
  GlbDocument document(name);
  std::vector<int> textures;
  for (const Image& picture : model.pictures) {
    MARKETGEN_TRY(const std::string png, encode_png(picture));
    textures.push_back(document.add_texture(png));
  }
  std::vector<int> materials;
  for (const ModelMaterial& material : model.materials) {
    const int texture =
        material.picture < 0 ? -1 : textures[static_cast<std::size_t>(material.picture)];
    materials.push_back(document.add_material(json_of(material, texture)));
  }
  const int mesh = document.add_mesh(name, upright(model.mesh), materials);
  document.add_node({{"name", name}, {"mesh", mesh}}, -1);
  if (model.pieces.empty()) return document.finish();

  const int contact = document.add_scene("contact");
  for (std::size_t i = 0; i < model.pieces.size(); ++i) {
    std::vector<Vec3f> points;
    for (const Vec3f& p : model.pieces[i])
      points.push_back(upright(p));
    const std::string piece = fmt::format("contact-{}", i);
    document.add_node({{"name", piece}, {"mesh", document.add_points(piece, points)}}, contact);
  }
  return document.finish();
}

}  // namespace marketgen::io
