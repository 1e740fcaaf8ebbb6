// The layers of a USD export. Each function returns one layer's text; what it needs beside it goes
// to `geometry` and `pictures`.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "export/exporter.h"
#include "export/usd_geometry.h"
#include "export/usd_materials.h"
#include "scene/scene.h"

namespace marketgen::exporters {

struct UsdParts {
  const scene::Scene& scene;
  const ExportOptions& options;
  std::vector<bool> free;  // by row of the scene's products
  UsdGeometry geometry;
  UsdPictures pictures{scene};
};

// An asset for each SKU that stands in the store: its look, its solid, mass, friction and labels.
// SKUs with free items have the variants "still" and "free" of the set "physics". Errors: assets.*,
// image.*, catalog.bad_row.
Result<std::string> usd_products(UsdParts& parts);
// Every item as an instance of its SKU's asset, by fixture; price tags and cards. Errors: image.*,
// those of price_prints.
Result<std::string> usd_goods(UsdParts& parts);
struct UsdFixtures {
  std::string modules;   // the bodies of which fixtures are made up, equal ones once
  std::string fixtures;  // where they stand, and their joints
};
// Errors: image.*.
Result<UsdFixtures> usd_fixtures(UsdParts& parts);
// Errors: image.*.
Result<std::string> usd_room(UsdParts& parts);
std::string usd_lights(const scene::Scene& scene);

}  // namespace marketgen::exporters
