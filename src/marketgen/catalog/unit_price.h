// What goods cost by amount, as price tags must say.
#pragma once
#include <algorithm>

#include "catalog/product.h"

namespace marketgen::catalog {

// Euro a Product::unit_of_measure.
inline double unit_price(const Product& product) {
  return product.price / std::max(1e-6, product.unit_amount);
}

}  // namespace marketgen::catalog
