#include "episodes/pictured_products.h"

#include <algorithm>

#include "assets/product_model.h"
#include "episodes/product_pictures.h"
#include "grasping/grasp_study.h"

namespace marketgen::episodes {

Result<const catalog::Product*> PicturedProducts::row(const std::string& sku) const {
  const auto found = std::ranges::find(products_, sku, &catalog::Product::sku);
  if (found == products_.end())
    return Error{"catalog.unknown_sku", sku, "the agent's catalogue has no such product"};
  return &*found;
}

Result<const agent::KnownProduct*> PicturedProducts::product(const std::string& sku) {
  if (const auto found = known_.find(sku); found != known_.end()) return &found->second;
  MARKETGEN_TRY(const catalog::Product* const product, row(sku));
  MARKETGEN_TRY(const auto body, assets::product_body(*product));
  agent::KnownProduct known{*product, *body, grasping::rubber_friction(frictions_, *product)};
  return &known_.emplace(sku, std::move(known)).first->second;
}

Result<std::vector<agent::ProductPicture>> PicturedProducts::pictures(
    const std::string& sku) const {
  MARKETGEN_TRY(const catalog::Product* const product, row(sku));
  return product_pictures(*product);
}

}  // namespace marketgen::episodes
