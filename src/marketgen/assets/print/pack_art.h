// What the print of one pack is made of: the product row's colours and motif, resolved, with its
// brand's look.
#pragma once
#include <algorithm>
#include <string>

#include "assets/print/brand_mark.h"
#include "assets/print/label_motif.h"
#include "base/result.h"
#include "base/seed.h"
#include "catalog/product.h"

namespace marketgen::assets {

struct PackArt {
  const catalog::Product* product = nullptr;
  Color primary, secondary, accent, text;
  const LabelMotif* motif = nullptr;
  BrandLook look;
  Seed seed{0};             // of the SKU
  std::string bars;         // modules of the EAN; empty when the product has none
  bool bars_apart = false;  // true to size and left out of the picture, see Canvas::bars

  // A light field in the secondary colour, `by` towards white; next to white when that colour is
  // strong.
  Color paper(double by) const {
    constexpr double strong = 2.2;
    return lighter(secondary, contrast(secondary, paper_white) > strong ? std::max(by, 0.92) : by);
  }
  MotifInk ink() const { return {primary, secondary, accent}; }
  // The row's text colour, or a tint that can be read on `ground`.
  Color type_on(const Color& ground) const { return readable_on(ground, text); }
};

// Reads the row. Errors: assets.bad_row (colour, motif, EAN), with the SKU and the field.
Result<PackArt> pack_art(const catalog::Product& product);

}  // namespace marketgen::assets
