// The strokes that label motifs share: bodies lit from the upper left, gloss, shadows, leaves.
#pragma once
#include "assets/print/label_motif.h"

namespace marketgen::assets {

#define MOTIF(name, use, description) void draw_motif_##name(Canvas& canvas, const MotifInk& ink);
#include "assets/print/label_motifs.inc"
#undef MOTIF

struct Ball {
  double x = 0, y = 0, radius = 10;
};

// Round shading for a body that fills about the circle: bright towards the light, dark at the lower
// right rim.
Paint lit(const Ball& body, const Color& base);
// Brightness that falls across from top left to bottom right over the area, for flat or long
// bodies.
Paint lit_across(const Area& area, const Color& base);

void ball(Canvas& canvas, const Ball& body, const Color& base);  // a shaded, glossy ball
// A soft highlight, an ellipse turned by `angle` (radians).
void gloss(Canvas& canvas, const Area& area, double angle, double strength = 0.75);
// A soft, flat shadow on the ground; fades out to the area's rim.
void ground_shadow(Canvas& canvas, const Area& area, double strength = 0.35);
// A leaf from its foot at (x, y), pointing along `angle` (0 = right, y down), with a mid rib.
void leaf(Canvas& canvas, double x, double y, double angle, double length, const Color& base);
// Runs `draw` in a frame moved to (x, y), turned and scaled; not at all when nothing would be left.
template <class Draw>
void placed(Canvas& canvas, double x, double y, double angle, double scale, Draw draw) {
  if (scale <= 0) return;
  const Canvas::Saved saved = canvas.saved();
  canvas.translate(x, y);
  canvas.rotate(angle);
  canvas.scale(scale, scale);
  draw();
}

}  // namespace marketgen::assets
