// What the SKUs of a store look like, for formats that hold meshes: made side by side.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "assets/contents.h"
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

// Rows of a format's materials, one for each surface of the model. `Looks` (GlbMaterials, UsdLooks)
// adds plain surfaces, with a picture where they show the label, and tiled materials, by their id
// or as a row. Errors: those of tiled materials.
template <class Looks, class Picture>
Result<std::vector<int>> add_looks(Looks& looks,
                                   const catalog::Product& product,
                                   const assets::ProductModel& model,
                                   const Picture& label) {
  std::vector<int> by_surface;
  for (const assets::Surface& surface : model.surfaces) {
    if (surface.texture.empty()) {
      by_surface.push_back(looks.add(surface));
    } else if (surface.texture == "label") {
      by_surface.push_back(looks.add(surface, label));
    } else {
      MARKETGEN_TRY(const int tiled,
                    surface.texture == "contents"
                        ? looks.add_tiled(assets::contents_material(*product.contents))
                        : looks.add_tiled(surface.texture));
      by_surface.push_back(tiled);
    }
  }
  return by_surface;
}

}  // namespace marketgen::exporters
