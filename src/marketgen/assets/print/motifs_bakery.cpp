// Baked goods, snacks and pasta on labels.
#include <string_view>
#include <tuple>
#include <utility>

#include "assets/print/motif_brush.h"

namespace marketgen::assets {
namespace {

constexpr Color crust = rgb("#c98136");

// The domed top of a bun over its cut; `width` is half its width.
void bun_top(Canvas& canvas, double y, double width) {
  placed(canvas, 0, y, 0, width / 40, [&] {
    canvas.path("M -40 4 C -42 -24 -20 -36 0 -36 C 20 -36 42 -24 40 4 C 36 9 -36 9 -40 4 Z");
    canvas.fill(Paint::radial(
        0,
        -6,
        46,
        -14,
        -20,
        {{0, rgb("#f7cf8a")}, {0.35, rgb("#e2a24e")}, {0.75, crust}, {1, rgb("#8a4c16")}}));
    for (const auto& [x, sy, angle] : {std::tuple{-18.0, -22.0, 0.4},
                                       {-4.0, -29.0, -0.3},
                                       {12.0, -26.0, 0.5},
                                       {24.0, -15.0, 0.9},
                                       {-28.0, -9.0, -0.6},
                                       {4.0, -17.0, 0.2},
                                       {-10.0, -12.0, 0.7}}) {
      placed(canvas, x, sy, angle, 1, [&] { canvas.ellipse(0, 0, 1.8, 3).fill(rgb("#fdf0cf")); });
    }
    gloss(canvas, {-28, -32, 30, 14}, -0.35, 0.55);
  });
}

void one_crisp(Canvas& canvas, double x, double y, double angle, double size) {
  placed(canvas, x, y, angle, size, [&] {
    canvas.path(
        "M -34 -6 C -30 -26 -6 -30 14 -26 C 34 -22 40 -4 32 10 C 26 24 6 26 -12 24 C -30 22 -38 8 "
        "-34 -6 Z");
    canvas.fill(Paint::linear(
        -30,
        -26,
        30,
        26,
        {{0, rgb("#ffe9a0")}, {0.45, rgb("#f6c84c")}, {0.8, rgb("#e0a02a")}, {1, rgb("#b87414")}}));
    canvas.path("M -26 -2 C -10 -14 14 -14 28 0 M -20 12 C -6 2 12 2 24 12")
        .stroke(faded(rgb("#fff6cf"), 0.75), 3);
    canvas.path("M -22 2 C -8 -8 14 -8 26 5").stroke(faded(rgb("#a8680e"), 0.4), 1.6);
    for (const auto& [cx, cy] :
         {std::pair{-14, -14}, {8, -18}, {18, -6}, {-4, 8}, {10, 16}, {-22, 8}})
      canvas.circle(cx, cy, 1.1).fill(faded(rgb("#a8680e"), 0.7));
  });
}

void popped_corn(Canvas& canvas, double x, double y, double size) {
  placed(canvas, x, y, size * 3, size, [&] {
    for (const auto& [cx, cy, r] : {std::tuple{-7.0, -3.0, 8.0},
                                    {7.0, -4.0, 8.5},
                                    {0.0, -9.0, 7.5},
                                    {-3.0, 6.0, 8.0},
                                    {8.0, 6.0, 7.0}}) {
      canvas.circle(cx, cy, r).fill(
          Paint::radial(cx,
                        cy,
                        r,
                        cx - 2,
                        cy - 2,
                        {{0, paper_white}, {0.6, rgb("#fff3d0")}, {1, rgb("#e0b860")}}));
    }
    canvas.ellipse(1, 1, 3, 2.4).fill(rgb("#d08a1c"));
  });
}

void one_cracker(Canvas& canvas) {
  const Area body{-30, -30, 60, 60};
  canvas.rounded(body, 8).fill(lit_across(body, rgb("#e2ab5c")));
  canvas.rounded(body.inset(2.5), 7).stroke(faded(rgb("#a5651c"), 0.6), 2.4);
  for (int row = -1; row <= 1; ++row) {
    for (int column = -1; column <= 1; ++column)
      canvas.circle(column * 16, row * 16, 2.3).fill(rgb("#9a5f1e"));
  }
  for (const auto& [x, y] : {std::pair{-8, -22}, {20, -8}, {-22, 6}, {8, 8}, {22, 22}, {-6, 23}})
    canvas.rectangle({x + 0.0, y + 0.0, 3, 3}).fill(rgb("#fff8e6"));
}

void penne(Canvas& canvas, double x, double y, double angle) {
  const Color dough = rgb("#f0c45a");
  placed(canvas, x, y, angle, 1, [&] {
    canvas.path("M -30 9 L -20 -9 L 30 -9 L 20 9 Z");
    canvas.fill(Paint::linear(
        0, -9, 0, 9, {{0, lighter(dough, 0.5)}, {0.45, dough}, {1, darker(dough, 0.35)}}));
    canvas.path("M -23 4 L 20 4 M -20 -1 L 22 -1 M -18 -5.5 L 26 -5.5")
        .stroke(faded(rgb("#a8761c"), 0.55), 1.1);
    canvas.path("M 30 -9 C 33 -4 26 8 20 9 C 17 4 24 -8 30 -9 Z").fill(rgb("#9a6a1c"));
  });
}

}  // namespace

void draw_motif_bun(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-48, 22, 98, 22});
  placed(canvas, 16, -14, 0.1, 0.72, [&] {
    canvas.path("M -40 2 C -40 18 -30 22 0 22 C 30 22 40 18 40 2 Z").fill(rgb("#a8641f"));
    bun_top(canvas, 4, 41);
  });
  placed(canvas, -8, 14, -0.06, 0.92, [&] {
    canvas.path("M -40 2 C -40 18 -30 22 0 22 C 30 22 40 18 40 2 Z")
        .fill(Paint::linear(0, 0, 0, 22, {{0, rgb("#c98a3e")}, {1, rgb("#8a4c16")}}));
    bun_top(canvas, 4, 41);
  });
}

void draw_motif_burger(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 34, 94, 14});
  canvas.path("M -40 24 L 40 24 C 42 40 34 44 0 44 C -34 44 -42 40 -40 24 Z")
      .fill(lit_across({-40, 24, 80, 20}, rgb("#d9964a")));
  canvas.rounded({-43, 12, 86, 15}, 7).fill(lit_across({-43, 12, 86, 15}, rgb("#6f3a1c")));
  canvas.path("M -44 8 L 44 8 L 30 20 L 14 9 L -10 9 L -22 22 L -36 9 Z").fill(rgb("#fbc02d"));
  canvas.rounded({-42, 2, 84, 8}, 4).fill(lit_across({-42, 2, 84, 8}, rgb("#d9342a")));
  canvas.path(
      "M -47 2 C -42 -6 -36 6 -30 -1 C -24 -6 -18 6 -12 -1 C -6 -6 0 6 6 -1 C 12 -6 18 6 24 -1 C "
      "30 "
      "-6 38 6 47 0 L 44 -6 L -44 -6 Z");
  canvas.fill(lit_across({-46, -6, 92, 12}, rgb("#6fb53a")));
  bun_top(canvas, -8, 43);
}

void draw_motif_croissant(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-48, 18, 98, 24});
  const Paint golden = Paint::linear(
      0,
      -34,
      0,
      30,
      {{0, rgb("#f8cf86")}, {0.35, rgb("#e0a04a")}, {0.75, rgb("#b86a22")}, {1, rgb("#7c3f10")}});
  const auto segment = [&](std::string_view outline) {
    canvas.path(outline).fill_and_stroke(golden, faded(rgb("#7c3f10"), 0.55), 1.6);
  };
  segment("M -36 -2 C -46 4 -50 20 -44 32 C -38 34 -28 26 -24 16 Z");
  segment("M 36 -2 C 46 4 50 20 44 32 C 38 34 28 26 24 16 Z");
  segment("M -26 -22 C -40 -18 -44 0 -36 14 C -28 22 -16 18 -10 12 Z");
  segment("M 26 -22 C 40 -18 44 0 36 14 C 28 22 16 18 10 12 Z");
  segment(
      "M 0 -32 C -16 -32 -28 -24 -28 -8 C -26 10 -14 18 0 18 C 14 18 26 10 28 -8 C 28 -24 16 -32 0 "
      "-32 Z");
  canvas
      .path("M -16 -22 C -20 -8 -16 6 -8 16 M 16 -22 C 20 -8 16 6 8 16 M 0 -30 C -4 -12 -4 2 0 17")
      .stroke(faded(rgb("#8a4c16"), 0.5), 1.8);
  gloss(canvas, {-18, -28, 30, 14}, -0.1, 0.5);
}

void draw_motif_pretzel(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 28, 94, 18});
  constexpr std::string_view loop =
      "M -22 34 C -10 24 14 8 26 -6 C 42 -24 26 -40 8 -32 C 2 -29 -2 -29 -8 -32 C -26 -40 -42 -24 "
      "-26 -6 C -14 8 10 24 22 34";
  cairo_set_line_cap(canvas.context(), CAIRO_LINE_CAP_ROUND);
  canvas.path(loop).stroke(rgb("#5d2c0c"), 17);
  canvas.path(loop).stroke(rgb("#a4581e"), 14.4);
  canvas.path(loop).stroke(faded(rgb("#cf8236"), 0.9), 8.4);
  canvas.path(loop).stroke(faded(rgb("#efb670"), 0.6), 3);
  for (const auto& [x, y] : {std::pair{-31, -22},
                             {-22, -34},
                             {-4, -31},
                             {14, -34},
                             {30, -28},
                             {33, -16},
                             {-30, -10},
                             {22, -3},
                             {-18, 0},
                             {0, 14},
                             {12, 24},
                             {-14, 26}})
    canvas.rectangle({x - 1.6, y - 1.6, 3.4, 3.2}).fill(rgb("#fffdf4"));
}

void draw_motif_cake(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-48, 30, 98, 16});
  // A slice of layer cake: cut face with two layers of filling, iced top.
  canvas.path("M -44 -8 L 30 -28 C 40 -24 46 -16 46 -10 L 46 28 L -44 38 Z").fill(rgb("#e2b069"));
  canvas.path("M -44 -8 L 46 -10 L 46 28 L -44 38 Z")
      .fill(lit_across({-44, -10, 90, 60}, rgb("#efc580")));
  canvas.path("M -44 5 L 46 1 L 46 6 L -44 11 Z").fill(rgb("#c9263f"));
  canvas.path("M -44 11 L 46 6 L 46 10 L -44 16 Z").fill(rgb("#fff7e6"));
  canvas.path("M -44 22 L 46 16 L 46 20 L -44 27 Z").fill(rgb("#fff7e6"));
  canvas
      .path(
          "M -46 -8 L 30 -29 C 40 -25 48 -16 48 -10 C 44 -3 40 -3 36 -8 C 32 0 26 0 22 -7 C 16 2 8 "
          "0 4 -7 C -2 1 -10 1 -14 -7 C -20 2 -28 0 -32 -7 C -36 -1 -44 0 -46 -8 Z")
      .fill(lit_across({-46, -28, 94, 40}, rgb("#f7a8bd")));
  canvas.path("M 4 -30 C 4 -40 28 -40 28 -28 C 28 -20 4 -20 4 -30 Z").fill(paper_white);
  ball(canvas, {16, -38, 9}, rgb("#c3122a"));
  canvas.path("M 16 -46 C 17 -49 20 -50 23 -50").stroke(rgb("#3f7f2f"), 2);
}

void draw_motif_cracker(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 28, 94, 20});
  placed(canvas, 15, -11, 0.35, 0.85, [&] { one_cracker(canvas); });
  placed(canvas, -12, 9, -0.15, 1.0, [&] { one_cracker(canvas); });
}

void draw_motif_crisps(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-48, 22, 98, 24});
  one_crisp(canvas, 14, -20, 0.4, 0.82);
  one_crisp(canvas, -18, -8, -0.5, 0.86);
  one_crisp(canvas, 14, 16, 0.1, 0.9);
}

void draw_motif_popcorn(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-36, 38, 76, 12});
  for (const auto& [x, y, size] : {std::tuple{-20.0, -12.0, 0.8},
                                   {20.0, -12.0, 0.8},
                                   {0.0, -14.0, 0.85},
                                   {-10.0, -26.0, 0.8},
                                   {12.0, -27.0, 0.78},
                                   {0.0, -38.0, 0.72},
                                   {-28.0, -22.0, 0.55},
                                   {30.0, -30.0, 0.5}})
    popped_corn(canvas, x, y, size);
  const Canvas::Saved saved = canvas.saved();
  canvas.path("M -32 -6 L 32 -6 L 24 44 L -24 44 Z").clip();
  canvas.rectangle({-34, -8, 68, 54}).fill(lit_across({-34, -8, 68, 54}, rgb("#f7f3ea")));
  for (int i = 0; i < 4; ++i) {
    const double x = -26 + i * 16.0;
    canvas.polygon({{x, -8}, {x + 8, -8}, {x * 0.75 + 6, 46}, {x * 0.75, 46}});
    canvas.fill(lit_across({-34, -8, 68, 54}, rgb("#d3202f")));
  }
  canvas.rectangle({-34, -8, 68, 5}).fill(faded(paper_white, 0.6));
}

void draw_motif_pasta(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-48, 22, 98, 24});
  penne(canvas, 10, -26, 0.5);
  penne(canvas, -16, -12, -0.6);
  penne(canvas, 16, 2, -0.15);
  penne(canvas, -10, 18, 0.35);
  penne(canvas, 18, 28, -0.4);
  leaf(canvas, -28, 30, -0.9, 24, rgb("#3f8f3a"));
}

}  // namespace marketgen::assets
