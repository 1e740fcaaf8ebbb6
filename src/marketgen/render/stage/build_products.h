// Products as instances of one mesh per SKU.
#pragma once
#include <vector>

#include "assets/product_model.h"
#include "base/result.h"
#include "render/stage/draft.h"

namespace marketgen::render::raytrace {

class ProductBuilder {
 public:
  // Makes the models of the SKUs in use, that finely, and asks for their labels. Errors: assets.*,
  // catalog.*.
  static Result<ProductBuilder> begin(Draft& draft, assets::Detail detail);
  // Adds meshes and instances; textures are drawn by now.
  void build(Draft& draft) const;

 private:
  struct Sku {
    std::uint32_t row = 0;  // in scene.catalog
    assets::ProductModel model;
    std::vector<std::uint16_t> materials;  // of model.surfaces
  };
  std::vector<Sku> skus_;
};

}  // namespace marketgen::render::raytrace
