// Vegetables on labels.
#include "assets/print/motif_brush.h"

namespace marketgen::assets {
namespace {

constexpr Color vegetable_green = rgb("#4c9a33");

void one_tomato(Canvas& canvas) {
  const Color red = rgb("#dd2f1f");
  canvas.path(
      "M 0 -26 C 22 -36 44 -22 43 4 C 42 28 22 40 0 40 C -22 40 -42 28 -43 4 C -44 -22 -22 -36 0 "
      "-26 Z");
  canvas.fill(lit({0, 4, 44}, red));
  gloss(canvas, {-34, -22, 28, 20}, -0.5);
  for (const double angle : {-0.2, 0.75, 2.4, 3.35, 4.1, 5.3})
    leaf(canvas, 0, -25, angle, 22, vegetable_green);
  canvas.path("M 0 -25 C 0 -32 2 -36 5 -40").stroke(darker(vegetable_green, 0.3), 4);
}

void one_carrot(Canvas& canvas) {
  const Color orange = rgb("#f07c1a");
  for (const double angle : {-2.0, -1.75, -1.45, -1.15})
    leaf(canvas, 0, -22, angle, 30, vegetable_green);
  canvas.path(
      "M -13 -20 C -8 -27 8 -27 13 -20 C 15 -6 6 26 1 46 C 0 48 -1 48 -2 46 C -7 26 -16 -6 -13 -20 "
      "Z");
  canvas.fill(Paint::linear(
      -13, 0, 14, 4, {{0, lighter(orange, 0.35)}, {0.45, orange}, {1, darker(orange, 0.38)}}));
  canvas.path("M -12 -10 L -3 -8 M 12 -2 L 4 0 M -10 8 L -3 10 M 7 18 L 2 19 M -5 26 L -1 27");
  canvas.stroke(faded(darker(orange, 0.4), 0.55), 1.6);
}

void one_mushroom(Canvas& canvas, const Color& cap) {
  canvas.path("M -13 4 C -14 20 -17 30 -18 36 C -10 42 10 42 18 36 C 17 30 14 20 13 4 Z");
  canvas.fill(Paint::linear(
      -16, 0, 18, 0, {{0, rgb("#fffaf0")}, {0.6, rgb("#f0e2c8")}, {1, rgb("#bda787")}}));
  canvas.path("M -40 6 C -44 -24 -22 -38 0 -38 C 22 -38 44 -24 40 6 C 24 14 -24 14 -40 6 Z");
  canvas.fill(lit({0, -10, 42}, cap));
  canvas.path("M -40 6 C -24 14 24 14 40 6 C 26 1 -26 1 -40 6 Z").fill(darker(cap, 0.45));
  gloss(canvas, {-28, -32, 30, 16}, -0.4, 0.55);
}

void one_chili(Canvas& canvas, const Color& red) {
  canvas.path(
      "M -28 -22 C -16 -34 -2 -28 2 -16 C 8 6 20 22 42 30 C 22 40 -8 28 -20 6 C -26 -4 -32 -14 -28 "
      "-22 Z");
  canvas.fill(Paint::linear(
      -24, 16, 14, -10, {{0, darker(red, 0.4)}, {0.5, red}, {1, lighter(red, 0.35)}}));
  canvas.path("M -6 -18 C -2 0 8 14 22 24").stroke(faded(paper_white, 0.6), 2.6);
  canvas
      .path("M -30 -20 C -24 -32 -8 -34 0 -22 C -6 -24 -10 -20 -14 -22 C -18 -18 -24 -20 -30 -20 Z")
      .fill(vegetable_green);
  canvas.path("M -18 -28 C -20 -36 -26 -40 -34 -42").stroke(darker(vegetable_green, 0.2), 4);
}

void one_bean(Canvas& canvas, const Color& base) {
  canvas.path(
      "M -22 -6 C -20 -20 0 -24 14 -18 C 28 -12 30 8 18 16 C 10 21 4 12 -2 9 C -10 5 -24 10 -22 -6 "
      "Z");
  canvas.fill(lit({2, -4, 26}, base));
  gloss(canvas, {-14, -16, 22, 9}, -0.1, 0.6);
}

// A round with the crease and the little beak that tell it from a pea.
void one_chickpea(Canvas& canvas, const Color& base) {
  canvas.path(
      "M -17 2 C -18 -14 -4 -21 8 -17 C 14 -22 19 -19 17 -12 C 23 0 14 18 -1 18 C -11 18 -17 11 "
      "-17 2 Z");
  canvas.fill(lit({0, 0, 21}, base));
  canvas.path("M 15 -15 C 6 -8 -1 0 -2 14").stroke(faded(darker(base, 0.45), 0.55), 1.8);
  gloss(canvas, {-12, -13, 14, 9}, -0.5, 0.55);
}

// A flat disc seen aslant.
void one_lentil(Canvas& canvas, const Color& base) {
  canvas.ellipse(0, 0, 14, 10).fill(lit({0, 0, 15}, base));
  canvas.ellipse(0, -1, 9, 5.5).fill(faded(lighter(base, 0.3), 0.6));
}

void one_olive(Canvas& canvas, double x, double y, const Color& base) {
  placed(canvas, x, y, 0.5, 1, [&] {
    canvas.ellipse(0, 0, 11, 14).fill(lit({0, 0, 14}, base));
    gloss(canvas, {-8, -10, 8, 11}, 0.3);
  });
}

void one_potato(Canvas& canvas, const Color& base) {
  canvas.path(
      "M -36 4 C -38 -18 -16 -28 4 -26 C 26 -25 42 -12 38 8 C 34 26 10 28 -8 26 C -24 25 -35 18 "
      "-36 4 Z");
  canvas.fill(lit({0, 0, 38}, base));
  constexpr double eyes[][2] = {{-18, -8}, {4, 6}, {18, -8}, {-8, 16}, {24, 8}, {-24, 8}, {6, -16}};
  for (const auto& [x, y] : eyes)
    canvas.ellipse(x, y, 2.6, 1.3).fill(faded(darker(base, 0.5), 0.55));
}

}  // namespace

void draw_motif_tomato(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 28, 94, 18});
  placed(canvas, 22, -8, 0.25, 0.62, [&] { one_tomato(canvas); });
  placed(canvas, -10, 4, -0.1, 0.86, [&] { one_tomato(canvas); });
}

void draw_motif_carrot(Canvas& canvas, const MotifInk&) {
  placed(canvas, 12, 2, -0.5, 0.95, [&] { one_carrot(canvas); });
  placed(canvas, -12, 2, 0.5, 0.95, [&] { one_carrot(canvas); });
  placed(canvas, 0, 2, 0.0, 1.0, [&] { one_carrot(canvas); });
}

void draw_motif_corn(Canvas& canvas, const MotifInk&) {
  const Color kernel = rgb("#f8c628");
  leaf(canvas, 2, 46, -1.05, 72, lighter(vegetable_green, 0.12));
  {
    const Canvas::Saved saved = canvas.saved();
    canvas.path("M -17 38 C -22 0 -18 -38 0 -47 C 18 -38 22 0 17 38 C 8 46 -8 46 -17 38 Z").clip();
    canvas.rectangle({-25, -50, 50, 100}).fill(darker(kernel, 0.45));
    for (int row = 0; row < 15; ++row) {
      for (int column = -2; column <= 2; ++column) {
        const double x = column * 8.2;
        const double y = -45 + row * 6.6 + (column % 2 == 0 ? 0.0 : 2.4);
        canvas.ellipse(x, y, 4.4, 3.6)
            .fill(lit({x, y, 4.4}, column == 2 ? darker(kernel, 0.15) : kernel));
      }
    }
  }
  leaf(canvas, 0, 48, -2.05, 74, vegetable_green);
  leaf(canvas, 2, 48, -1.35, 52, darker(vegetable_green, 0.12));
}

void draw_motif_mushroom(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 30, 94, 18});
  placed(canvas, 20, 8, 0.15, 0.66, [&] { one_mushroom(canvas, rgb("#e9dcc3")); });
  placed(canvas, -10, 0, -0.1, 0.9, [&] { one_mushroom(canvas, rgb("#b98a5a")); });
}

void draw_motif_chili(Canvas& canvas, const MotifInk&) {
  placed(canvas, 6, -2, 0.5, 0.86, [&] { one_chili(canvas, rgb("#b5141c")); });
  placed(canvas, -6, 8, -0.05, 0.98, [&] { one_chili(canvas, rgb("#dd1f22")); });
}

void draw_motif_olive(Canvas& canvas, const MotifInk&) {
  const Color silver_green = rgb("#6f8f4a");
  canvas.path("M -46 -26 C -16 -34 18 -22 46 8").stroke(rgb("#6d5a35"), 3);
  for (const double x : {-38.0, -18.0, 4.0, 24.0}) {
    leaf(canvas, x, -27 + (x + 38) * (x + 38) * 0.0055, -0.85, 36, silver_green);
    leaf(canvas, x + 6, -27 + (x + 38) * (x + 38) * 0.0055, 0.95, 30, darker(silver_green, 0.12));
  }
  one_olive(canvas, -16, 16, rgb("#7f9a2e"));
  one_olive(canvas, 10, 24, rgb("#4b2c4a"));
  one_olive(canvas, -6, 32, rgb("#8fa83a"));
}

void draw_motif_potato(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 26, 94, 20});
  placed(canvas, 16, -14, 0.35, 0.75, [&] { one_potato(canvas, rgb("#c9a35f")); });
  placed(canvas, -8, 10, -0.15, 0.98, [&] { one_potato(canvas, rgb("#dcb873")); });
}

void draw_motif_bean(Canvas& canvas, const MotifInk&) {
  const Color dark_red = rgb("#7d1f26");
  const Color cream = rgb("#efe2c2");
  ground_shadow(canvas, {-46, 26, 94, 20}, 0.25);
  placed(canvas, -20, -18, 0.3, 0.85, [&] { one_bean(canvas, dark_red); });
  placed(canvas, 22, -20, -0.5, 0.85, [&] { one_bean(canvas, darker(dark_red, 0.15)); });
  placed(canvas, 26, 16, 0.9, 0.85, [&] { one_bean(canvas, cream); });
  placed(canvas, -24, 20, -0.3, 0.9, [&] { one_bean(canvas, dark_red); });
  placed(canvas, 2, 2, 0.1, 0.95, [&] { one_bean(canvas, lighter(dark_red, 0.12)); });
}

void draw_motif_chickpea(Canvas& canvas, const MotifInk&) {
  const Color beige = rgb("#dfb76c");
  ground_shadow(canvas, {-46, 26, 94, 20}, 0.25);
  placed(canvas, -24, -16, 0.4, 1.0, [&] { one_chickpea(canvas, darker(beige, 0.1)); });
  placed(canvas, 20, -20, -0.9, 0.95, [&] { one_chickpea(canvas, beige); });
  placed(canvas, -26, 20, 1.8, 0.95, [&] { one_chickpea(canvas, beige); });
  placed(canvas, 26, 18, 2.6, 1.0, [&] { one_chickpea(canvas, darker(beige, 0.06)); });
  placed(canvas, 0, 4, 0.0, 1.2, [&] { one_chickpea(canvas, lighter(beige, 0.1)); });
}

void draw_motif_lentil(Canvas& canvas, const MotifInk&) {
  const Color kinds[] = {rgb("#d9713c"), rgb("#8a6038"), rgb("#8c8b45")};
  ground_shadow(canvas, {-46, 26, 94, 20}, 0.25);
  // From the back to the front, in rows that grow wider.
  constexpr double rows[][3] = {{-22, 2, 0.5}, {-9, 3, 0.55}, {5, 4, 0.6}, {20, 4, 0.64}};
  int drawn = 0;
  for (const auto& [y, count, scale] : rows) {
    for (int i = 0; i < static_cast<int>(count); ++i) {
      const double x = (i - (count - 1) / 2) * 23 + (drawn % 2 == 0 ? 2 : -2);
      const Color& kind = kinds[(drawn * 5 + i) % 3];
      placed(canvas, x, y + 3 * (drawn % 3), 0.35 * (drawn % 4) - 0.5, 1.6 * scale, [&] {
        one_lentil(canvas, kind);
      });
      ++drawn;
    }
  }
}

}  // namespace marketgen::assets
