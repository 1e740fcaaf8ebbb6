#include "scene/catalog_slice.h"

namespace marketgen::scene {

void take_catalog_slice(Scene& scene, const catalog::Catalog& catalog) {
  std::vector<std::uint8_t> used(catalog.products.size(), 0);
  for (const Facing& f : scene.facings)
    used[f.sku] = 1;
  for (const SceneProduct& p : scene.products)
    used[p.sku] = 1;
  std::vector<std::uint32_t> row_of(catalog.products.size(), 0);
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i] == 0) continue;
    row_of[i] = static_cast<std::uint32_t>(scene.catalog.size());
    scene.catalog.push_back(catalog.products[i]);
  }
  for (Facing& f : scene.facings)
    f.sku = row_of[f.sku];
  for (SceneProduct& p : scene.products)
    p.sku = row_of[p.sku];
  for (PriceLabel& l : scene.price_labels)
    l.sku = row_of[l.sku];
}

void give_up_catalog_slice(Scene& scene, const catalog::Catalog& catalog) {
  std::vector<std::uint32_t> row_of;
  for (const catalog::Product& product : scene.catalog)
    row_of.push_back(
        static_cast<std::uint32_t>(catalog.product(product.sku) - catalog.products.data()));
  for (Facing& f : scene.facings)
    f.sku = row_of[f.sku];
  for (SceneProduct& p : scene.products)
    p.sku = row_of[p.sku];
  for (PriceLabel& l : scene.price_labels)
    l.sku = row_of[l.sku];
  scene.catalog.clear();
}

}  // namespace marketgen::scene
