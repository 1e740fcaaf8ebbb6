// Leaves, seeds and blossoms on labels.
#include <numbers>

#include "assets/print/motif_brush.h"

namespace marketgen::assets {
namespace {

constexpr Color plant_green = rgb("#3f8a36");
constexpr Color straw = rgb("#d2942a");

void one_coffee_bean(Canvas& canvas, double x, double y, double angle, double size) {
  const Color roast = rgb("#5b3218");
  placed(canvas, x, y, angle, size / 20, [&] {
    canvas.ellipse(0, 0, 15, 21).fill(lit({0, 0, 20}, roast));
    canvas.path("M 2 -20 C -7 -8 8 6 -2 20").stroke(rgb("#2a1408"), 3.2);
    canvas.path("M 5 -18 C -3 -7 11 6 2 18").stroke(faded(rgb("#b98450"), 0.5), 1.2);
    gloss(canvas, {-11, -15, 8, 16}, 0.2, 0.5);
  });
}

void ear_of_wheat(Canvas& canvas) {
  canvas.path("M 0 48 C 1 20 -1 0 0 -30").stroke(darker(straw, 0.15), 2.4);
  for (int i = 0; i < 6; ++i) {
    const double y = 6 - i * 9.0;
    for (const double side : {-1.0, 1.0}) {
      placed(canvas, side * 4.5, y, side * 0.5, 1, [&] {
        canvas.path("M 0 8 C -7 2 -6 -8 0 -12 C 6 -8 7 2 0 8 Z");
        canvas.fill(lit({0, -2, 11}, straw));
        canvas.path("M 0 -12 L 0 -26").stroke(faded(straw, 0.8), 0.9);
      });
    }
  }
  canvas.path("M 0 -36 C -6 -42 -5 -48 0 -52 C 5 -48 6 -42 0 -36 Z")
      .fill(lit({0, -44, 9}, lighter(straw, 0.1)));
}

void petal_ring(Canvas& canvas, int count, double turn, const Color& base) {
  for (int i = 0; i < count; ++i) {
    placed(canvas, 0, 0, turn + i * 2 * std::numbers::pi / count, 1, [&] {
      canvas.path("M 0 0 C -16 -14 -18 -38 -4 -46 C -2 -43 2 -43 4 -46 C 18 -38 16 -14 0 0 Z");
      canvas.fill(Paint::linear(
          0, 0, 0, -46, {{0, darker(base, 0.25)}, {0.5, base}, {1, lighter(base, 0.45)}}));
      canvas.path("M 0 -10 L 0 -34").stroke(faded(darker(base, 0.3), 0.3), 1);
    });
  }
}

void hazelnut(Canvas& canvas, double x, double y, double size) {
  placed(canvas, x, y, -0.2, size / 20, [&] {
    canvas.path("M 0 -22 C 18 -18 22 2 14 14 C 8 20 -8 20 -14 14 C -22 2 -18 -18 0 -22 Z");
    canvas.fill(lit({0, 0, 22}, rgb("#a5682e")));
    canvas.path("M -15 12 C -8 22 8 22 15 12 C 8 8 -8 8 -15 12 Z").fill(rgb("#d9b98a"));
    gloss(canvas, {-13, -15, 12, 18}, 0.3, 0.6);
  });
}

void almond(Canvas& canvas, double x, double y, double angle) {
  placed(canvas, x, y, angle, 1, [&] {
    canvas.path("M 0 -26 C 14 -14 18 8 10 18 C 4 24 -4 24 -10 18 C -18 8 -14 -14 0 -26 Z");
    canvas.fill(lit({0, 0, 24}, rgb("#b4773a")));
    canvas.path("M 0 -20 C -1 -4 -1 8 0 18 M -5 -10 C -8 0 -8 8 -6 15 M 5 -10 C 8 0 8 8 6 15");
    canvas.stroke(faded(rgb("#6f4218"), 0.5), 1.4);
  });
}

}  // namespace

void draw_motif_leaf(Canvas& canvas, const MotifInk&) {
  leaf(canvas, -8, 40, -2.1, 64, darker(plant_green, 0.08));
  leaf(canvas, -4, 40, -0.75, 66, lighter(plant_green, 0.10));
  leaf(canvas, -6, 42, -1.42, 88, plant_green);
}

void draw_motif_tea_leaf(Canvas& canvas, const MotifInk&) {
  const Color tea = rgb("#5c9a2c");
  canvas.path("M -2 48 C 0 30 0 20 0 6").stroke(darker(tea, 0.2), 3.6);
  leaf(canvas, 0, 26, -0.55, 52, tea);
  leaf(canvas, 0, 18, -2.6, 52, darker(tea, 0.1));
  leaf(canvas, 0, 10, -1.15, 46, lighter(tea, 0.1));
  leaf(canvas, 0, 10, -1.9, 40, lighter(tea, 0.2));
  leaf(canvas, 0, 8, -1.5, 56, lighter(tea, 0.28));
}

void draw_motif_coffee_bean(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 20, 94, 24});
  one_coffee_bean(canvas, -22, -14, 0.9, 20);
  one_coffee_bean(canvas, 22, -16, -0.6, 20);
  one_coffee_bean(canvas, 26, 20, 1.2, 20);
  one_coffee_bean(canvas, -26, 22, -0.8, 20);
  one_coffee_bean(canvas, 0, 6, 0.4, 25);
}

void draw_motif_wheat(Canvas& canvas, const MotifInk&) {
  placed(canvas, -7, 6, -0.40, 0.84, [&] { ear_of_wheat(canvas); });
  placed(canvas, 7, 6, 0.40, 0.84, [&] { ear_of_wheat(canvas); });
  placed(canvas, 0, 6, 0, 0.90, [&] { ear_of_wheat(canvas); });
}

void draw_motif_hop(Canvas& canvas, const MotifInk&) {
  const Color hop_green = rgb("#86b13c");
  leaf(canvas, 0, -26, 0.1, 46, plant_green);
  leaf(canvas, 0, -26, 3.04, 46, darker(plant_green, 0.1));
  canvas.path("M 0 -28 C 0 -38 4 -44 8 -49").stroke(darker(plant_green, 0.2), 3.4);
  constexpr double half_widths[] = {15, 22, 25, 24, 20, 14, 7};
  for (int row = 6; row >= 0; --row) {
    const double w = half_widths[row];
    const double y = -24 + row * 9.5;
    for (const double x : {-w * 0.62, w * 0.62, 0.0}) {
      placed(canvas, x, y, -x * 0.012, w / 24, [&] {
        canvas.path("M -13 -8 C -14 6 -6 16 0 22 C 6 16 14 6 13 -8 C 6 -13 -6 -13 -13 -8 Z");
        canvas.fill(Paint::linear(
            -10,
            -10,
            8,
            22,
            {{0, lighter(hop_green, 0.42)}, {0.5, hop_green}, {1, darker(hop_green, 0.38)}}));
      });
    }
  }
}

void draw_motif_flower(Canvas& canvas, const MotifInk& ink) {
  const Color petal = contrast(ink.accent, ink.primary) > 1.6 ? ink.accent : rgb("#c77fd0");
  leaf(canvas, 8, 12, 0.6, 40, plant_green);
  leaf(canvas, -8, 12, 2.5, 40, plant_green);
  petal_ring(canvas, 6, 0.5, darker(petal, 0.12));
  petal_ring(canvas, 6, 0.0, lighter(petal, 0.18));
  ball(canvas, {0, 0, 11}, rgb("#f2b81f"));
}

void draw_motif_nut(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 24, 94, 20});
  almond(canvas, 26, 0, 0.7);
  hazelnut(canvas, -20, -6, 26);
  hazelnut(canvas, 8, 20, 22);
  leaf(canvas, -20, -28, -0.5, 34, plant_green);
}

void draw_motif_rice(Canvas& canvas, const MotifInk& ink) {
  const Color bowl = contrast(ink.primary, paper_white) > 2 ? ink.primary : rgb("#27508c");
  ground_shadow(canvas, {-46, 34, 94, 14});
  canvas.path("M -40 0 C -38 -24 -18 -36 0 -36 C 18 -36 38 -24 40 0 Z")
      .fill(lit({0, -6, 42}, rgb("#fbf7ea")));
  constexpr double grains[][3] = {{-24, -14, 0.4},
                                  {-10, -24, -0.3},
                                  {6, -27, 0.8},
                                  {20, -18, -0.6},
                                  {-2, -12, 0.2},
                                  {12, -8, 1.1},
                                  {-16, -4, -0.8},
                                  {28, -6, 0.5},
                                  {-30, -4, 1.0},
                                  {2, -20, -1.0}};
  for (const auto& [x, y, angle] : grains) {
    placed(canvas, x, y, angle, 1, [&] {
      canvas.ellipse(0.5, 0.8, 6, 2.2).fill(faded(rgb("#a89c78"), 0.6));
      canvas.ellipse(0, 0, 6, 2.1).fill(rgb("#ffffff"));
    });
  }
  canvas.path("M -46 -2 L 46 -2 C 44 24 26 40 14 42 L -14 42 C -26 40 -44 24 -46 -2 Z");
  canvas.fill(Paint::linear(
      -40, 0, 40, 30, {{0, lighter(bowl, 0.35)}, {0.4, bowl}, {1, darker(bowl, 0.45)}}));
  canvas.path("M -46 -2 L 46 -2").stroke(lighter(bowl, 0.75), 3);
}

}  // namespace marketgen::assets
