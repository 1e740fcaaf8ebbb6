// Tileable materials as the pictures that formats with metallic-roughness materials take.
#pragma once
#include <string>

#include "assets/product_model.h"
#include "base/result.h"
#include "catalog/rows.h"
#include "scene/scene.h"

namespace marketgen::exporters {

constexpr float glass_alpha = 0.25F;  // opacity of a pane, where a format has nothing better

// Files.
struct MaterialPictures {
  std::string color;   // sRGB
  std::string normal;  // tangent space, green up
  std::string gloss;   // linear: roughness in green, metallic in blue
};
// What colour and normal are; gloss, which has few values, is always PNG. JPEG is a quarter of the
// bytes, and turns a normal by 1.5 degrees in the mean of those that show grains.
enum class MaterialCoding { png, jpeg };

// The row of this id; null when the scene has none: then it shows as plain_plaster().
const catalog::MaterialRow* scene_material(const scene::Scene& scene, const std::string& id);
assets::Surface plain_plaster();
// Metres that one repeat of it covers.
double material_repeat_m(const scene::Scene& scene, const std::string& id);

// Errors: image.*.
Result<MaterialPictures> material_pictures(const catalog::MaterialRow& material,
                                           MaterialCoding coding = MaterialCoding::png);

}  // namespace marketgen::exporters
