#include "export/licences.h"

#include <fmt/format.h>

#include <set>

#include "base/build_info.h"

namespace marketgen::exporters {

BesideFile licences_file(const scene::Scene& scene) {
  std::set<std::string> imported;
  for (const scene::SceneProduct& item : scene.products) {
    const catalog::Product& product = scene.catalog[item.sku];
    if (product.archetype == "mesh" || product.faces) imported.insert(product.sku);
  }
  std::string text = fmt::format(
      "# Licences\n\nThe meshes, pictures and layers of this store were made by MarketGen {}, from "
      "its own rows\nand drawings: Apache-2.0. Brands, names and designs are invented.\n",
      program_version);
  if (imported.empty()) return {"LICENCES.md", std::move(text)};
  text +=
      "\nThese products show models or pictures that were imported; each is under the licence of "
      "its own, which\nMarketGen does not know:\n\n";
  for (const std::string& sku : imported)
    text += fmt::format("- `{}`\n", sku);
  return {"LICENCES.md", std::move(text)};
}

}  // namespace marketgen::exporters
