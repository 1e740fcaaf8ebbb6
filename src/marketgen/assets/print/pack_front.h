// The front of a pack, and the smaller faces that repeat it.
#pragma once
#include "assets/print/canvas.h"
#include "assets/print/pack_art.h"

namespace marketgen::assets {

// All in millimetres on the canvas. `area` is what the shopper sees upright; the ground has been
// painted.
void draw_front(Canvas& canvas, const PackArt& art, const Area& area);
// Brand and name alone: lids, tops, lips of trays.
void draw_title(Canvas& canvas, const PackArt& art, const Area& area, const Color& ground);

}  // namespace marketgen::assets
