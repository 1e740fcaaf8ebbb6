// Single products on a plain ground: pictures for the asset library.
#pragma once
#include <vector>

#include "base/result.h"
#include "catalog/product.h"
#include "geometry/image.h"

namespace marketgen::render {

// Three-quarter view, `size_px` a side. Errors: assets.*.
Result<Image> draw_product(const catalog::Product& product, int size_px);
// All of them in rows, each `size_px` a side, in the given order.
Result<Image> draw_contact_sheet(const std::vector<catalog::Product>& products, int size_px);

}  // namespace marketgen::render
