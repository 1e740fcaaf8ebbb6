#include "assets/usable_catalog.h"

#include "assets/print/pack_pictures.h"
#include "assets/product_model.h"
#include "base/interrupt.h"
#include "io/file.h"

namespace marketgen::assets {

Result<catalog::Catalog> usable_catalog(const std::vector<std::filesystem::path>& extra) {
  MARKETGEN_TRY(const std::filesystem::path data, io::data_folder());
  MARKETGEN_TRY(catalog::Catalog catalog, catalog::load_catalog(data, extra));
  for (const catalog::Product& product : catalog.products) {  // the catalogue knows no shapes
    MARKETGEN_CHECK(check_interrupt());
    MARKETGEN_CHECK(collision_of(product));
    MARKETGEN_CHECK(check_faces(product));
  }
  return catalog;
}

}  // namespace marketgen::assets
