#include "assets/print/pack_art.h"

#include "assets/print/barcode.h"
#include "base/hash.h"

namespace marketgen::assets {

Result<PackArt> pack_art(const catalog::Product& product) {
  const std::string at = product.sku + "/label/";
  PackArt art;
  art.product = &product;
  MARKETGEN_TRY(art.primary, parse_color(product.label.primary, at + "primary"));
  MARKETGEN_TRY(art.secondary, parse_color(product.label.secondary, at + "secondary"));
  MARKETGEN_TRY(art.accent, parse_color(product.label.accent, at + "accent"));
  MARKETGEN_TRY(art.text, parse_color(product.label.text, at + "text"));
  MARKETGEN_TRY(art.motif, find_motif(product.label.motif, at + "motif"));
  art.look = brand_look(product.brand);
  art.seed = Seed(hash64(product.sku));
  if (!product.ean.empty()) {
    MARKETGEN_TRY(art.bars, ean13_modules(product.ean, product.sku + "/ean"));
  }
  return art;
}

}  // namespace marketgen::assets
