// Stone fruit, pears and fruit from the tropics on labels.
#include <algorithm>
#include <numbers>
#include <string_view>
#include <utility>

#include "assets/print/motif_brush.h"

namespace marketgen::assets {
namespace {

constexpr Color orchard_green = rgb("#3f8f2f");
constexpr Color bark = rgb("#6b4423");

struct CheekColors {
  Color sun, base, shade;
};

// A round fruit with a warm cheek, as peaches and plums have one.
void stone_fruit(Canvas& canvas, double x, double y, double radius, const CheekColors& colors) {
  placed(canvas, x, y, 0, radius / 40, [&] {
    canvas.path(
        "M 2 -34 C 22 -42 42 -26 41 2 C 40 26 20 41 0 40 C -22 40 -41 24 -41 0 C -41 -26 -20 -42 2 "
        "-34 Z");
    canvas.fill(Paint::radial(0,
                              2,
                              46,
                              -16,
                              -14,
                              {{0, lighter(colors.sun, 0.35)},
                               {0.35, colors.sun},
                               {0.72, colors.base},
                               {1, colors.shade}}));
    canvas.path("M 2 -34 C -10 -16 -10 16 0 39").stroke(faded(colors.shade, 0.55), 2.4);
    gloss(canvas, {-31, -26, 22, 26}, 0.4, 0.55);
  });
}

void stalk(Canvas& canvas, double x, double y) {
  placed(canvas, x, y, 0, 1, [&] { canvas.path("M 0 0 C 0 -6 2 -11 6 -15").stroke(bark, 3.6); });
}

// Seeds in a ring round the middle of a cut fruit.
void seed_ring(Canvas& canvas, int count, double radius, double size, const Color& color) {
  for (int i = 0; i < count; ++i) {
    placed(canvas, 0, 0, 0.2 + i * 2 * std::numbers::pi / count, 1, [&] {
      canvas.ellipse(radius, 0, size, size * 0.55).fill(color);
    });
  }
}

void one_cherry(Canvas& canvas, double x, double y) {
  canvas.circle(x, y, 21).fill(Paint::radial(
      x,
      y,
      23,
      x - 7,
      y - 8,
      {{0, rgb("#f0525a")}, {0.4, rgb("#c4122a")}, {0.8, rgb("#8f0a1f")}, {1, rgb("#5d0614")}}));
  gloss(canvas, {x - 14, y - 15, 13, 11}, -0.5, 0.9);
  canvas.ellipse(x + 1, y - 18, 5, 2).fill(faded(rgb("#3f0410"), 0.6));
}

void one_plum(Canvas& canvas, double x, double y, double angle, double radius) {
  placed(canvas, x, y, angle, 1, [&] {
    stone_fruit(canvas, 0, 0, radius, {rgb("#8d5bb0"), rgb("#55276f"), rgb("#260d38")});
  });
}

}  // namespace

void draw_motif_pear(Canvas& canvas, const MotifInk&) {
  const Color green = rgb("#b9c136");
  ground_shadow(canvas, {-40, 34, 84, 16});
  canvas.path(
      "M 0 -34 C 14 -34 16 -22 18 -10 C 21 2 36 8 36 24 C 36 40 18 46 0 46 C -18 46 -36 40 -36 24 "
      "C "
      "-36 8 -21 2 -18 -10 C -16 -22 -14 -34 0 -34 Z");
  canvas.fill(Paint::radial(
      2,
      14,
      52,
      -14,
      4,
      {{0, rgb("#f1ee8a")}, {0.4, lighter(green, 0.15)}, {0.7, green}, {1, rgb("#6c7a14")}}));
  gloss(canvas, {-28, 0, 18, 28}, 0.35, 0.6);
  gloss(canvas, {-13, -28, 9, 22}, 0.2, 0.5);
  canvas.path("M 0 -33 C 0 -40 3 -45 7 -49").stroke(bark, 4);
  leaf(canvas, 3, -38, -0.2, 34, orchard_green);
}

void draw_motif_peach(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 28, 94, 18});
  const CheekColors skin{rgb("#ffc36b"), rgb("#f0703f"), rgb("#b8302a")};
  stalk(canvas, -8, -36);
  leaf(canvas, -6, -36, -0.15, 40, orchard_green);
  stone_fruit(canvas, -9, -2, 38, skin);
  // A cut half with its stone.
  canvas.circle(24, 20, 24).fill(lit({24, 20, 24}, rgb("#e8743c")));
  canvas.circle(24, 20, 21)
      .fill(Paint::radial(
          24, 20, 21, 22, 18, {{0, rgb("#e4552f")}, {0.5, rgb("#fbb04a")}, {1, rgb("#ffd27a")}}));
  canvas.ellipse(24, 20, 9, 11).fill(lit({24, 20, 11}, rgb("#7c3b22")));
}

void draw_motif_plum(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 28, 94, 18});
  one_plum(canvas, 19, 6, 0.3, 27);
  stalk(canvas, -10, -32);
  leaf(canvas, -8, -34, -0.35, 40, orchard_green);
  one_plum(canvas, -12, 4, -0.15, 36);
}

void draw_motif_cherry(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 32, 94, 16});
  canvas.path("M 12 -45 C -6 -32 -18 -16 -20 10 M 12 -45 C 16 -30 22 -16 24 4")
      .stroke(rgb("#5c7a2a"), 3);
  leaf(canvas, 12, -44, 0.35, 38, orchard_green);
  leaf(canvas, 10, -44, 2.9, 40, darker(orchard_green, 0.1));
  one_cherry(canvas, -20, 24);
  one_cherry(canvas, 24, 20);
}

void draw_motif_mango(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 26, 94, 20});
  placed(canvas, -2, -2, -0.25, 1, [&] {
    canvas.path(
        "M -44 6 C -44 -20 -18 -34 8 -32 C 32 -30 46 -14 43 6 C 40 26 18 34 -6 33 C -30 32 -44 24 "
        "-44 6 Z");
    canvas.fill(Paint::linear(
        -34,
        -24,
        34,
        26,
        {{0, rgb("#f9d34a")}, {0.4, rgb("#f7a529")}, {0.7, rgb("#e2562b")}, {1, rgb("#9a2a2c")}}));
    canvas.path("M -42 8 C -30 22 -10 28 8 27").stroke(faded(rgb("#6f8f2a"), 0.55), 7);
    gloss(canvas, {-28, -26, 34, 18}, -0.2, 0.7);
  });
  stalk(canvas, 38, -16);
  leaf(canvas, 40, -22, -2.6, 44, orchard_green);
}

void draw_motif_avocado(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-44, 32, 92, 16});
  const std::string_view pear_shape =
      "M 0 -46 C 15 -46 18 -30 22 -16 C 27 -2 38 4 38 20 C 38 36 20 46 0 46 C -20 46 -38 36 -38 20 "
      "C "
      "-38 4 -27 -2 -22 -16 C -18 -30 -15 -46 0 -46 Z";
  placed(canvas, 16, 2, 0.3, 0.86, [&] {
    canvas.path(pear_shape).fill(lit({0, 6, 46}, rgb("#3c5a22")));
  });
  placed(canvas, -10, 0, -0.18, 0.92, [&] {
    canvas.path(pear_shape).fill(rgb("#2f4a1c"));
    canvas.scale(0.91, 0.93);
    canvas.path(pear_shape)
        .fill(Paint::radial(
            0, 10, 50, -4, 8, {{0, rgb("#fdf6b8")}, {0.6, rgb("#e6e67f")}, {1, rgb("#94b63a")}}));
    ball(canvas, {0, 18, 17}, rgb("#8a4f22"));
  });
}

void draw_motif_coconut(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 28, 94, 18});
  canvas.circle(-12, -6, 34).fill(lit({-12, -6, 34}, rgb("#7a4a22")));
  for (int i = 0; i < 16; ++i) {
    placed(canvas, -12, -6, 2.4 + i * 0.17, 1, [&] {
      canvas.path("M 14 0 C 20 3 26 3 33 1").stroke(faded(rgb("#4a2a10"), 0.5), 1.6);
    });
  }
  for (const auto& [x, y] : {std::pair{-22, -28}, {-10, -32}, {-17, -20}})
    canvas.ellipse(x, y, 3.2, 2.6).fill(rgb("#3a2110"));
  canvas.ellipse(18, 18, 30, 24).fill(lit({18, 18, 30}, rgb("#6b3d1a")));
  canvas.ellipse(18, 16, 27, 20).fill(rgb("#fffdf6"));
  canvas.ellipse(18, 17, 19, 13)
      .fill(Paint::linear(
          0, 8, 30, 30, {{0, rgb("#c9ccd0")}, {0.5, rgb("#f3f4f2")}, {1, paper_white}}));
}

void draw_motif_kiwi(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 28, 94, 18});
  placed(canvas, -14, -8, -0.25, 1, [&] {
    canvas.ellipse(0, 0, 33, 27).fill(lit({0, 0, 34}, rgb("#8a6a35")));
    gloss(canvas, {-22, -20, 24, 14}, -0.3, 0.35);
  });
  placed(canvas, 15, 14, 0, 1, [&] {
    canvas.circle(0, 0, 31).fill(lit({0, 0, 31}, rgb("#7a5c2c")));
    canvas.circle(0, 0, 28).fill(Paint::radial(
        0, 0, 28, -4, -4, {{0, rgb("#d8e873")}, {0.5, rgb("#8fc22c")}, {1, rgb("#6da51d")}}));
    for (int i = 0; i < 22; ++i) {
      placed(canvas, 0, 0, i * 2 * std::numbers::pi / 22, 1, [&] {
        canvas.path("M 9 0 L 24 0").stroke(faded(rgb("#e4f09a"), 0.6), 1);
      });
    }
    seed_ring(canvas, 16, 13.5, 2.6, rgb("#1e1b12"));
    canvas.ellipse(0, 0, 8, 7).fill(rgb("#f3f2c6"));
  });
}

void draw_motif_melon(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-48, 30, 98, 16});
  canvas.circle(-8, -8, 36).fill(lit({-8, -8, 36}, rgb("#4c8f35")));
  for (const double bend : {-26.0, -11.0, 5.0, 20.0}) {
    placed(canvas, -8, -8, 0, 1, [&] {
      cairo_t* c = canvas.context();
      cairo_move_to(c, bend * 0.3, -35);
      cairo_curve_to(c, bend * 1.3, -14, bend * 1.3, 14, bend * 0.3, 35);
      canvas.stroke(faded(rgb("#1f4f1c"), 0.7), 4.5);
    });
  }
  // A slice in front.
  canvas.path("M -18 8 L 48 2 C 48 26 34 44 12 44 C -4 44 -16 30 -18 8 Z").fill(rgb("#2f7a2c"));
  canvas.path("M -15 8 L 45 3 C 44 24 32 40 12 40 C -2 40 -13 28 -15 8 Z").fill(rgb("#f2f6d6"));
  canvas.path("M -12 8 L 42 3 C 41 22 30 36 13 36 C 0 36 -10 26 -12 8 Z")
      .fill(Paint::linear(0, 4, 20, 38, {{0, rgb("#f5606a")}, {1, rgb("#d5273e")}}));
  for (const auto& [x, y] :
       {std::pair{0, 14}, {12, 12}, {26, 11}, {6, 24}, {20, 22}, {14, 31}, {30, 19}})
    canvas.ellipse(x, y, 1.7, 2.6).fill(rgb("#2a1410"));
}

void draw_motif_pineapple(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-36, 38, 76, 12});
  for (const double angle : {-2.5, -0.65, -2.15, -1.0, -1.85, -1.3, -1.57})
    leaf(canvas, 0, -10, angle, angle < -1.2 && angle > -2.0 ? 40 : 34, rgb("#4f8f3a"));
  const Canvas::Saved saved = canvas.saved();
  canvas.ellipse(0, 18, 25, 29).clip();
  canvas.rectangle({-30, -14, 60, 64}).fill(rgb("#b0701a"));
  for (int row = 0; row < 8; ++row) {
    for (int column = -3; column <= 3; ++column) {
      const double x = column * 11.0 + (row % 2 == 0 ? 0.0 : 5.5);
      const double y = -8 + row * 8.0;
      canvas.polygon({{x, y - 6.6}, {x + 5.2, y}, {x, y + 6.6}, {x - 5.2, y}});
      const double dark = std::clamp((x + 6) / 40, 0.0, 0.5);
      canvas.fill(lit({x, y, 7.5}, darker(rgb("#f2ae2e"), dark)));
      canvas.circle(x, y + 0.6, 1.1).fill(rgb("#7c4a12"));
    }
  }
}

}  // namespace marketgen::assets
