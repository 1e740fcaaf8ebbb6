// Tileable materials as the pictures that formats with metallic-roughness materials take.
#pragma once
#include <string>

#include "assets/product_model.h"
#include "base/result.h"
#include "catalog/rows.h"
#include "scene/scene.h"

namespace marketgen::exporters {

constexpr float glass_alpha = 0.25F;  // opacity of a pane, where a format has nothing better

// PNG each, but for colours where JPEG is asked for.
struct MaterialPictures {
  std::string color;   // sRGB
  std::string normal;  // tangent space, green up
  std::string gloss;   // linear: roughness in green, metallic in blue
};
enum class ColorCoding { png, jpeg };  // the second is a quarter of the first

// The row of this id; null when the scene has none: then it shows as plain_plaster().
const catalog::MaterialRow* scene_material(const scene::Scene& scene, const std::string& id);
assets::Surface plain_plaster();
// Metres that one repeat of it covers.
double material_repeat_m(const scene::Scene& scene, const std::string& id);

// Errors: image.*.
Result<MaterialPictures> material_pictures(const catalog::MaterialRow& material,
                                           ColorCoding coding = ColorCoding::png);

}  // namespace marketgen::exporters
