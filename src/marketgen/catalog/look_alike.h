// Products that are easily taken for one another.
#pragma once
#include "catalog/product.h"

namespace marketgen::catalog {

// Another row of the same family (Product::family), or of the same group in a container of the same
// shape, each side of which differs by a tenth at most.
bool are_look_alikes(const Product& a, const Product& b);

}  // namespace marketgen::catalog
