#include "environments/store_assortment.h"

#include <algorithm>
#include <optional>

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

const catalog::Country& country_of(const scene::Scene& scene) {
  return scene.catalog.empty() ? catalog::country_or_euro(std::nullopt)
                               : catalog::country_of(scene.catalog.front());
}

}  // namespace marketgen::environments
