// What the SKUs of a store look like, for formats that hold meshes: made side by side.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "assets/product_model.h"
#include "base/result.h"
#include "scene/scene.h"

namespace marketgen::exporters {

// How a label is written to a file: JPEG takes a third of the bytes.
enum class LabelCoding { png, jpeg };

struct GoodsLook {
  assets::ProductModel model;
  std::string label;  // a picture file's bytes; empty when no surface shows the label
  std::optional<Error> error;
};

// By row of the scene's catalogue; empty for a SKU of which no item stands in the scene. Errors of
// one are in its row: assets.*, image.*.
std::vector<GoodsLook> goods_looks(const scene::Scene& scene,
                                   assets::Detail detail,
                                   LabelCoding coding);

}  // namespace marketgen::exporters
