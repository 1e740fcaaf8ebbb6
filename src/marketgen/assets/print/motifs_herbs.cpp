// Herbs, spices, scented blossoms and nuts in their shells on labels.
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "assets/print/motif_brush.h"

namespace marketgen::assets {
namespace {

constexpr Color herb_green = rgb("#4a9a3f");

// A toothed leaf, as mint has it; its foot at the origin, pointing up.
void toothed_leaf(Canvas& canvas, const Color& green) {
  canvas.path(
      "M 0 0 C 8 -2 12 -6 14 -10 L 17 -10 L 18 -17 L 21 -19 L 20 -26 L 22 -29 L 18 -35 L 18 -39 L "
      "13 -43 L 11 -48 L 0 -56 L -11 -48 L -13 -43 L -18 -39 L -18 -35 L -22 -29 L -20 -26 L -21 "
      "-19 L -18 -17 L -17 -10 L -14 -10 C -12 -6 -8 -2 0 0 Z");
  canvas.fill(Paint::linear(
      -20, -44, 18, -8, {{0, lighter(green, 0.35)}, {0.5, green}, {1, darker(green, 0.35)}}));
  canvas
      .path(
          "M 0 -2 L 0 -50 M 0 -12 L 12 -20 M 0 -12 L -12 -20 M 0 -24 L 13 -32 M 0 -24 L -13 -32 M "
          "0 -35 L 9 -41 M 0 -35 L -9 -41")
      .stroke(faded(lighter(green, 0.6), 0.65), 1.5);
}

void lavender_spike(Canvas& canvas) {
  const Color violet = rgb("#8a63c0");
  canvas.path("M 0 50 C 1 30 0 10 0 -8").stroke(rgb("#6d8f4a"), 2.4);
  for (int row = 0; row < 8; ++row) {
    const double y = 6 - row * 7.0;
    const double w = 9 - row * 0.75;
    for (const double side : {-1.0, 1.0, 0.0}) {
      placed(canvas, side * w * 0.7, y, side * 0.7, w / 9, [&] {
        canvas.ellipse(0, -3, 4.4, 6.4)
            .fill(lit({0, -3, 6}, side == 0 ? lighter(violet, 0.15) : violet));
      });
    }
  }
}

void one_walnut(Canvas& canvas, double x, double y, double angle, double size) {
  const Color shell = rgb("#c08a4c");
  placed(canvas, x, y, angle, size, [&] {
    canvas.path(
        "M 0 -30 C 20 -28 28 -10 26 6 C 24 22 12 31 0 31 C -12 31 -24 22 -26 6 C -28 -10 -20 -28 0 "
        "-30 Z");
    canvas.fill(lit({0, 0, 31}, shell));
    canvas.path(
        "M 0 -30 C -3 -10 3 10 0 31 M -10 -26 C -18 -10 -12 4 -18 18 M 10 -26 C 18 -10 12 4 18 18 "
        "M "
        "-6 -14 C -12 -8 -4 0 -9 8 M 7 -16 C 12 -8 5 2 10 10 M -8 22 C -4 18 -8 14 -5 10");
    canvas.stroke(faded(rgb("#75491c"), 0.65), 2.2);
  });
}

void peanut_shell(Canvas& canvas) {
  const Color shell = rgb("#dcae6a");
  canvas.path(
      "M 0 -42 C 16 -42 21 -26 17 -14 C 14 -6 14 2 18 10 C 24 26 16 42 0 42 C -16 42 -24 26 -18 10 "
      "C -14 2 -14 -6 -17 -14 C -21 -26 -16 -42 0 -42 Z");
  canvas.fill(lit_across({-20, -42, 40, 84}, shell));
  for (int i = 0; i < 9; ++i) {
    const double y = -32 + i * 8.0;
    const double w = 12 - 3 * std::cos(y * 0.075);
    placed(canvas, 0, y, 0, 1, [&] {
      cairo_t* c = canvas.context();
      cairo_move_to(c, -w, 0);
      cairo_curve_to(c, -w * 0.5, 3, w * 0.5, 3, w, 0);
      canvas.stroke(faded(rgb("#8f5f24"), 0.45), 1.5);
    });
  }
  canvas.path("M -6 -38 C -9 -14 -7 14 -8 38 M 6 -38 C 9 -14 7 14 8 38")
      .stroke(faded(rgb("#8f5f24"), 0.4), 1.5);
}

void cinnamon_stick(Canvas& canvas, double y) {
  const Color bark = rgb("#a4602c");
  const Area body{-42, y - 7.5, 80, 15};
  canvas.rectangle(body).fill(
      Paint::linear(0,
                    body.y,
                    0,
                    body.bottom(),
                    {{0, lighter(bark, 0.35)}, {0.4, bark}, {1, darker(bark, 0.45)}}));
  placed(canvas, 0, y, 0, 1, [&] {
    canvas.path("M -38 -2 L 30 -3 M -34 3 L 34 2").stroke(faded(rgb("#5d2f10"), 0.4), 1.2);
  });
  canvas.ellipse(38, y, 5, 7.5).fill(rgb("#6f3a16"));
  placed(canvas, 38, y, 0, 1, [&] {
    canvas.path("M 0 -6 C 6 -5 6 5 0 5 C -4 5 -4 -2 -1 -2 C 2 -2 2 2 0 2")
        .stroke(rgb("#d59a5c"), 1.8);
  });
}

void one_almond(Canvas& canvas, double x, double y, double angle, double size) {
  placed(canvas, x, y, angle, size, [&] {
    canvas.path("M 0 -28 C 14 -16 19 6 11 18 C 5 25 -5 25 -11 18 C -19 6 -14 -16 0 -28 Z");
    canvas.fill(lit({0, 0, 26}, rgb("#b4733a")));
    canvas.path("M 0 -21 C -1 -4 -1 8 0 19 M -6 -11 C -9 0 -9 8 -7 16 M 6 -11 C 9 0 9 8 7 16");
    canvas.stroke(faded(rgb("#6f4218"), 0.5), 1.5);
    gloss(canvas, {-10, -14, 9, 16}, 0.2, 0.35);
  });
}

}  // namespace

void draw_motif_almond(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 26, 94, 20});
  leaf(canvas, -2, -16, -0.5, 40, herb_green);
  leaf(canvas, -2, -16, -2.4, 38, darker(herb_green, 0.1));
  one_almond(canvas, 20, -4, 0.6, 0.95);
  one_almond(canvas, -22, 0, -0.5, 1.0);
  one_almond(canvas, 2, 18, 0.15, 1.0);
}

void draw_motif_walnut(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 26, 94, 20});
  leaf(canvas, -16, -26, -0.4, 38, herb_green);
  one_walnut(canvas, -16, -4, -0.2, 1.05);
  // The kernel in the other half of a shell.
  canvas.ellipse(22, 18, 24, 20).fill(lit({22, 18, 24}, rgb("#a9733a")));
  canvas.ellipse(22, 17, 20, 16).fill(rgb("#6f451d"));
  canvas.path(
      "M 20 4 C 8 4 6 14 8 20 C 8 28 16 32 20 30 Z M 24 4 C 36 4 38 14 36 20 C 36 28 28 32 24 30 "
      "Z");
  canvas.fill(lit({22, 16, 18}, rgb("#dba860")));
  canvas
      .path(
          "M 12 12 C 15 14 13 18 16 20 M 32 12 C 29 14 31 18 28 20 M 14 25 L 18 24 M 30 25 L 26 24")
      .stroke(faded(rgb("#85551f"), 0.7), 1.6);
}

void draw_motif_peanut(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 28, 94, 18});
  placed(canvas, 14, -8, 0.75, 0.9, [&] { peanut_shell(canvas); });
  placed(canvas, -14, 0, -0.35, 0.98, [&] { peanut_shell(canvas); });
  for (const auto& [x, y, angle] : {std::tuple{20.0, 30.0, 0.5}, {38.0, 24.0, -0.6}}) {
    placed(canvas, x, y, angle, 1, [&] {
      canvas.ellipse(0, 0, 11, 8).fill(lit({0, 0, 11}, rgb("#b5593a")));
    });
  }
}

void draw_motif_herb(Canvas& canvas, const MotifInk&) {
  // Parsley: three stalks, each with three fringed leaflets of three rounds.
  const Color green = rgb("#3c9440");
  const auto leaflet = [&](double x, double y, double angle, double size, const Color& tone) {
    placed(canvas, x, y, angle, size, [&] {
      for (const auto& [cx, cy] :
           {std::pair{-10, -12}, {10, -12}, {0, -24}, {-7, -20}, {7, -20}, {0, -11}})
        canvas.circle(cx, cy, 8).fill(lit({cx + 0.0, cy + 0.0, 9}, tone));
      canvas.path("M 0 2 L 0 -22 M 0 -6 L -9 -13 M 0 -6 L 9 -13")
          .stroke(faded(lighter(tone, 0.5), 0.7), 1.3);
    });
  };
  canvas.path("M 0 48 C 0 24 0 10 0 -6 M 0 40 C -8 26 -18 14 -28 6 M 0 40 C 8 26 18 14 28 6")
      .stroke(rgb("#6fae4a"), 3.2);
  leaflet(-28, 10, -0.7, 0.95, darker(green, 0.1));
  leaflet(28, 10, 0.7, 0.95, darker(green, 0.1));
  leaflet(-12, 2, -0.35, 0.9, green);
  leaflet(13, 2, 0.35, 0.9, green);
  leaflet(0, -12, 0, 1.15, lighter(green, 0.08));
}

void draw_motif_mint(Canvas& canvas, const MotifInk&) {
  const Color green = rgb("#2fa35a");
  canvas.path("M 0 48 L 0 10").stroke(darker(green, 0.2), 3.4);
  placed(canvas, 0, 20, 1.25, 0.85, [&] { toothed_leaf(canvas, darker(green, 0.15)); });
  placed(canvas, 0, 20, -1.25, 0.85, [&] { toothed_leaf(canvas, darker(green, 0.1)); });
  placed(canvas, 0, 12, 0.62, 0.95, [&] { toothed_leaf(canvas, green); });
  placed(canvas, 0, 12, -0.62, 0.95, [&] { toothed_leaf(canvas, lighter(green, 0.05)); });
  placed(canvas, 0, 8, 0, 1.0, [&] { toothed_leaf(canvas, lighter(green, 0.14)); });
}

void draw_motif_lavender(Canvas& canvas, const MotifInk&) {
  for (const double angle : {-0.42, 0.42, -0.2, 0.2, 0.0})
    placed(canvas, angle * 12, 2, angle, 0.98, [&] { lavender_spike(canvas); });
  canvas.rounded({-9, 26, 18, 6}, 2).fill(lit_across({-9, 26, 18, 6}, rgb("#c9a3d8")));
}

void draw_motif_rose(Canvas& canvas, const MotifInk&) {
  const Color pink = rgb("#e2476f");
  canvas.path("M 2 48 C 0 34 2 24 0 14").stroke(darker(herb_green, 0.2), 4);
  leaf(canvas, 2, 36, -0.35, 40, herb_green);
  leaf(canvas, 0, 38, 3.45, 40, darker(herb_green, 0.1));
  ball(canvas, {0, -8, 32}, darker(pink, 0.2));
  canvas.path("M -32 -10 C -34 10 -18 26 0 26 C -10 12 -14 -4 -10 -22 C -18 -26 -30 -22 -32 -10 Z")
      .fill(lit({-18, 0, 28}, pink));
  canvas.path("M 32 -10 C 34 10 18 26 0 26 C 12 14 16 -4 12 -22 C 20 -26 30 -22 32 -10 Z")
      .fill(lit({16, 0, 28}, darker(pink, 0.08)));
  canvas.path("M -18 -6 C -16 14 -8 22 2 24 C 14 20 20 8 19 -8 C 10 0 -8 2 -18 -6 Z")
      .fill(lit({0, 6, 26}, lighter(pink, 0.1)));
  canvas.path("M -20 -20 C -18 -38 14 -42 20 -22 C 18 -8 -14 -4 -20 -20 Z")
      .fill(lit({0, -24, 22}, darker(pink, 0.12)));
  canvas
      .path(
          "M -13 -21 C -10 -32 10 -34 13 -23 C 10 -13 -8 -12 -7 -20 C -5 -26 6 -26 6 -21 C 5 -18 "
          "-1 -18 -1 -21")
      .stroke(darker(pink, 0.45), 2.6);
  gloss(canvas, {-28, -16, 12, 20}, 0.4, 0.4);
}

void draw_motif_sunflower(Canvas& canvas, const MotifInk&) {
  leaf(canvas, 14, 26, 0.5, 36, herb_green);
  leaf(canvas, -14, 26, 2.64, 36, darker(herb_green, 0.1));
  for (int ring = 0; ring < 2; ++ring) {
    for (int i = 0; i < 16; ++i) {
      placed(canvas, 0, 0, (i + ring * 0.5) * 2 * std::numbers::pi / 16, 1, [&] {
        canvas.path("M 14 -7 C 30 -9 40 -6 47 0 C 40 6 30 9 14 7 Z");
        canvas.fill(Paint::linear(14,
                                  0,
                                  47,
                                  0,
                                  {{0, rgb("#e08a10")},
                                   {0.5, ring == 0 ? rgb("#f0ab12") : rgb("#fcc62a")},
                                   {1, rgb("#ffe36a")}}));
      });
    }
  }
  canvas.circle(0, 0, 21).fill(lit({0, 0, 21}, rgb("#5d3414")));
  // Seeds lie at the golden angle (Vogel 1979).
  constexpr double golden_angle = 2.39996323;
  for (int i = 2; i < 90; ++i) {
    const double r = 2.05 * std::sqrt(i), a = i * golden_angle;
    canvas.circle(r * std::cos(a), r * std::sin(a), 1.0)
        .fill(i < 36 ? rgb("#8a5a1c") : rgb("#c98a2e"));
  }
}

void draw_motif_sesame(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-48, 14, 98, 34});
  for (int i = 0; i < 64; ++i) {
    const double r = 5.2 * std::sqrt(i + 0.3), a = i * 2.39996323;
    placed(canvas, r * std::cos(a), 8 + r * std::sin(a) * 0.78, a * 1.7, 1, [&] {
      canvas.path("M 0 -7.5 C 5 -2 5 5 0 6.5 C -5 5 -5 -2 0 -7.5 Z");
      canvas.fill_and_stroke(lit({0, 0, 7}, i % 6 == 5 ? rgb("#d9b876") : rgb("#f3e3b8")),
                             faded(rgb("#8a6a30"), 0.5),
                             0.8);
    });
  }
}

void draw_motif_oat(Canvas& canvas, const MotifInk&) {
  const Color straw = rgb("#d8a845");
  canvas.path(
      "M 2 50 C -2 20 -2 -10 8 -44 M 0 22 C -14 14 -22 10 -28 12 M -1 22 C 12 12 20 8 28 10 M 0 2 "
      "C "
      "-12 -6 -20 -10 -26 -8 M 0 2 C 12 -8 20 -12 27 -10 M 3 -18 C -6 -26 -12 -30 -18 -28 M 4 -18 "
      "C 14 -26 20 -30 26 -28");
  canvas.stroke(darker(straw, 0.15), 2);
  for (const auto& [x, y, angle] : {std::tuple{-28.0, 12.0, 0.5},
                                    {28.0, 10.0, -0.5},
                                    {-26.0, -8.0, 0.5},
                                    {27.0, -10.0, -0.5},
                                    {-18.0, -28.0, 0.4},
                                    {26.0, -28.0, -0.5},
                                    {8.0, -44.0, 0.0},
                                    {-12.0, 14.0, 0.2},
                                    {14.0, 10.0, -0.2},
                                    {-10.0, -8.0, 0.2},
                                    {13.0, -10.0, -0.2}}) {
    placed(canvas, x, y, angle, 1, [&] {
      canvas.path("M 0 0 C 8 5 7 18 1 25 C 0 26 -1 26 -1 25 C -7 18 -8 5 0 0 Z");
      canvas.fill(Paint::linear(
          -6, 0, 7, 10, {{0, lighter(straw, 0.5)}, {0.5, straw}, {1, darker(straw, 0.3)}}));
      canvas.path("M 0 1 L 0 24").stroke(faded(darker(straw, 0.4), 0.5), 0.9);
    });
  }
}

void draw_motif_cinnamon(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-48, 22, 98, 22});
  placed(canvas, 0, -2, -0.5, 1, [&] { cinnamon_stick(canvas, -12); });
  placed(canvas, 2, 2, -0.32, 1, [&] { cinnamon_stick(canvas, 6); });
  // A star of anise.
  for (int i = 0; i < 8; ++i) {
    placed(canvas, -18, 26, i * std::numbers::pi / 4, 1, [&] {
      canvas.path("M 2 0 C 8 -7 14 -6 20 0 C 14 6 8 7 2 0 Z")
          .fill(lit({11, 0, 10}, rgb("#7c421a")));
      canvas.ellipse(12, 0, 3.4, 2).fill(rgb("#d59a5c"));
    });
  }
}

void draw_motif_vanilla(Canvas& canvas, const MotifInk&) {
  for (const auto& [shift, tone] : {std::pair{-6.0, 0.0}, {4.0, 0.25}}) {
    placed(canvas, shift, shift * 0.6, 0, 1, [&] {
      canvas.path(
          "M 40 -38 C 22 -6 -6 28 -42 44 C -44 46 -46 44 -44 42 C -14 22 12 -8 34 -42 C 37 -46 42 "
          "-42 40 -38 Z");
      canvas.fill(Paint::linear(
          -10,
          -4,
          4,
          8,
          {{0, rgb("#7a4a26")}, {0.5, darker(rgb("#4a2814"), tone)}, {1, rgb("#24110a")}}));
    });
  }
  // The orchid's blossom.
  for (int i = 0; i < 5; ++i) {
    placed(canvas, -8, -10, -1.57 + i * 2 * std::numbers::pi / 5, 1, [&] {
      canvas.path("M 4 0 C 10 -14 26 -14 36 0 C 26 14 10 14 4 0 Z");
      canvas.fill_and_stroke(
          Paint::linear(
              4, 0, 36, 0, {{0, rgb("#f3d46a")}, {0.4, rgb("#fff3cf")}, {1, paper_white}}),
          faded(rgb("#b89a52"), 0.6),
          1);
      canvas.path("M 8 0 L 30 0").stroke(faded(rgb("#c9a950"), 0.6), 1);
    });
  }
  ball(canvas, {-8, -10, 8}, rgb("#f0b32a"));
}

}  // namespace marketgen::assets
