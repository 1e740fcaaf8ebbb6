// The pictures of products that a catalogue shows an agent: each by itself and as new, from its six
// sides, in the light of the room in which the episodes play.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "agent/known_products.h"

namespace marketgen::episodes {

// Of each of them, in their order: the same whichever others there are. Room, light and textures
// are made once for all. Errors: those of Renderer.
Result<std::vector<agent::ProductPictures>> product_pictures(
    std::span<const catalog::Product* const> products);

// Changes with the sources that decide these pictures.
std::string product_pictures_key();

}  // namespace marketgen::episodes
