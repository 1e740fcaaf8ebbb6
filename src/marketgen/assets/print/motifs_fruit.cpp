// Fruit on labels.
#include <numbers>

#include "assets/print/motif_brush.h"

namespace marketgen::assets {
namespace {

constexpr Color leaf_green = rgb("#3f8f2f");
constexpr Color stem_brown = rgb("#6b4423");

// A slice of citrus, seen from the cut.
void citrus_slice(
    Canvas& canvas, double x, double y, double radius, const Color& rind, const Color& flesh) {
  canvas.circle(x, y, radius).fill(lit({x, y, radius}, rind));
  canvas.circle(x, y, radius * 0.90).fill(rgb("#fff3d6"));
  constexpr int segments = 9;
  for (int i = 0; i < segments; ++i) {
    placed(canvas, x, y, i * 2 * std::numbers::pi / segments, radius / 100, [&] {
      canvas.path("M 7 0 C 30 -24 58 -30 77 -24 C 85 -12 85 12 77 24 C 58 30 30 24 7 0 Z");
      canvas.fill(Paint::linear(
          10, 0, 84, 0, {{0, lighter(flesh, 0.45)}, {0.7, flesh}, {1, darker(flesh, 0.06)}}));
      canvas.path("M 34 -6 L 60 -10 M 44 7 L 70 10 M 58 0 L 74 -1");
      canvas.stroke(faded(paper_white, 0.5), 2.4);
    });
  }
  gloss(canvas, {x - radius * 0.75, y - radius * 0.8, radius * 0.9, radius * 0.5}, -0.6, 0.4);
}

void strawberry(Canvas& canvas) {
  const Color red = rgb("#d81f2d");
  canvas.path(
      "M 0 -26 C 24 -36 42 -22 36 2 C 31 24 12 40 0 44 C -12 40 -31 24 -36 2 C -42 -22 -24 -36 0 "
      "-26 Z");
  canvas.fill(lit({0, 4, 42}, red));
  constexpr double seeds[][2] = {{-22, -10},
                                 {-6, -12},
                                 {10, -11},
                                 {25, -9},
                                 {-26, 4},
                                 {-13, 2},
                                 {2, 3},
                                 {17, 3},
                                 {28, 4},
                                 {-17, 15},
                                 {-4, 16},
                                 {10, 16},
                                 {20, 14},
                                 {-8, 28},
                                 {6, 28}};
  for (const auto& [x, y] : seeds) {
    canvas.ellipse(x, y + 0.8, 1.9, 2.7).fill(faded(rgb("#7a0d14"), 0.7));
    canvas.ellipse(x, y, 1.5, 2.3).fill(rgb("#f6d27a"));
  }
  gloss(canvas, {-27, -24, 26, 20}, -0.5, 0.6);
  for (const double angle : {3.5, 4.1, 5.3, 5.9, 0.45, 2.7})
    leaf(canvas, 0, -28, angle, 24, leaf_green);
  canvas.path("M 0 -28 C 1 -36 4 -40 8 -44").stroke(darker(leaf_green, 0.2), 3);
}

void blueberry(Canvas& canvas, double x, double y, double radius) {
  ball(canvas, {x, y, radius}, rgb("#3b4f9a"));
  placed(canvas, x + radius * 0.15, y - radius * 0.25, 0.2, radius / 10, [&] {
    canvas.path(
        "M 0 -4 L 1.3 -1.4 L 4 -1.2 L 2 0.8 L 2.6 3.6 L 0 2.2 L -2.6 3.6 L -2 0.8 L -4 -1.2 L -1.3 "
        "-1.4 Z");
    canvas.fill(rgb("#1e2a5c"));
  });
}

void one_raspberry(Canvas& canvas) {
  const Color red = rgb("#d22a56");
  constexpr double half_widths[] = {22, 27, 25, 19, 11};  // of the rows of drupelets, top down
  for (int row = 4; row >= 0; --row) {
    const double w = half_widths[row];
    const int count = static_cast<int>(w / 5) + 1;
    for (int i = 0; i < count; ++i) {
      const double x = count == 1 ? 0 : -w + 2 * w * i / (count - 1);
      ball(canvas, {x, -14 + row * 12.5 + (i % 2) * 2.0, 9}, red);
    }
  }
  for (const double angle : {-0.1, 0.6, 2.5, 3.25, 4.2, 5.2})
    leaf(canvas, 0, -24, angle, 22, leaf_green);
  canvas.path("M 0 -24 C 0 -32 3 -38 7 -44").stroke(darker(leaf_green, 0.2), 3);
}

void one_banana(Canvas& canvas) {
  const Color yellow = rgb("#f6c921");
  canvas.path(
      "M -40 -24 C -34 14 -2 34 38 24 C 43 22 45 17 41 14 C 16 14 -14 2 -27 -28 C -31 -32 -40 -30 "
      "-40 -24 Z");
  canvas.fill(Paint::linear(
      -20, -24, 4, 34, {{0, lighter(yellow, 0.35)}, {0.5, yellow}, {1, rgb("#c98a10")}}));
  canvas.path("M -34 -26 C -24 8 4 24 40 18").stroke(faded(rgb("#a8760c"), 0.55), 1.6);
  canvas.path("M -40 -24 L -43 -38 L -36 -40 L -27 -28 Z").fill(rgb("#9a8a1e"));
  canvas.path("M 38 24 C 43 22 45 17 41 14 C 44 13 48 15 48 18 C 47 22 43 24 38 24 Z")
      .fill(rgb("#4c3a17"));
}

}  // namespace

void draw_motif_apple(Canvas& canvas, const MotifInk&) {
  const Color red = rgb("#c9202b");
  ground_shadow(canvas, {-38, 34, 80, 16});
  canvas.path(
      "M 0 -22 C 12 -34 44 -32 42 2 C 41 28 22 46 10 43 C 3 41 -3 41 -10 43 C -22 46 -41 28 -42 2"
      " C -44 -32 -12 -34 0 -22 Z");
  canvas.fill(Paint::radial(
      0,
      4,
      50,
      -16,
      -14,
      {{0, rgb("#f9b24a")}, {0.28, rgb("#e4472f")}, {0.65, red}, {1, darker(red, 0.45)}}));
  canvas.ellipse(1, -20, 13, 5).fill(faded(rgb("#5e0f10"), 0.45));
  canvas.path("M 1 -20 C 0 -30 3 -38 8 -44").stroke(stem_brown, 4);
  leaf(canvas, 4, -31, -0.35, 36, leaf_green);
  gloss(canvas, {-33, -22, 22, 32}, 0.35, 0.75);
}

void draw_motif_orange(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 30, 94, 18});
  ball(canvas, {-10, -6, 36}, rgb("#f28a14"));
  constexpr double pores[][2] = {
      {-30, 2}, {-22, 14}, {-10, 20}, {-32, -12}, {4, -28}, {14, -16}, {-4, 6}, {-18, -2}, {6, 8}};
  for (const auto& [x, y] : pores)
    canvas.circle(x, y, 1).fill(faded(rgb("#b85f06"), 0.5));
  canvas.path("M -12 -40 C -12 -43 -11 -45 -9 -47").stroke(stem_brown, 3);
  leaf(canvas, -10, -41, 0.0, 34, leaf_green);
  citrus_slice(canvas, 20, 16, 28, rgb("#f0820f"), rgb("#ffa52c"));
}

void draw_motif_lemon(Canvas& canvas, const MotifInk&) {
  const Color yellow = rgb("#f7d51d");
  ground_shadow(canvas, {-46, 28, 94, 18});
  placed(canvas, -6, -8, -0.35, 1, [&] {
    canvas.path(
        "M -42 0 C -38 -8 -36 -10 -30 -18 C -16 -34 16 -34 28 -18 C 33 -11 36 -8 42 -3 C 45 0 44 4 "
        "40 6"
        " C 34 10 32 14 28 19 C 15 34 -16 34 -30 18 C -36 10 -38 8 -42 0 Z");
    canvas.fill(lit({0, 0, 40}, yellow));
    gloss(canvas, {-26, -24, 30, 18}, -0.4, 0.8);
  });
  leaf(canvas, 24, -22, -0.9, 26, leaf_green);
  citrus_slice(canvas, 20, 18, 25, rgb("#f0c70f"), rgb("#fbe25a"));
}

void draw_motif_lime(Canvas& canvas, const MotifInk&) {
  const Color green = rgb("#6bb02a");
  ground_shadow(canvas, {-46, 28, 94, 18});
  placed(canvas, -8, -8, -0.3, 1, [&] {
    canvas.path(
        "M -38 0 C -34 -22 -16 -30 0 -30 C 18 -30 32 -20 37 -4 C 41 -2 41 4 37 5 C 32 22 18 30 0 "
        "30 C -16 30 -34 22 -38 0 Z");
    canvas.fill(lit({0, 0, 38}, green));
    gloss(canvas, {-26, -24, 28, 17}, -0.4, 0.75);
  });
  citrus_slice(canvas, 19, 16, 26, rgb("#5d9e22"), rgb("#c5e26a"));
}

void draw_motif_strawberry(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 30, 94, 18});
  placed(canvas, 20, 6, 0.3, 0.68, [&] { strawberry(canvas); });
  placed(canvas, -10, 0, -0.12, 0.96, [&] { strawberry(canvas); });
}

void draw_motif_blueberry(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 28, 94, 20});
  leaf(canvas, 6, -20, -0.5, 38, leaf_green);
  leaf(canvas, -2, -20, 3.6, 34, darker(leaf_green, 0.1));
  blueberry(canvas, 24, -4, 18);
  blueberry(canvas, -26, 2, 19);
  blueberry(canvas, 0, -16, 18);
  blueberry(canvas, 20, 25, 17);
  blueberry(canvas, -8, 20, 21);
}

void draw_motif_raspberry(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 30, 94, 18});
  placed(canvas, 21, 6, 0.3, 0.70, [&] { one_raspberry(canvas); });
  placed(canvas, -11, 0, -0.12, 0.96, [&] { one_raspberry(canvas); });
}

void draw_motif_berry(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-44, 32, 92, 16});
  placed(canvas, -8, -4, -0.15, 0.98, [&] { strawberry(canvas); });
  blueberry(canvas, 30, 26, 15);
  blueberry(canvas, 39, 4, 11);
  leaf(canvas, 30, -6, -0.8, 22, leaf_green);
}

void draw_motif_grape(Canvas& canvas, const MotifInk&) {
  const Color violet = rgb("#6b2a86");
  canvas.path("M 2 -30 C 4 -38 8 -43 14 -47").stroke(stem_brown, 4);
  leaf(canvas, 4, -32, -0.25, 42, leaf_green);
  leaf(canvas, 0, -32, 3.5, 36, darker(leaf_green, 0.1));
  constexpr double grapes[][2] = {{0, 38},
                                  {-9, 26},
                                  {10, 26},
                                  {-18, 13},
                                  {0, 14},
                                  {18, 13},
                                  {-27, -1},
                                  {-9, 0},
                                  {9, 0},
                                  {27, -1},
                                  {-20, -15},
                                  {0, -16},
                                  {20, -15}};
  for (const auto& [x, y] : grapes)
    ball(canvas, {x, y, 11}, violet);
}

void draw_motif_banana(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-44, 26, 90, 16});
  placed(canvas, 2, -6, -0.22, 0.98, [&] { one_banana(canvas); });
  placed(canvas, -2, 6, 0.02, 1.02, [&] { one_banana(canvas); });
}

}  // namespace marketgen::assets
