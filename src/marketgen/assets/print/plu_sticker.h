// The small oval sticker on loose fruit: a grower's name and the price look-up code.
#pragma once
#include "assets/print/pack_art.h"
#include "geometry/image.h"

namespace marketgen::assets {

// Loose goods with a code whose skin holds a sticker; not bunches, leaves, roots with soil.
bool carries_plu_sticker(const catalog::Product& product);

// Puts it on the front of a skin that covers the product's whole sheet.
void put_plu_sticker(Image& skin, const PackArt& art);

}  // namespace marketgen::assets
