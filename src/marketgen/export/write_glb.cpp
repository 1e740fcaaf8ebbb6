#include "export/exporter.h"
#include "export/glb_goods.h"
#include "export/glb_materials.h"
#include "export/glb_room.h"
#include "export/licences.h"
#include "io/glb_document.h"

namespace marketgen::exporters {

Result<ExportFiles> write_glb(const scene::Scene& scene, const ExportOptions& options) {
  io::GlbDocument document(scene.layout.name);
  GlbMaterials materials(scene, document);
  MARKETGEN_CHECK(add_room(scene, document, materials));
  MARKETGEN_CHECK(add_fixtures(scene, document, materials));
  MARKETGEN_CHECK(add_products(scene, options, document, materials));
  MARKETGEN_CHECK(add_price_labels(scene, options, document, materials));
  return ExportFiles{document.finish(), {licences_file(scene)}};
}

}  // namespace marketgen::exporters
