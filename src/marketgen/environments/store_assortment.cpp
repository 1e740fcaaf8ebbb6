#include "environments/store_assortment.h"

#include <algorithm>

namespace marketgen::environments {

shopping::Assortment assortment_of(const scene::Scene& scene,
                                   const std::vector<std::string>& sold_out) {
  std::vector<bool> there(scene.catalog.size(), false);
  for (const scene::SceneProduct& item : scene.products)
    there[item.sku] = true;
  shopping::Assortment assortment{scene.catalog, sold_out};
  for (std::size_t i = 0; i < there.size(); ++i)
    if (!there[i]) assortment.sold_out.push_back(scene.catalog[i].sku);
  std::ranges::sort(assortment.sold_out);
  return assortment;
}

}  // namespace marketgen::environments
