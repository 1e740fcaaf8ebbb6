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

Result<std::vector<agent::ProductPictures>> PicturedProducts::pictures(
    const std::vector<std::string>& skus) const {
  std::vector<const catalog::Product*> products;
  for (const std::string& sku : skus) {
    MARKETGEN_TRY(products.emplace_back(), row(sku));
  }
  return product_pictures(products);
}

std::string PicturedProducts::pictures_key() const {
  return product_pictures_key();
}

}  // namespace marketgen::episodes
