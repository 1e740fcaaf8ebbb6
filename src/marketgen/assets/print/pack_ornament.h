// Ornaments that pack designs share: tone-on-tone patterns, glows, waves.
#pragma once
#include "assets/print/canvas.h"

namespace marketgen::assets {

// Fine pattern number 0..3 (none, dots, slanting lines, rings) of `color` over the area, in steps
// of `pitch`.
void draw_pattern(Canvas& canvas, int pattern, const Area& area, double pitch, const Color& color);
// A soft round light.
void draw_glow(
    Canvas& canvas, double x, double y, double radius, const Color& color, double strength);
// Fills from a wavy upper edge round y down to `area`'s bottom; whole waves along x, so that the
// ends join.
void fill_below_wave(
    Canvas& canvas, const Area& area, double y, double height, int waves, const Paint& paint);

}  // namespace marketgen::assets
