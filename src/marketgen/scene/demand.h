// How much a product is asked for beside others of its kind.
#pragma once
#include "catalog/product.h"

namespace marketgen::scene {

// 1 on the mean, 0.3 to 31: that of rank share r among all is asked for as r^(-3/4), so that on
// shelves of equal room the first fifth has 61 % of the sales. The same for a SKU in every store.
double demand_of(const catalog::Product& product);

}  // namespace marketgen::scene
