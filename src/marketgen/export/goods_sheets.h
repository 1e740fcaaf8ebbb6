// What goods look like where a mesh takes one picture, and a pack has several finishes: each SKU
// has one sheet, its label above, a row of plain swatches below, one for every surface that is not
// printed.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "assets/product_model.h"
#include "base/result.h"
#include "geometry/image.h"
#include "geometry/mesh.h"
#include "scene/scene.h"

namespace marketgen::exporters {

// A mesh whose corners show where on the sheet each has its look.
struct SheetLook {
  Mesh mesh;
  Image sheet;
};

// `label` is empty for goods without print. `materials`: rows of the tiled materials that surfaces
// name; these show as their ground colour. Error: assets.bad_row for a colour that is none.
Result<SheetLook> sheet_look(const assets::ProductModel& model,
                             const Image& label,
                             const std::vector<catalog::MaterialRow>& materials);

struct GoodsSheet {
  std::string obj, png;
};

// By row of the scene's catalogue, made side by side; nothing for a SKU of which no item stands in
// the scene. Errors: assets.*, image.*.
Result<std::vector<std::optional<GoodsSheet>>> goods_sheets(const scene::Scene& scene);

}  // namespace marketgen::exporters
