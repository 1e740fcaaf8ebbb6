// The goods and price labels of a GLB export: one mesh per SKU or tag, drawn wherever it stands.
#pragma once
#include "export/export.h"
#include "export/glb_materials.h"
#include "io/glb_document.h"
#include "scene/scene.h"

namespace marketgen::exporters {

// Errors: assets.*, image.*.
Result<void> add_products(const scene::Scene& scene,
                          const ExportOptions& options,
                          io::GlbDocument& document,
                          GlbMaterials& materials);
Result<void> add_price_labels(const scene::Scene& scene,
                              const ExportOptions& options,
                              io::GlbDocument& document,
                              GlbMaterials& materials);

}  // namespace marketgen::exporters
