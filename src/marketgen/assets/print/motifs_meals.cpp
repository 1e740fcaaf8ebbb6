// Fish, meat and dishes on labels.
#include <numbers>

#include "assets/print/motif_brush.h"

namespace marketgen::assets {
namespace {

constexpr Color parsley_green = rgb("#3f8f3a");

// A bowl seen slightly from above, filled with `filling`; its rim is an ellipse round (0, -2).
void bowl_of(Canvas& canvas, const Color& bowl, const Color& filling) {
  ground_shadow(canvas, {-46, 32, 94, 14});
  canvas.path("M -46 -2 C -44 26 -24 40 -14 42 L 14 42 C 24 40 44 26 46 -2 Z");
  canvas.fill(Paint::linear(
      -40, 0, 40, 30, {{0, lighter(bowl, 0.4)}, {0.4, bowl}, {1, darker(bowl, 0.45)}}));
  canvas.ellipse(0, -2, 46, 17).fill(lighter(bowl, 0.8));
  canvas.ellipse(0, -1, 41, 14)
      .fill(
          Paint::radial(0,
                        -1,
                        41,
                        -10,
                        -6,
                        {{0, lighter(filling, 0.25)}, {0.6, filling}, {1, darker(filling, 0.3)}}));
}

void steam(Canvas& canvas, double x) {
  placed(canvas, x, -22, 0, 1, [&] {
    canvas.path("M 0 4 C -7 -4 7 -10 0 -18 C -4 -22 -3 -25 -1 -28");
    canvas.stroke(Paint::linear(0,
                                4,
                                0,
                                -28,
                                {{0, faded(paper_white, 0)},
                                 {0.4, faded(paper_white, 0.8)},
                                 {1, faded(paper_white, 0)}}),
                  3.4);
  });
}

void basil(Canvas& canvas, double x, double y) {
  leaf(canvas, x, y, -0.5, 15, parsley_green);
  leaf(canvas, x, y, -2.4, 14, darker(parsley_green, 0.1));
  leaf(canvas, x, y, 1.4, 12, lighter(parsley_green, 0.1));
}

}  // namespace

void draw_motif_fish(Canvas& canvas, const MotifInk&) {
  const Color silver = rgb("#7fa3b8");
  placed(canvas, 0, 0, -0.18, 1, [&] {
    canvas.path("M 26 0 C 34 -6 42 -16 49 -20 C 45 -8 45 8 49 20 C 42 16 34 6 26 0 Z")
        .fill(lit_across({26, -20, 22, 40}, darker(silver, 0.1)));
    canvas.path("M -10 -18 C 0 -30 14 -30 20 -14 Z").fill(darker(silver, 0.2));
    canvas.path("M -48 2 C -38 -20 -4 -26 32 -2 C 34 0 34 1 32 2 C -2 26 -36 22 -48 2 Z");
    canvas.fill(Paint::linear(
        0,
        -22,
        0,
        22,
        {{0, rgb("#3d6b86")}, {0.35, silver}, {0.6, rgb("#dfe9ee")}, {1, rgb("#a9bcc6")}}));
    canvas.path("M -8 8 C 0 20 8 22 14 18 C 10 14 6 10 4 6 Z").fill(darker(silver, 0.05));
    for (int i = 0; i < 5; ++i) {
      placed(canvas, -14 + i * 9.0, 0, 0, 1, [&] {
        canvas.path("M 0 -9 C 5 -6 5 -2 0 0 C 5 2 5 6 0 9")
            .stroke(faded(rgb("#33566a"), 0.35), 1.2);
      });
    }
    canvas.path("M -27 -12 C -21 -4 -21 6 -27 14").stroke(faded(rgb("#28485a"), 0.7), 1.8);
    canvas.circle(-36, -3, 3.6).fill(paper_white);
    canvas.circle(-36.4, -3, 2.1).fill(rgb("#10222c"));
    gloss(canvas, {-30, -16, 44, 9}, 0.08, 0.5);
  });
  leaf(canvas, -20, 36, -0.1, 40, parsley_green);
}

void draw_motif_meat(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 24, 94, 20});
  canvas.path(
      "M -44 4 C -48 -20 -22 -36 4 -32 C 28 -30 48 -16 45 6 C 43 22 24 20 14 26 C 2 33 -10 40 -26 "
      "34 C -38 29 -43 18 -44 4 Z");
  canvas.fill(rgb("#f3d9c4"));
  canvas.path(
      "M -38 3 C -41 -15 -20 -29 4 -26 C 26 -24 41 -13 39 4 C 37 15 22 14 11 20 C 0 26 -10 33 -24 "
      "28 C -33 25 -37 14 -38 3 Z");
  canvas.fill(Paint::radial(
      0, 0, 44, -12, -12, {{0, rgb("#d9473f")}, {0.6, rgb("#b32a2a")}, {1, rgb("#8c1c20")}}));
  canvas.path(
      "M -28 -6 C -18 -12 -12 -8 -4 -14 M -26 10 C -14 4 -8 10 2 4 M 8 -18 C 14 -12 20 -14 28 -8 M "
      "6 8 C 14 2 22 8 30 2 M -18 22 C -10 16 -4 20 4 14");
  canvas.stroke(faded(rgb("#f6d5c6"), 0.85), 2.2);
  canvas.ellipse(-19, -15, 7, 5.5).fill(rgb("#fbeede"));
  canvas.ellipse(-19, -15, 4, 3).fill(rgb("#d9a58a"));
  leaf(canvas, 16, 34, -0.55, 30, parsley_green);
  leaf(canvas, 16, 34, -0.05, 30, darker(parsley_green, 0.1));
}

void draw_motif_chicken(Canvas& canvas, const MotifInk&) {
  const Color roast = rgb("#c9741f");
  ground_shadow(canvas, {-46, 24, 94, 20});
  placed(canvas, 2, 0, -0.12, 1, [&] {
    canvas.path(
        "M 16 12 L 36 26 C 34 32 38 36 42 34 C 46 38 50 32 46 29 C 50 25 46 20 41 22 L 24 4 Z");
    canvas.fill_and_stroke(rgb("#f7eedd"), rgb("#c8b48f"), 1.2);
    canvas.path(
        "M -42 -2 C -44 -26 -18 -38 2 -28 C 18 -20 26 -4 26 8 C 25 16 18 18 10 20 C -8 30 -38 26 "
        "-42 -2 Z");
    canvas.fill(Paint::radial(
        -6,
        0,
        42,
        -18,
        -16,
        {{0, rgb("#f6bd63")}, {0.4, rgb("#dd8e2e")}, {0.75, roast}, {1, rgb("#7c3b0d")}}));
    canvas.path(
        "M -26 8 C -18 14 -6 16 4 12 M -30 -4 C -26 0 -24 2 -20 3 M 4 -14 C 10 -8 13 -2 14 4");
    canvas.stroke(faded(rgb("#7c3b0d"), 0.4), 2.2);
    gloss(canvas, {-32, -26, 30, 18}, -0.4, 0.7);
  });
  leaf(canvas, -34, 34, -0.3, 30, parsley_green);
  leaf(canvas, -34, 34, 0.15, 26, darker(parsley_green, 0.12));
}

void draw_motif_pizza(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-50, -40, 100, 90}, 0.4);
  canvas.circle(0, 0, 46).fill(lit({0, 0, 46}, rgb("#d99a4a")));
  canvas.circle(0, 0, 40).fill(rgb("#c43a1d"));
  canvas.path(
      "M -34 -10 C -30 -34 -6 -40 14 -34 C 34 -26 40 -4 34 14 C 28 32 4 40 -14 34 C -32 26 -38 8 "
      "-34 -10 Z");
  canvas.fill(Paint::radial(
      0, 0, 40, -12, -12, {{0, rgb("#fff0bd")}, {0.6, rgb("#f9d576")}, {1, rgb("#eeb445")}}));
  constexpr double salami[][2] = {
      {-16, -18}, {12, -20}, {24, 4}, {2, 2}, {-22, 8}, {-4, 24}, {18, 24}};
  for (const auto& [x, y] : salami) {
    canvas.circle(x, y, 8.4).fill(lit({x, y, 9}, rgb("#b8322a")));
    canvas.circle(x - 2, y + 2, 1).fill(faded(rgb("#f3c7b0"), 0.8));
    canvas.circle(x + 3, y - 2, 1).fill(faded(rgb("#f3c7b0"), 0.8));
  }
  basil(canvas, -2, -10);
  basil(canvas, 12, 12);
  basil(canvas, -16, 22);
  for (const double angle : {0.5, 1.8, 3.1, 4.5}) {
    placed(canvas, 0, 0, angle, 1, [&] { canvas.circle(30, 0, 3).fill(rgb("#2a2430")); });
  }
}

void draw_motif_noodle(Canvas& canvas, const MotifInk& ink) {
  const Color bowl = contrast(ink.primary, paper_white) > 2 ? ink.primary : rgb("#b3261e");
  bowl_of(canvas, bowl, rgb("#c98333"));
  const Canvas::Saved saved = canvas.saved();
  for (int i = 0; i < 5; ++i) {
    placed(canvas, -24 + i * 12, -2 + (i % 2) * 3, i * 0.2 - 0.4, 1, [&] {
      canvas.path("M -12 4 C -12 -8 12 -8 12 2 C 12 10 -6 10 -6 3 C -6 -3 7 -3 7 2")
          .stroke(rgb("#a8752a"), 4.2);
      canvas.path("M -12 4 C -12 -8 12 -8 12 2 C 12 10 -6 10 -6 3 C -6 -3 7 -3 7 2")
          .stroke(rgb("#f7d47a"), 2.8);
    });
  }
  canvas.circle(20, -6, 6.5).fill(rgb("#fffdf6"));
  canvas.circle(20, -6, 3.4).fill(rgb("#f4a71c"));
  basil(canvas, -12, -8);
  for (const double shift : {0.0, 7.0}) {
    placed(canvas, shift, 0, 0, 1, [&] {
      canvas.path("M 6 -8 L 40 -48").stroke(rgb("#5f3413"), 3.4);
      canvas.path("M 6 -9 L 40 -49").stroke(rgb("#b57a3e"), 1.4);
    });
  }
}

void draw_motif_soup(Canvas& canvas, const MotifInk& ink) {
  const Color bowl = contrast(ink.secondary, rgb("#d9571f")) > 1.5 ? ink.secondary : rgb("#f3efe6");
  for (const double x : {-16.0, 0.0, 16.0})
    steam(canvas, x);
  bowl_of(canvas, darker(bowl, 0.06), rgb("#d9571f"));
  canvas.path("M -20 2 C -10 -8 12 -8 18 0 C 10 8 -4 6 -6 0")
      .stroke(faded(rgb("#fff4dc"), 0.9), 2.6);
  basil(canvas, 0, -2);
}

}  // namespace marketgen::assets
