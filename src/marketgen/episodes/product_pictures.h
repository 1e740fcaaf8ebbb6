// The pictures of a product that a catalogue shows an agent: from its six sides, in the light of
// the room in which the episodes play.
#pragma once
#include <vector>

#include "agent/known_products.h"

namespace marketgen {

// Errors: those of Renderer.
Result<std::vector<ProductPicture>> product_pictures(const Product& product);

}  // namespace marketgen
