// The shape of a pack by itself: product_model.h adds what is seen through its walls.
#pragma once
#include "assets/product_model.h"

namespace marketgen::assets {

// As make_product_model(), without walls parted at the level of the contents: what the pack touches
// with does not depend on how full it is. Errors: as make_product_model.
Result<ProductModel> make_pack_shape(const catalog::Product& product, Detail detail = Detail::near);

}  // namespace marketgen::assets
