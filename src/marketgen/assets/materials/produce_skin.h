// Skins of loose fruit and vegetables: what wraps round the mesh instead of a printed label.
#pragma once
#include "assets/print/pack_art.h"
#include "geometry/image.h"

namespace marketgen::assets {

// The row's primary colour is that of the body; produce_skins.inc says what else there is to see.
// u runs once around and tiles, v from the stem (top) to the other end. What produce_skins.inc does
// not know gets a smooth skin in the row's own colours: secondary at the stem, primary, accent at
// the end.
Image draw_produce_skin(const PackArt& art, int width_px, int height_px);

}  // namespace marketgen::assets
