#include "episodes/pictured_products.h"

#include <algorithm>

#include "assets/product_model.h"
#include "episodes/product_pictures.h"
#include "grasping/grasp_study.h"

namespace marketgen {

Result<const Product*> PicturedProducts::row(const std::string& sku) const {
  const auto found = std::ranges::find(products_, sku, &Product::sku);
  if (found == products_.end())
    return Error{"catalog.unknown_sku", sku, "the agent's catalogue has no such product"};
  return &*found;
}

Result<const KnownProduct*> PicturedProducts::product(const std::string& sku) {
  if (const auto found = known_.find(sku); found != known_.end()) return &found->second;
  MARKETGEN_TRY(const Product* const product, row(sku));
  MARKETGEN_TRY(ProductBody body, make_product_body(*product));
  KnownProduct known{*product, std::move(body), rubber_friction(frictions_, *product)};
  return &known_.emplace(sku, std::move(known)).first->second;
}

Result<std::vector<ProductPicture>> PicturedProducts::pictures(const std::string& sku) const {
  MARKETGEN_TRY(const Product* const product, row(sku));
  return product_pictures(*product);
}

}  // namespace marketgen
