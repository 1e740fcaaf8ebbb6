#include "assets/print/motif_brush.h"

namespace marketgen::assets {

Paint lit(const Ball& body, const Color& base) {
  const double r = body.radius;
  return Paint::radial(body.x,
                       body.y,
                       r * 1.08,
                       body.x - 0.38 * r,
                       body.y - 0.42 * r,
                       {{0, lighter(base, 0.42)},
                        {0.35, lighter(base, 0.10)},
                        {0.68, base},
                        {0.90, darker(base, 0.22)},
                        {1, darker(base, 0.40)}});
}

Paint lit_across(const Area& area, const Color& base) {
  return Paint::linear(area.x,
                       area.y,
                       area.right(),
                       area.bottom(),
                       {{0, lighter(base, 0.30)}, {0.45, base}, {1, darker(base, 0.35)}});
}

void ball(Canvas& canvas, const Ball& body, const Color& base) {
  canvas.circle(body.x, body.y, body.radius).fill(lit(body, base));
  const double r = body.radius;
  gloss(canvas, {body.x - 0.62 * r, body.y - 0.70 * r, 0.62 * r, 0.40 * r}, -0.6);
}

void gloss(Canvas& canvas, const Area& area, double angle, double strength) {
  placed(canvas, area.center_x(), area.center_y(), angle, 1, [&] {
    canvas.scale(area.w / 2, area.h / 2);
    canvas.circle(0, 0, 1);
    canvas.fill(Paint::radial(0,
                              0,
                              1,
                              0,
                              0,
                              {{0, faded(paper_white, strength)},
                               {0.5, faded(paper_white, strength * 0.6)},
                               {1, faded(paper_white, 0)}}));
  });
}

void ground_shadow(Canvas& canvas, const Area& area, double strength) {
  const Color shade{0.08, 0.05, 0.02};
  placed(canvas, area.center_x(), area.center_y(), 0, 1, [&] {
    canvas.scale(area.w / 2, area.h / 2);
    canvas.circle(0, 0, 1);
    canvas.fill(Paint::radial(0,
                              0,
                              1,
                              0,
                              0,
                              {{0, faded(shade, strength)},
                               {0.55, faded(shade, strength * 0.55)},
                               {1, faded(shade, 0)}}));
  });
}

void leaf(Canvas& canvas, double x, double y, double angle, double length, const Color& base) {
  placed(canvas, x, y, angle, length / 100, [&] {
    canvas.path("M 0 0 C 20 -34 66 -38 100 -4 C 66 30 22 30 0 0 Z");
    canvas.fill(Paint::linear(
        20, -30, 60, 34, {{0, lighter(base, 0.35)}, {0.5, base}, {1, darker(base, 0.35)}}));
    canvas.path("M 2 0 C 34 -6 66 -8 94 -4");
    canvas.stroke(faded(lighter(base, 0.55), 0.8), 2.2);
    canvas.path("M 28 -4 L 44 -20 M 50 -6 L 66 -21 M 30 -4 L 48 12 M 54 -6 L 70 9");
    canvas.stroke(faded(lighter(base, 0.5), 0.45), 1.4);
  });
}

}  // namespace marketgen::assets
