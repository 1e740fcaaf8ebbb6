// Glasses and cups on labels.
#include "assets/print/motif_brush.h"

namespace marketgen::assets {

void draw_motif_beer_mug(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-40, 38, 82, 10});
  canvas.path("M 20 -12 C 46 -14 46 30 20 28").stroke(rgb("#b9c6cf"), 9);
  canvas.path("M 20 -12 C 44 -13 44 29 20 27").stroke(rgb("#eef4f7"), 3.6);
  const Area glass{-30, -22, 52, 66};
  canvas.rounded(glass, 6).fill(rgb("#dfe9ee"));
  canvas.rounded(glass.inset(4), 4)
      .fill(Paint::linear(
          -30, 0, 24, 0, {{0, rgb("#fbc944")}, {0.5, rgb("#f3a51c")}, {1, rgb("#b86c0c")}}));
  for (const double x : {-17.0, -4.0, 9.0})
    canvas.rounded({x - 4, -10, 8, 46}, 4).fill(faded(rgb("#ffe79a"), 0.65));
  for (const Ball& foam : {Ball{-24, -24, 11},
                           Ball{-10, -32, 12},
                           Ball{6, -32, 12},
                           Ball{18, -24, 10},
                           Ball{-2, -22, 12},
                           Ball{-31, -12, 6}})
    canvas.circle(foam.x, foam.y, foam.radius)
        .fill(Paint::radial(foam.x,
                            foam.y,
                            foam.radius,
                            foam.x - 3,
                            foam.y - 4,
                            {{0, paper_white}, {0.7, rgb("#fffbea")}, {1, rgb("#e6dab4")}}));
  gloss(canvas, {-27, -4, 8, 38}, 0, 0.6);
}

void draw_motif_wine_glass(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-30, 40, 62, 10});
  const Color glass = rgb("#d7e4ec");
  canvas.ellipse(0, 43, 20, 5).fill_and_stroke(faded(glass, 0.9), rgb("#90a6b4"), 1.2);
  canvas.path("M -2.5 12 L -2.5 42 L 2.5 42 L 2.5 12 Z").fill(lit_across({-3, 10, 6, 32}, glass));
  canvas.path("M -20 -46 C -30 -14 -22 14 0 16 C 22 14 30 -14 20 -46 Z")
      .fill_and_stroke(faded(glass, 0.55), rgb("#90a6b4"), 1.6);
  canvas.path("M -25 -22 C -26 0 -16 12 0 13 C 16 12 26 0 25 -22 Z");
  canvas.fill(Paint::linear(
      -24, -10, 22, 8, {{0, rgb("#c0324e")}, {0.4, rgb("#8e1230")}, {1, rgb("#4c0618")}}));
  canvas.ellipse(0, -22, 25, 4.6).fill(rgb("#a8203f"));
  gloss(canvas, {-20, -38, 9, 44}, 0.08, 0.75);
}

void draw_motif_cup(Canvas& canvas, const MotifInk& ink) {
  const Color china = contrast(ink.secondary, ink.primary) > 1.6 ? ink.secondary : rgb("#f3efe6");
  ground_shadow(canvas, {-50, 28, 100, 18});
  canvas.ellipse(-2, 36, 46, 10).fill(lit({-2, 36, 46}, darker(china, 0.08)));
  canvas.ellipse(-2, 34, 38, 7).fill(lighter(china, 0.3));
  canvas.path("M 28 -2 C 48 -8 48 20 24 20").stroke(darker(china, 0.25), 7);
  canvas.path("M 28 -2 C 46 -7 46 19 24 19").stroke(lighter(china, 0.2), 3.4);
  canvas.path("M -36 -8 C -36 20 -22 34 -12 35 L 8 35 C 18 34 32 20 32 -8 Z");
  canvas.fill(Paint::linear(
      -34, 0, 32, 20, {{0, lighter(china, 0.5)}, {0.45, china}, {1, darker(china, 0.35)}}));
  canvas.ellipse(-2, -8, 34, 10).fill(lighter(china, 0.4));
  canvas.ellipse(-2, -7, 30, 8)
      .fill(Paint::radial(
          -2, -7, 30, -6, -9, {{0, rgb("#e8c79a")}, {0.35, rgb("#b07a44")}, {1, rgb("#5b3016")}}));
  for (const double x : {-16.0, -2.0, 12.0}) {
    placed(canvas, x, -18, 0, 1, [&] {
      canvas.path("M 0 4 C -7 -4 7 -10 0 -18 C -4 -22 -3 -25 -1 -28");
      canvas.stroke(Paint::linear(0,
                                  4,
                                  0,
                                  -28,
                                  {{0, faded(paper_white, 0.1)},
                                   {0.4, faded(paper_white, 0.85)},
                                   {1, faded(paper_white, 0)}}),
                    3.4);
    });
  }
}

}  // namespace marketgen::assets
