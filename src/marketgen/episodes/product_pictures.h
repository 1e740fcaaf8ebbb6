// The pictures of a product that a catalogue shows an agent: from its six sides, in the light of
// the room in which the episodes play.
#pragma once
#include <vector>

#include "agent/known_products.h"

namespace marketgen::episodes {

// Errors: those of Renderer.
Result<std::vector<agent::ProductPicture>> product_pictures(const catalog::Product& product);

}  // namespace marketgen::episodes
