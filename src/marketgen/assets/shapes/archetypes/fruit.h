// Which way what grew lies, and so how its skin unrolls.
#pragma once
#include "catalog/product.h"

namespace marketgen::assets {

// Whether a grown or baked product's axis lies along X, its stem at the left; else it stands.
bool lies_along_x(const catalog::Product& product);

// Thickness of a banana in a hand, in heights of the hand.
inline constexpr float banana_thickness = 0.30F;

}  // namespace marketgen::assets
