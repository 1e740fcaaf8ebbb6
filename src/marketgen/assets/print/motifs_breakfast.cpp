// Bakery, dairy and sweets on labels.
#include <numbers>

#include "assets/print/motif_brush.h"

namespace marketgen::assets {
namespace {

void one_cookie(Canvas& canvas, double x, double y, double radius) {
  const Color dough = rgb("#cf944c");
  placed(canvas, x, y, 0, radius / 40, [&] {
    canvas.path(
        "M 0 -40 C 12 -42 24 -34 32 -26 C 40 -18 41 -4 40 6 C 38 20 30 32 18 37 C 6 42 -10 41 -22 "
        "35"
        " C -34 28 -41 14 -40 0 C -40 -12 -34 -26 -24 -33 C -16 -38 -8 -40 0 -40 Z");
    canvas.fill(lit({0, 0, 42}, dough));
    constexpr double chips[][3] = {{-18, -14, 6},
                                   {8, -22, 5},
                                   {20, -2, 6.5},
                                   {-4, 2, 6},
                                   {-22, 14, 5},
                                   {6, 22, 6},
                                   {24, 18, 4},
                                   {-8, -30, 4},
                                   {-30, -2, 4},
                                   {-8, 30, 4}};
    for (const auto& [cx, cy, r] : chips)
      ball(canvas, {cx, cy, r}, rgb("#4a2713"));
    canvas.path("M -10 -12 L -4 -8 M 10 8 L 16 12 M -14 24 L -10 20")
        .stroke(faded(rgb("#8a5a24"), 0.6), 1.4);
  });
}

void one_egg(Canvas& canvas, double x, double y, double angle, const Color& shell) {
  placed(canvas, x, y, angle, 1, [&] {
    canvas.path(
        "M 0 -34 C 16 -34 27 -8 27 8 C 27 24 15 33 0 33 C -15 33 -27 24 -27 8 C -27 -8 -16 -34 0 "
        "-34 Z");
    canvas.fill(lit({0, 2, 34}, shell));
    gloss(canvas, {-17, -22, 16, 24}, 0.25, 0.65);
  });
}

void chocolate_piece(Canvas& canvas, double x, double y, double size) {
  const Color cocoa = rgb("#5a2f1a");
  const Area outer{x, y, size, size};
  canvas.rounded(outer, size * 0.08).fill(darker(cocoa, 0.35));
  canvas.rounded({x, y, size - 1.5, size - 1.5}, size * 0.08).fill(lighter(cocoa, 0.18));
  canvas.rounded(outer.inset(size * 0.13), size * 0.06).fill(lit_across(outer, cocoa));
}

void wrapped_sweet(
    Canvas& canvas, double x, double y, double angle, double scale, const Color& base) {
  placed(canvas, x, y, angle, scale, [&] {
    for (const double side : {-1.0, 1.0}) {
      const Canvas::Saved saved = canvas.saved();
      canvas.scale(side, 1);
      canvas.path("M 18 0 L 42 -18 C 38 -9 45 -5 41 0 C 45 5 38 9 42 18 Z");
      canvas.fill(Paint::linear(
          18, 0, 42, 0, {{0, darker(base, 0.3)}, {0.5, lighter(base, 0.3)}, {1, base}}));
      canvas.path("M 20 0 L 38 -10 M 20 0 L 39 0 M 20 0 L 38 10")
          .stroke(faded(darker(base, 0.4), 0.5), 1.2);
    }
    canvas.circle(0, 0, 21).fill(lit({0, 0, 21}, base));
    const Canvas::Saved saved = canvas.saved();
    canvas.circle(0, 0, 21).clip();
    canvas.path("M -24 10 C -8 14 8 -2 10 -24 M -12 24 C 6 20 22 4 24 -12")
        .stroke(faded(paper_white, 0.85), 5);
    gloss(canvas, {-16, -18, 18, 12}, -0.5);
  });
}

void honey_cell(Canvas& canvas, double x, double y, double radius, const Color& base) {
  constexpr double half = 0.8660254;
  const double r = radius * 0.93;
  canvas.polygon({{x, y - r},
                  {x + half * r, y - r / 2},
                  {x + half * r, y + r / 2},
                  {x, y + r},
                  {x - half * r, y + r / 2},
                  {x - half * r, y - r / 2}});
  canvas.fill_and_stroke(lit({x, y, radius}, base), rgb("#c47a12"), 2.2);
}

}  // namespace

void draw_motif_bread(Canvas& canvas, const MotifInk&) {
  const Color crust = rgb("#b9712b");
  ground_shadow(canvas, {-48, 20, 98, 20});
  placed(canvas, 0, 0, -0.15, 1, [&] {
    canvas.path(
        "M -46 10 C -48 -14 -22 -28 2 -28 C 28 -28 48 -14 46 8 C 45 22 30 26 0 26 C -30 26 -45 24 "
        "-46 10 Z");
    canvas.fill(Paint::linear(
        -10,
        -30,
        8,
        30,
        {{0, rgb("#e3a75a")}, {0.45, crust}, {0.85, darker(crust, 0.35)}, {1, rgb("#6d3c12")}}));
    for (const double x : {-28.0, -8.0, 12.0, 31.0}) {
      placed(canvas, x, -6, 0.5, 1, [&] {
        canvas.path("M -2 -17 C 7 -10 7 8 0 16 C -7 8 -8 -8 -2 -17 Z");
        canvas.fill(Paint::linear(
            -6, 0, 7, 0, {{0, rgb("#fbe3b4")}, {0.6, rgb("#efc987")}, {1, rgb("#9c5f22")}}));
      });
    }
    gloss(canvas, {-36, -25, 40, 14}, -0.2, 0.45);
  });
}

void draw_motif_cookie(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 28, 94, 18});
  one_cookie(canvas, 16, -14, 30);
  one_cookie(canvas, -11, 8, 36);
}

void draw_motif_milk_drop(Canvas& canvas, const MotifInk&) {
  const Color milk = rgb("#fbfbf8");
  const Color shade = rgb("#c9d3e2");
  const Paint cream =
      Paint::linear(-30, -10, 30, 40, {{0, milk}, {0.6, rgb("#eef2f7")}, {1, shade}});
  canvas.path(
      "M -48 26 C -40 16 -36 14 -33 2 C -31 -4 -27 -4 -26 2 C -25 14 -18 18 -12 10 C -8 2 -9 -8 -4 "
      "-10 C 1 -10 0 2 5 9"
      " C 10 17 20 16 23 4 C 24 -6 30 -6 31 2 C 33 14 40 16 48 26 C 40 44 -40 44 -48 26 Z");
  canvas.fill_and_stroke(cream, faded(rgb("#8fa3c2"), 0.7), 1.2);
  canvas.ellipse(0, 30, 36, 7).stroke(faded(shade, 0.9), 2);
  canvas.path("M -2 -48 C 10 -34 12 -28 10 -23 C 7 -16 -10 -16 -13 -23 C -15 -28 -12 -36 -2 -48 Z");
  canvas.fill_and_stroke(Paint::radial(-1, -26, 18, -6, -32, {{0, milk}, {0.6, milk}, {1, shade}}),
                         faded(rgb("#8fa3c2"), 0.7),
                         1.2);
  for (const Ball& spray :
       {Ball{-26, -12, 3.4}, Ball{30, -16, 3}, Ball{18, -8, 2.2}, Ball{-38, 0, 2}}) {
    canvas.circle(spray.x, spray.y, spray.radius)
        .fill_and_stroke(milk, faded(rgb("#8fa3c2"), 0.7), 1);
  }
}

void draw_motif_cheese(Canvas& canvas, const MotifInk&) {
  const Color cheese = rgb("#f7c63c");
  ground_shadow(canvas, {-48, 22, 98, 20});
  canvas.path("M -46 -2 L 22 -32 C 38 -26 46 -14 46 -4 Z")
      .fill(lit_across({-46, -32, 92, 34}, lighter(cheese, 0.35)));
  canvas.path("M -46 -2 L 46 -4 L 46 28 C 20 34 -24 36 -46 30 Z")
      .fill(lit_across({-46, -4, 92, 60}, cheese));
  constexpr double holes[][3] = {
      {-26, 16, 7}, {-4, 8, 5}, {12, 22, 8}, {32, 8, 6}, {-10, 27, 4}, {36, 24, 3.5}};
  for (const auto& [x, y, r] : holes) {
    canvas.ellipse(x, y, r * 1.1, r)
        .fill(Paint::linear(
            x - r, y - r, x + r, y + r, {{0, darker(cheese, 0.42)}, {1, lighter(cheese, 0.1)}}));
  }
  canvas.ellipse(14, -17, 7, 3).fill(darker(cheese, 0.15));
  canvas.ellipse(-12, -9, 5, 2).fill(darker(cheese, 0.15));
}

void draw_motif_egg(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 26, 94, 18});
  one_egg(canvas, 18, -2, 0.3, rgb("#f3dfc4"));
  one_egg(canvas, -13, 5, -0.15, rgb("#d99f6a"));
}

void draw_motif_honey(Canvas& canvas, const MotifInk&) {
  const Color amber = rgb("#f3a712");
  constexpr double half = 0.8660254;
  for (int row = -1; row <= 1; ++row) {
    for (int column = -1; column <= 1; ++column) {
      const double x = (column + (row % 2 == 0 ? 0.0 : 0.5)) * 2 * half * 15 - 6;
      if (x < 34) honey_cell(canvas, x, row * 22.5 + 8, 15, lighter(amber, 0.12 * (column + 1)));
    }
  }
  canvas.path("M 42 -46 L 12 -8").stroke(rgb("#9b6330"), 5.5);
  placed(canvas, 6, 0, 0.67, 1, [&] {
    for (int ring = 0; ring < 4; ++ring) {
      const double w = ring == 0 || ring == 3 ? 9 : 12;
      canvas.rounded({-w, -11 + ring * 7.0, 2 * w, 5.4}, 2.7)
          .fill(lit_across({-w, -11, 2 * w, 26}, rgb("#b97b3f")));
    }
  });
  canvas.path(
      "M -8 8 C -2 14 2 12 4 20 C 6 30 -4 34 -3 44 C -3 49 -9 49 -9 44 C -9 32 -14 24 -13 16 Z");
  canvas.fill(
      Paint::linear(-12, 10, 4, 40, {{0, rgb("#ffd765")}, {0.6, amber}, {1, rgb("#c8780a")}}));
}

void draw_motif_chocolate(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 26, 94, 20});
  placed(canvas, 6, -6, 0.22, 1, [&] {
    for (int row = 0; row < 2; ++row) {
      for (int column = 0; column < 3; ++column)
        chocolate_piece(canvas, -40 + column * 25, -26 + row * 25, 24.5);
    }
  });
  placed(canvas, -16, 26, -0.25, 1, [&] { chocolate_piece(canvas, -12, -12, 24.5); });
}

void draw_motif_candy(Canvas& canvas, const MotifInk& ink) {
  const Color first = contrast(ink.accent, ink.primary) > 1.5 ? ink.accent : rgb("#e63a6b");
  wrapped_sweet(canvas, 10, -20, 0.55, 0.78, rgb("#38a8d8"));
  wrapped_sweet(canvas, 14, 24, -0.2, 0.74, rgb("#f2b01e"));
  wrapped_sweet(canvas, -8, 2, -0.5, 0.95, first);
}

}  // namespace marketgen::assets
