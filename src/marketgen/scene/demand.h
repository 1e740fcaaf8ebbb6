// How much a product is asked for beside others of its kind.
#pragma once
#include "catalog/product.h"

namespace marketgen::scene {

// 1 on the mean, 0.5 to 5: that of rank share r among all has 0.5 / sqrt(r), so that the first
// fifth of them has 45 % of the sales of a shelf on which all have the same room. The same for a
// SKU in every store.
double demand_of(const catalog::Product& product);

}  // namespace marketgen::scene
