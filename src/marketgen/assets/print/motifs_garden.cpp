// Roots, bulbs, cabbages and pulses on labels.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "assets/print/motif_brush.h"

namespace marketgen::assets {
namespace {

constexpr Color garden_green = rgb("#4c9a33");

void one_onion(Canvas& canvas, const Color& skin) {
  canvas.path(
      "M 0 -40 C 3 -30 8 -26 18 -22 C 34 -15 42 -2 38 14 C 34 30 16 38 0 38 C -16 38 -34 30 -38 14 "
      "C -42 -2 -34 -15 -18 -22 C -8 -26 -3 -30 0 -40 Z");
  canvas.fill(lit({0, 4, 42}, skin));
  for (const double bend : {-30.0, -15.0, 0.0, 15.0, 30.0}) {
    cairo_t* c = canvas.context();
    cairo_move_to(c, 0, -32);
    cairo_curve_to(c, bend, -18, bend * 1.2, 18, bend * 0.2, 36);
    canvas.stroke(faded(darker(skin, 0.45), 0.5), 1.4);
  }
  canvas.path("M -8 38 L -10 43 M -3 38 L -4 44 M 3 38 L 3 44 M 8 38 L 10 43")
      .stroke(rgb("#a58a5a"), 1.4);
  gloss(canvas, {-29, -14, 18, 28}, 0.35, 0.6);
}

void one_garlic(Canvas& canvas) {
  const Color skin = rgb("#f4efe6");
  canvas.path(
      "M 2 -44 C 4 -30 6 -24 16 -18 C 32 -10 40 4 36 18 C 32 32 14 36 0 36 C -14 36 -32 32 -36 18 "
      "C -40 4 -32 -10 -16 -18 C -6 -24 -6 -32 -4 -44 Z");
  canvas.fill(
      Paint::radial(0,
                    6,
                    46,
                    -14,
                    -6,
                    {{0, paper_white}, {0.55, skin}, {0.85, rgb("#cfc2b8")}, {1, rgb("#9d8d88")}}));
  canvas.path(
      "M 0 -24 C -14 -12 -18 14 -10 35 M 0 -24 C 14 -12 18 14 10 35 M -3 -26 C -26 -12 -34 10 -26 "
      "28 M 3 -26 C 26 -12 34 10 26 28");
  canvas.stroke(faded(rgb("#9a6f8c"), 0.45), 1.5);
}

void one_pod(Canvas& canvas, const Color& green, int peas) {
  canvas.path("M -46 2 C -34 -16 30 -18 46 -4 C 32 16 -30 18 -46 2 Z").fill(darker(green, 0.3));
  canvas.path("M -42 1 C -30 -9 28 -12 42 -4 C 28 8 -28 10 -42 1 Z").fill(darker(green, 0.5));
  for (int i = 0; i < peas; ++i)
    ball(canvas,
         {-29 + 58.0 * i / (peas - 1), -1.5, i == 0 || i == peas - 1 ? 6.5 : 8.2},
         lighter(green, 0.12));
  canvas.path("M -46 2 C -34 14 30 14 46 -4 C 34 22 -30 24 -46 2 Z")
      .fill(Paint::linear(0, 4, 0, 18, {{0, lighter(green, 0.35)}, {1, darker(green, 0.2)}}));
  canvas.path("M 46 -4 C 48 -8 50 -10 50 -14").stroke(darker(green, 0.3), 2.6);
}

// The bumpy head of broccoli: balls on an arch.
void floret(Canvas& canvas, double x, double y, double radius, const Color& green) {
  canvas.circle(x, y, radius).fill(darker(green, 0.3));
  for (int i = 0; i < 15; ++i) {
    const double ring = i < 9 ? 0.72 : i < 14 ? 0.38 : 0.0;
    const double angle = i * 2.4;
    ball(canvas,
         {x + std::cos(angle) * radius * ring, y + std::sin(angle) * radius * ring, radius * 0.36},
         darker(green, std::clamp(std::sin(angle) * 0.2, 0.0, 0.2)));
  }
}

void spinach_leaf(Canvas& canvas, double angle, double size, const Color& green) {
  placed(canvas, 0, 34, angle, size, [&] {
    canvas.path("M 0 12 C 1 0 0 -8 0 -20").stroke(lighter(green, 0.35), 4.6);
    canvas.path(
        "M 0 -10 C 20 -8 28 -22 22 -34 C 26 -44 18 -60 8 -66 C 4 -70 -4 -70 -8 -66 C -18 -60 -26 "
        "-44 -22 -34 C -28 -22 -20 -8 0 -10 Z");
    canvas.fill(Paint::linear(
        -22, -50, 22, -20, {{0, lighter(green, 0.3)}, {0.5, green}, {1, darker(green, 0.35)}}));
    canvas
        .path(
            "M 0 -10 L 0 -62 M 0 -22 L 14 -32 M 0 -22 L -14 -32 M 0 -36 L 13 -46 M 0 -36 L -13 -46")
        .stroke(faded(lighter(green, 0.5), 0.7), 1.8);
  });
}

}  // namespace

void draw_motif_onion(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 28, 94, 18});
  placed(canvas, 20, 6, 0.3, 0.66, [&] { one_onion(canvas, rgb("#8e2a5c")); });
  placed(canvas, -10, 2, -0.1, 0.92, [&] { one_onion(canvas, rgb("#d08a35")); });
}

void draw_motif_garlic(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 28, 94, 18});
  placed(canvas, -8, 2, -0.08, 0.96, [&] { one_garlic(canvas); });
  placed(canvas, 28, 24, 0.7, 1, [&] {
    canvas.path("M 0 -20 C 12 -10 14 10 4 18 C -2 20 -8 18 -10 12 C -13 0 -8 -12 0 -20 Z");
    canvas.fill_and_stroke(lit({0, 0, 20}, rgb("#f2e7dc")), faded(rgb("#9a6f8c"), 0.5), 1.2);
  });
}

void draw_motif_ginger(Canvas& canvas, const MotifInk&) {
  const Color root = rgb("#d7b07a");
  ground_shadow(canvas, {-48, 22, 98, 22});
  canvas.path(
      "M -44 14 C -50 2 -40 -8 -28 -8 C -30 -24 -18 -34 -8 -28 C -2 -24 -2 -14 -4 -8 C 8 -12 14 "
      "-10 20 -14 C 22 -28 34 -34 42 -26 C 48 -18 40 -8 36 -2 C 46 6 44 20 32 22 C 22 24 14 20 6 "
      "22 C -2 34 -14 36 -20 26 C -30 30 -40 24 -44 14 Z");
  canvas.fill(lit_across({-44, -30, 88, 62}, root));
  canvas.path(
      "M -30 -6 C -26 0 -26 8 -30 14 M -14 -26 C -10 -22 -10 -16 -12 -10 M -6 -6 C -2 2 -4 12 -8 "
      "18 M 12 -10 C 16 -2 14 10 10 18 M 24 -22 C 28 -18 34 -16 38 -16 M 30 0 C 32 6 30 12 26 16");
  canvas.stroke(faded(rgb("#8a5f2c"), 0.6), 1.8);
  canvas.ellipse(-16, 29, 8, 6).fill(lit({-16, 29, 9}, rgb("#f6e08a")));
  canvas.ellipse(38, -23, 6, 7).fill(lit({38, -23, 8}, rgb("#f6e08a")));
}

void draw_motif_beetroot(Canvas& canvas, const MotifInk&) {
  const Color beet = rgb("#8e1b4a");
  ground_shadow(canvas, {-42, 30, 86, 14});
  for (const double angle : {-2.05, -1.57, -1.1}) {
    placed(canvas, 0, -12, angle, 1, [&] {
      canvas.path("M 0 0 L 22 0").stroke(lighter(beet, 0.1), 3.6);
    });
    leaf(canvas, std::cos(angle) * 14, -12 + std::sin(angle) * 14, angle, 28, garden_green);
  }
  canvas.path(
      "M 0 -14 C 20 -20 34 -6 32 10 C 30 24 14 32 5 36 C 3 41 2 44 0 49 C -2 44 -3 41 -5 36 C -14 "
      "32 -30 24 -32 10 C -34 -6 -20 -20 0 -14 Z");
  canvas.fill(lit({0, 8, 36}, beet));
  canvas.path("M -26 16 C -14 24 14 24 26 16 M -20 24 C -10 30 10 30 20 24")
      .stroke(faded(rgb("#4f0a26"), 0.5), 1.6);
  gloss(canvas, {-24, -8, 18, 20}, 0.4, 0.6);
}

void draw_motif_broccoli(Canvas& canvas, const MotifInk&) {
  const Color green = rgb("#3f8f3a");
  ground_shadow(canvas, {-36, 36, 74, 12});
  canvas.path(
      "M -10 44 C -8 26 -12 18 -26 2 L -12 -2 L 0 10 L 12 -2 L 26 2 C 12 18 8 26 10 44 C 4 47 -4 "
      "47 -10 44 Z");
  canvas.fill(Paint::linear(
      -14, 0, 14, 6, {{0, rgb("#d8e8a2")}, {0.5, rgb("#a9cc70")}, {1, rgb("#6b9a3c")}}));
  floret(canvas, -26, -4, 18, green);
  floret(canvas, 26, -4, 18, green);
  floret(canvas, 0, -20, 25, green);
}

void draw_motif_cabbage(Canvas& canvas, const MotifInk&) {
  const Color green = rgb("#8cc152");
  ground_shadow(canvas, {-46, 30, 94, 16});
  leaf(canvas, -20, 40, -2.2, 56, darker(green, 0.25));
  leaf(canvas, 20, 40, -0.94, 56, darker(green, 0.3));
  canvas.circle(0, 2, 38).fill(lit({0, 2, 38}, lighter(green, 0.1)));
  canvas.path("M -36 8 C -34 -24 -8 -38 16 -30 C -6 -20 -10 10 2 40 C -20 38 -36 28 -36 8 Z")
      .fill(Paint::linear(
          -36, 0, 6, 10, {{0, lighter(green, 0.45)}, {0.6, green}, {1, darker(green, 0.2)}}));
  canvas.path(
      "M -6 38 C -16 16 -14 -10 6 -28 M -14 10 L -30 0 M -14 -4 L -26 -16 M -12 22 L -28 18");
  canvas.stroke(faded(paper_white, 0.75), 2.4);
  canvas.path("M 36 14 C 40 -6 30 -26 12 -32 C 24 -16 26 14 8 40 C 22 38 33 28 36 14 Z")
      .fill(Paint::linear(10, 0, 40, 10, {{0, lighter(green, 0.2)}, {1, darker(green, 0.25)}}));
  canvas.path("M 12 36 C 24 18 26 -6 18 -24 M 24 8 L 34 2").stroke(faded(paper_white, 0.6), 2);
}

void draw_motif_cucumber(Canvas& canvas, const MotifInk&) {
  const Color green = rgb("#3f8a36");
  ground_shadow(canvas, {-46, 26, 94, 20});
  placed(canvas, -2, -10, -0.5, 1, [&] {
    canvas.path(
        "M -42 2 C -44 -10 -36 -15 -24 -15 C 0 -19 24 -18 38 -12 C 48 -6 48 8 38 13 C 24 18 0 18 "
        "-24 15 C -36 14 -42 10 -42 2 Z");
    canvas.fill(Paint::linear(
        0, -18, 0, 17, {{0, lighter(green, 0.35)}, {0.4, green}, {1, darker(green, 0.5)}}));
    for (int i = 0; i < 14; ++i)
      canvas.circle(-34 + i * 5.4, (i * 7 % 5 - 2) * 4.6, 1.1).fill(faded(rgb("#cfe8a0"), 0.7));
  });
  for (const auto& [x, y] : {std::pair{26, 24}, {4, 30}}) {
    canvas.circle(x, y, 17).fill(darker(green, 0.1));
    canvas.circle(x, y, 15).fill(Paint::radial(
        x, y, 15, x, y, {{0, rgb("#f3f8c9")}, {0.6, rgb("#dcefa0")}, {1, rgb("#b4d878")}}));
    for (int seed = 0; seed < 9; ++seed) {
      placed(canvas, x, y, seed * 2 * std::numbers::pi / 9, 1, [&] {
        canvas.ellipse(7, 0, 2.6, 1.1).fill(faded(rgb("#8fae4a"), 0.9));
      });
    }
  }
}

void draw_motif_pea(Canvas& canvas, const MotifInk&) {
  const Color green = rgb("#5bab2e");
  ground_shadow(canvas, {-46, 28, 94, 18});
  placed(canvas, 4, -20, -0.3, 0.86, [&] { one_pod(canvas, darker(green, 0.1), 6); });
  placed(canvas, -2, 12, -0.12, 0.98, [&] { one_pod(canvas, green, 6); });
  ball(canvas, {-26, 36, 7}, green);
  ball(canvas, {-9, 39, 6.4}, lighter(green, 0.1));
  ball(canvas, {32, 34, 7}, green);
}

void draw_motif_pepper(Canvas& canvas, const MotifInk&) {
  const Color red = rgb("#d4211f");
  ground_shadow(canvas, {-44, 34, 90, 14});
  canvas.path("M -26 -18 C -46 -14 -44 16 -32 34 C -26 44 -14 42 -12 36 L -4 -16 Z")
      .fill(lit({-26, 8, 34}, red));
  canvas.path("M 26 -18 C 46 -14 44 16 32 34 C 26 44 14 42 12 36 L 4 -16 Z")
      .fill(lit({18, 4, 40}, darker(red, 0.12)));
  canvas
      .path(
          "M -12 -20 C -26 -8 -22 24 -12 38 C -6 46 6 46 12 38 C 22 24 26 -8 12 -20 C 4 -24 -4 -24 "
          "-12 -20 Z")
      .fill(lit({-2, 8, 38}, red));
  gloss(canvas, {-37, -6, 9, 28}, 0.1, 0.75);
  gloss(canvas, {-12, -10, 10, 30}, 0.1, 0.75);
  canvas.path("M -20 -18 C -10 -28 10 -28 20 -18 C 12 -14 6 -16 0 -12 C -6 -16 -12 -14 -20 -18 Z")
      .fill(lit({0, -20, 22}, garden_green));
  canvas.path("M 0 -22 C 0 -34 4 -40 12 -44").stroke(darker(garden_green, 0.25), 6);
}

void draw_motif_pumpkin(Canvas& canvas, const MotifInk&) {
  const Color orange = rgb("#ec7a1c");
  ground_shadow(canvas, {-48, 28, 98, 18});
  for (const double x : {-30.0, 30.0, -17.0, 17.0, 0.0}) {
    const double w = x == 0 ? 17 : 18;
    canvas.ellipse(x, 6 + std::abs(x) * 0.03, w, 33 - std::abs(x) * 0.14)
        .fill(lit({x - 2, 2, 34}, darker(orange, x > 0 ? x * 0.006 : 0)));
  }
  gloss(canvas, {-9, -20, 9, 26}, 0.05, 0.5);
  gloss(canvas, {-39, -10, 9, 22}, 0.15, 0.4);
  canvas
      .path("M -6 -24 C -2 -30 -4 -38 -10 -44 L 2 -46 C 6 -38 6 -30 8 -24 C 4 -22 -2 -22 -6 -24 Z")
      .fill(lit({0, -34, 14}, rgb("#6f8a34")));
  leaf(canvas, 6, -28, -0.2, 34, garden_green);
}

void draw_motif_spinach(Canvas& canvas, const MotifInk&) {
  const Color green = rgb("#2f7f34");
  spinach_leaf(canvas, -0.62, 0.94, darker(green, 0.12));
  spinach_leaf(canvas, 0.62, 0.94, darker(green, 0.05));
  spinach_leaf(canvas, 0.0, 1.12, lighter(green, 0.08));
}

void draw_motif_soy(Canvas& canvas, const MotifInk&) {
  const Color green = rgb("#7fae3c");
  ground_shadow(canvas, {-46, 28, 94, 18});
  leaf(canvas, 10, -26, -0.6, 36, garden_green);
  leaf(canvas, 4, -26, 3.7, 34, darker(garden_green, 0.1));
  placed(canvas, 0, -8, -0.22, 0.96, [&] { one_pod(canvas, green, 4); });
  const Color bean = rgb("#ecd9a0");
  for (const auto& [x, y, r] :
       {std::tuple{-24.0, 28.0, 10.0}, {0.0, 32.0, 11.0}, {24.0, 27.0, 10.0}}) {
    ball(canvas, {x, y, r}, bean);
    canvas.ellipse(x + 3, y + 2, 2.4, 1.1).fill(rgb("#8a6a30"));
  }
}

}  // namespace marketgen::assets
