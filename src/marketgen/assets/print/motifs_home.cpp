// Water, cleanliness and care on labels.
#include <numbers>

#include "assets/print/motif_brush.h"

namespace marketgen::assets {
namespace {

void soap_bubble(Canvas& canvas, const Ball& bubble) {
  const auto [x, y, r] = bubble;
  canvas.circle(x, y, r).fill(Paint::radial(x,
                                            y,
                                            r,
                                            x - 0.2 * r,
                                            y - 0.2 * r,
                                            {{0, faded(rgb("#eaf8ff"), 0.30)},
                                             {0.7, faded(rgb("#bfe6fb"), 0.45)},
                                             {0.9, faded(rgb("#8fc7f2"), 0.75)},
                                             {1, faded(rgb("#ffffff"), 0.95)}}));
  canvas.circle(x, y, r).stroke(faded(rgb("#3f8fcf"), 0.55), 0.9);
  gloss(canvas, {x - 0.65 * r, y - 0.7 * r, 0.7 * r, 0.45 * r}, -0.7, 1);
  gloss(canvas, {x + 0.2 * r, y + 0.42 * r, 0.4 * r, 0.25 * r}, -0.7, 0.7);
}

// A four-pointed star.
void twinkle(Canvas& canvas, double x, double y, double size, const Color& color) {
  placed(canvas, x, y, 0, size / 10, [&] {
    canvas.path("M 0 -10 C 1 -3 3 -1 10 0 C 3 1 1 3 0 10 C -1 3 -3 1 -10 0 C -3 -1 -1 -3 0 -10 Z")
        .fill(color);
  });
}

}  // namespace

void draw_motif_ice(Canvas& canvas, const MotifInk&) {
  const Color ice = rgb("#8fd0f0");
  ball(canvas, {0, 0, 44}, lighter(ice, 0.15));
  for (int arm = 0; arm < 6; ++arm) {
    placed(canvas, 0, 0, arm * std::numbers::pi / 3, 1, [&] {
      canvas.path(
          "M 0 0 L 0 -36 M 0 -14 L -8 -22 M 0 -14 L 8 -22 M 0 -24 L -7 -31 M 0 -24 L 7 -31");
      canvas.stroke(faded(rgb("#2f7fb5"), 0.5), 5.4);
    });
  }
  for (int arm = 0; arm < 6; ++arm) {
    placed(canvas, 0, 0, arm * std::numbers::pi / 3, 1, [&] {
      canvas.path(
          "M 0 0 L 0 -36 M 0 -14 L -8 -22 M 0 -14 L 8 -22 M 0 -24 L -7 -31 M 0 -24 L 7 -31");
      canvas.stroke(paper_white, 3.4);
    });
  }
}

void draw_motif_bubbles(Canvas& canvas, const MotifInk&) {
  for (const Ball& bubble : {Ball{-8, 8, 30},
                             Ball{26, -20, 18},
                             Ball{28, 24, 13},
                             Ball{-30, -28, 12},
                             Ball{-38, 34, 8},
                             Ball{2, -38, 7},
                             Ball{44, 4, 5},
                             Ball{8, 44, 5}}) {
    soap_bubble(canvas, bubble);
  }
}

void draw_motif_water_drop(Canvas& canvas, const MotifInk&) {
  const Color water = rgb("#2a93d6");
  for (const double r : {44.0, 30.0, 16.0})
    canvas.ellipse(0, 38, r, r * 0.22).stroke(faded(lighter(water, 0.5), 0.8), 2.2);
  canvas.path(
      "M 0 -48 C 14 -22 30 -8 30 10 C 30 28 16 38 0 38 C -16 38 -30 28 -30 10 C -30 -8 -14 -22 0 "
      "-48 Z");
  canvas.fill(Paint::radial(
      0,
      6,
      42,
      -8,
      18,
      {{0, rgb("#c9edff")}, {0.45, rgb("#6cc0f0")}, {0.8, water}, {1, rgb("#135f9e")}}));
  gloss(canvas, {-20, -12, 14, 32}, 0.25, 0.95);
  canvas.path("M 18 12 C 18 22 12 28 4 30").stroke(faded(paper_white, 0.7), 2.6);
}

void draw_motif_sparkle(Canvas& canvas, const MotifInk& ink) {
  const Color glow = contrast(ink.accent, ink.primary) > 1.6 ? ink.accent : paper_white;
  canvas.circle(0, 0, 46).fill(
      Paint::radial(0, 0, 46, 0, 0, {{0, faded(glow, 0.75)}, {1, faded(glow, 0)}}));
  twinkle(canvas, -6, 4, 40, lighter(glow, 0.25));
  twinkle(canvas, -6, 4, 26, paper_white);
  twinkle(canvas, 28, -26, 20, paper_white);
  twinkle(canvas, 30, 26, 15, lighter(glow, 0.4));
  twinkle(canvas, -34, -28, 12, paper_white);
}

void draw_motif_tooth(Canvas& canvas, const MotifInk&) {
  canvas.path(
      "M -30 -30 C -18 -42 -8 -32 0 -32 C 8 -32 18 -42 30 -30 C 42 -16 32 4 27 16 C 23 28 22 44 14 "
      "44"
      " C 6 44 8 18 0 18 C -8 18 -6 44 -14 44 C -22 44 -23 28 -27 16 C -32 4 -42 -16 -30 -30 Z");
  canvas.fill_and_stroke(
      Paint::radial(
          0, 0, 52, -12, -16, {{0, paper_white}, {0.55, rgb("#f4fafd")}, {1, rgb("#a9cfe0")}}),
      rgb("#7fb2cc"),
      1.6);
  gloss(canvas, {-28, -30, 20, 26}, 0.4, 1);
  twinkle(canvas, 30, -30, 15, rgb("#38b6e8"));
  twinkle(canvas, 40, -10, 8, rgb("#38b6e8"));
}

void draw_motif_hair(Canvas& canvas, const MotifInk&) {
  // One lock, drawn as strands that lie beside each other and meet at both ends.
  constexpr Color chestnut = rgb("#8a5124");
  constexpr int strands = 15;
  constexpr double middle = 7;
  for (int i = 0; i < strands; ++i) {
    const double s = (i - middle) / middle;  // -1 .. 1 across the lock
    const double light = 1 - (s - 0.25) * (s - 0.25);
    const Color tone = light > 0.6 ? lighter(chestnut, (light - 0.6) * 0.9)
                                   : darker(chestnut, (0.6 - light) * 0.5);
    cairo_t* c = canvas.context();
    cairo_move_to(c, -14 + s * 9, -44);
    cairo_curve_to(c, -40 + s * 24, -16 + s * 6, 42 + s * 20, -4 + s * 12, 10 + s * 12, 22);
    cairo_curve_to(c, 2 + s * 7, 32, -8 + s * 4, 38, -22, 42);
    canvas.stroke(i % 4 == 1 ? lighter(tone, 0.14) : tone, 3.4);
  }
  canvas.path("M -22 -34 C -30 -14 20 -4 26 8").stroke(faded(rgb("#fbe6c2"), 0.5), 2.4);
}

void draw_motif_baby(Canvas& canvas, const MotifInk&) {
  const Color skin = rgb("#f6cfae");
  canvas.circle(-38, 2, 8).fill(lit({-38, 2, 8}, darker(skin, 0.08)));
  canvas.circle(38, 2, 8).fill(lit({38, 2, 8}, darker(skin, 0.08)));
  canvas.circle(0, 0, 40).fill(Paint::radial(
      0, 0, 42, -12, -14, {{0, lighter(skin, 0.5)}, {0.6, skin}, {1, darker(skin, 0.2)}}));
  canvas.path("M -6 -38 C -2 -46 10 -46 10 -38 C 10 -33 3 -33 3 -37").stroke(rgb("#9a6a3a"), 3);
  canvas.ellipse(-21, 10, 8, 6).fill(faded(rgb("#f0857f"), 0.45));
  canvas.ellipse(21, 10, 8, 6).fill(faded(rgb("#f0857f"), 0.45));
  for (const double x : {-14.0, 14.0}) {
    canvas.ellipse(x, -4, 4, 5).fill(rgb("#3a2a22"));
    canvas.circle(x - 1.2, -6, 1.5).fill(paper_white);
  }
  canvas.path("M -11 15 C -6 23 6 23 11 15").stroke(rgb("#a94a44"), 3);
}

void draw_motif_paw(Canvas& canvas, const MotifInk& ink) {
  const Color pad = contrast(ink.secondary, ink.primary) > 2 ? ink.secondary : rgb("#5a3a24");
  canvas.path(
      "M 0 -4 C 16 -4 30 14 28 28 C 26 40 12 36 0 36 C -12 36 -26 40 -28 28 C -30 14 -16 -4 0 -4 "
      "Z");
  canvas.fill(lit({0, 18, 30}, pad));
  constexpr double toes[][3] = {{-33, -2, -0.4}, {-13, -26, -0.12}, {13, -26, 0.12}, {33, -2, 0.4}};
  for (const auto& [x, y, angle] : toes) {
    placed(canvas, x, y, angle, 1, [&] {
      canvas.ellipse(0, 0, 10.5, 14.5).fill(lit({0, 0, 14}, pad));
    });
  }
}

void draw_motif_none(Canvas& canvas, const MotifInk& ink) {
  for (const double r : {46.0, 36.0, 26.0, 16.0}) {
    canvas.circle(0, 0, r).stroke(faded(ink.accent, 0.35 + (46 - r) * 0.015), 3.2);
  }
  ball(canvas, {0, 0, 8}, ink.accent);
}

}  // namespace marketgen::assets
