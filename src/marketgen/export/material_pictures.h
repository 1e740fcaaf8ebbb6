// Tileable materials as the pictures that formats with metallic-roughness materials take.
#pragma once
#include <string>

#include "base/result.h"
#include "catalog/rows.h"

namespace marketgen::exporters {

constexpr float glass_alpha = 0.25F;  // opacity of a pane, where a format has nothing better

// PNG each.
struct MaterialPictures {
  std::string color;   // sRGB
  std::string normal;  // tangent space, green up
  std::string gloss;   // linear: roughness in green, metallic in blue
};

// Errors: image.*.
Result<MaterialPictures> material_pictures(const catalog::MaterialRow& material);

}  // namespace marketgen::exporters
