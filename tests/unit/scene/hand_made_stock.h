// Rows and rooms made by hand, for tests of the planogram and of shelf filling.
#pragma once
#include <string>

#include "catalog/catalog.h"
#include "scene/planogram.h"
#include "support/hand_laid_shop.h"

namespace marketgen {

inline catalog::Product stock_row(std::string sku,
                                  std::string archetype,
                                  std::array<int, 3> size_mm,
                                  double mass_kg,
                                  int stack_max = 1) {
  catalog::Product product;
  product.sku = std::move(sku);
  product.name = product.sku;
  product.brand = "Fonda";
  product.category = "canned";
  product.subcategory = "beans";
  product.archetype = std::move(archetype);
  product.size_mm = size_mm;
  product.mass_kg = mass_kg;
  product.stack_max = stack_max;
  return product;
}

inline catalog::Catalog catalog_of(std::vector<catalog::Product> products) {
  catalog::Catalog catalog;
  catalog.products = std::move(products);
  return catalog;
}

inline std::vector<std::uint32_t> all_rows(const catalog::Catalog& catalog) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 0; i < catalog.products.size(); ++i)
    rows.push_back(i);
  return rows;
}

inline scene::ShelfRoom shelf_room(double width_m = 1.2,
                                   double depth_m = 0.45,
                                   double clearance_m = 0.32) {
  return {width_m, depth_m, clearance_m, assets::ShelfUse::stand};
}

}  // namespace marketgen
