// Household things and pets on labels.
#include <numbers>
#include <string_view>
#include <tuple>
#include <utility>

#include "assets/print/motif_brush.h"

namespace marketgen::assets {
namespace {

void one_battery(Canvas& canvas, double x, double angle, const Color& jacket) {
  placed(canvas, x, 2, angle, 1, [&] {
    canvas.rounded({-5, -46, 10, 9}, 2).fill(lit_across({-5, -46, 10, 9}, rgb("#b8bec4")));
    const Area body{-14, -39, 28, 80};
    const auto cylinder = [](const Color& base) {
      return Paint::linear(-14,
                           0,
                           14,
                           0,
                           {{0, darker(base, 0.35)},
                            {0.3, lighter(base, 0.4)},
                            {0.6, base},
                            {1, darker(base, 0.5)}});
    };
    canvas.rounded(body, 4).fill(cylinder(jacket));
    canvas.rounded({-14, -39, 28, 24}, 4).fill(cylinder(rgb("#d99a3c")));
    canvas.path("M -6 -27 L 6 -27 M 0 -33 L 0 -21").stroke(paper_white, 3.4);
    canvas.path("M 3 -6 L -8 14 L -1 14 L -4 30 L 8 8 L 1 8 Z").fill(rgb("#ffe14a"));
  });
}

// A pointed ear and its inside, for the left side.
void pet_face(Canvas& canvas, const Color& fur) {
  canvas.path(
      "M -34 4 C -34 -18 -18 -26 0 -26 C 18 -26 34 -18 34 4 C 34 26 18 36 0 36 C -18 36 -34 26 -34 "
      "4 Z");
  canvas.fill(lit({0, 2, 38}, fur));
}

void pet_eyes(Canvas& canvas, const Color& iris) {
  for (const double x : {-13.0, 13.0}) {
    canvas.ellipse(x, -1, 5.6, 6.4).fill(iris);
    canvas.ellipse(x, -1, 3, 5).fill(rgb("#17110d"));
    canvas.circle(x - 1.6, -3.4, 1.6).fill(paper_white);
  }
}

void flame(Canvas& canvas, double x, double y, double size) {
  placed(canvas, x, y, 0, size, [&] {
    canvas.circle(0, -12, 26)
        .fill(Paint::radial(
            0, -12, 26, 0, -12, {{0, faded(rgb("#ffe9a0"), 0.7)}, {1, faded(rgb("#ffe9a0"), 0)}}));
    canvas.path("M 0 -30 C 10 -16 11 -8 8 -1 C 5 4 -5 4 -8 -1 C -11 -8 -6 -14 0 -30 Z");
    canvas.fill(Paint::linear(
        0, -30, 0, 3, {{0, rgb("#ffd34a")}, {0.5, rgb("#ff9d1e")}, {1, rgb("#e8551c")}}));
    canvas.path("M 0 -16 C 5 -8 5 -4 3 0 C 1 2 -1 2 -3 0 C -5 -4 -4 -8 0 -16 Z")
        .fill(rgb("#fff6c2"));
  });
}

}  // namespace

void draw_motif_battery(Canvas& canvas, const MotifInk& ink) {
  const Color jacket = contrast(ink.primary, rgb("#d99a3c")) > 1.6 ? ink.primary : rgb("#23282e");
  ground_shadow(canvas, {-40, 36, 82, 12});
  one_battery(canvas, -20, -0.08, darker(jacket, 0.1));
  one_battery(canvas, 20, 0.08, jacket);
}

void draw_motif_bulb(Canvas& canvas, const MotifInk&) {
  canvas.circle(0, -6, 44).fill(Paint::radial(0,
                                              -6,
                                              44,
                                              0,
                                              -6,
                                              {{0, faded(rgb("#fff2b0"), 0.9)},
                                               {0.6, faded(rgb("#ffe37a"), 0.35)},
                                               {1, faded(rgb("#ffe37a"), 0)}}));
  canvas.path(
      "M -14 24 C -14 14 -30 4 -30 -14 C -30 -32 -16 -44 0 -44 C 16 -44 30 -32 30 -14 C 30 4 14 14 "
      "14 24 Z");
  canvas.fill_and_stroke(
      Paint::radial(
          0, -12, 36, -10, -22, {{0, paper_white}, {0.5, rgb("#fff3b8")}, {1, rgb("#f2c53d")}}),
      faded(rgb("#a9801a"), 0.8),
      1.4);
  canvas.path("M -8 22 L -10 -4 L -4 -10 L 0 -4 L 4 -10 L 10 -4 L 8 22")
      .stroke(rgb("#e08a10"), 2.2);
  for (int i = 0; i < 3; ++i)
    canvas.rounded({-13, 24 + i * 6.5, 26, 6}, 2.6)
        .fill(lit_across({-13, 24, 26, 20}, rgb("#aab3ba")));
  canvas.path("M -8 44 L 8 44 L 4 49 L -4 49 Z").fill(rgb("#3a3f44"));
}

void draw_motif_candle(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 34, 94, 14});
  const auto candle = [&](double x, double top, double width, const Color& wax) {
    const Area body{x - width, top, 2 * width, 42 - top};
    canvas.rectangle(body).fill(Paint::linear(
        x - width,
        0,
        x + width,
        0,
        {{0, darker(wax, 0.15)}, {0.35, lighter(wax, 0.45)}, {0.65, wax}, {1, darker(wax, 0.35)}}));
    canvas.ellipse(x, 42, width, width * 0.28).fill(darker(wax, 0.25));
    canvas.ellipse(x, top, width, width * 0.28).fill(lighter(wax, 0.55));
    canvas.rectangle({x - 0.8, top - 7, 1.6, 8}).fill(rgb("#3a2a20"));
    flame(canvas, x, top - 5, 0.62);
  };
  candle(-24, 4, 13, rgb("#d86b5a"));
  candle(24, 14, 14, rgb("#8fb37a"));
  candle(0, -18, 13, rgb("#f0e2c0"));
}

void draw_motif_dish(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-48, 32, 98, 14});
  canvas.circle(0, 0, 44).fill(Paint::radial(
      0, 0, 44, -14, -16, {{0, paper_white}, {0.8, rgb("#eef4f8")}, {1, rgb("#b4c6d2")}}));
  canvas.circle(0, 0, 43).stroke(rgb("#5b93bd"), 2);
  canvas.circle(0, 0, 28).fill(Paint::radial(
      0, 0, 30, 8, 10, {{0, paper_white}, {0.8, rgb("#f4f8fa")}, {1, rgb("#cbd8e0")}}));
  canvas.circle(0, 0, 36).stroke(faded(rgb("#5b93bd"), 0.55), 1.4);
  gloss(canvas, {-34, -36, 36, 22}, -0.7, 1);
  for (const auto& [x, y, size] : {std::tuple{26.0, -24.0, 1.7}, {34.0, -4.0, 0.9}}) {
    placed(canvas, x, y, 0, size, [&] {
      canvas.path("M 0 -10 C 1 -3 3 -1 10 0 C 3 1 1 3 0 10 C -1 3 -3 1 -10 0 C -3 -1 -1 -3 0 -10 Z")
          .fill_and_stroke(paper_white, faded(rgb("#2f7fb5"), 0.9), 1);
    });
  }
}

void draw_motif_hand(Canvas& canvas, const MotifInk&) {
  const Color skin = rgb("#f0c39c");
  const Color line = rgb("#b0764c");
  // Fingers first, palm over their roots.
  for (const auto& [x, y, angle, length] : {std::tuple{-19.0, 0.0, -0.28, 32.0},
                                            {-7.0, -6.0, -0.08, 40.0},
                                            {6.0, -6.0, 0.10, 38.0},
                                            {18.0, 1.0, 0.30, 29.0}}) {
    placed(canvas, x, y, angle, 1, [&] {
      canvas.rounded({-6.2, -length, 12.4, length + 14}, 6.2)
          .fill_and_stroke(
              Paint::linear(
                  -6, 0, 6, 0, {{0, lighter(skin, 0.35)}, {0.5, skin}, {1, darker(skin, 0.15)}}),
              line,
              1.3);
    });
  }
  placed(canvas, -22, 20, -1.0, 1, [&] {
    canvas.rounded({-6.5, -26, 13, 36}, 6.5)
        .fill_and_stroke(
            Paint::linear(
                -6, 0, 6, 0, {{0, lighter(skin, 0.35)}, {0.5, skin}, {1, darker(skin, 0.15)}}),
            line,
            1.3);
  });
  canvas.path("M -25 2 C -20 -6 18 -6 24 4 C 27 18 22 34 12 46 L -12 46 C -22 36 -28 20 -25 2 Z");
  canvas.fill(Paint::radial(
      0, 18, 34, -8, 8, {{0, lighter(skin, 0.4)}, {0.6, skin}, {1, darker(skin, 0.18)}}));
  canvas.path("M -18 16 C -8 8 8 8 19 12 M -16 26 C -4 18 8 20 15 28")
      .stroke(faded(line, 0.6), 1.6);
}

void draw_motif_razor(Canvas& canvas, const MotifInk& ink) {
  const Color grip = contrast(ink.accent, ink.primary) > 1.5 ? ink.accent : rgb("#2b6cb0");
  placed(canvas, 0, 0, 0.6, 1, [&] {
    canvas.rounded({-6, -22, 12, 70}, 6)
        .fill(Paint::linear(
            -6, 0, 6, 0, {{0, lighter(grip, 0.4)}, {0.5, grip}, {1, darker(grip, 0.45)}}));
    for (int i = 0; i < 6; ++i)
      canvas.rounded({-4, 8 + i * 5.5, 8, 2.4}, 1.2).fill(faded(darker(grip, 0.6), 0.6));
    const Area head{-26, -42, 52, 24};
    canvas.rounded(head, 5).fill(lit_across(head, rgb("#aeb8c0")));
    for (int i = 0; i < 3; ++i)
      canvas.rectangle({-22, -38 + i * 5.2, 44, 2.6})
          .fill(Paint::linear(
              -22, 0, 22, 0, {{0, rgb("#5b666e")}, {0.5, paper_white}, {1, rgb("#5b666e")}}));
    canvas.rounded({-22, -23, 44, 3.4}, 1.6).fill(rgb("#7fc6a4"));
  });
}

void draw_motif_shirt(Canvas& canvas, const MotifInk& ink) {
  const Color cloth = contrast(paper_white, ink.primary) > 1.5 ? rgb("#fbfdff") : rgb("#8fc0e8");
  ground_shadow(canvas, {-36, 38, 74, 10});
  canvas.path(
      "M -14 -36 L -30 -30 L -48 -8 L -36 4 L -26 -6 L -27 42 L 27 42 L 26 -6 L 36 4 L 48 -8 L 30 "
      "-30 L 14 -36 C 8 -26 -8 -26 -14 -36 Z");
  canvas.fill_and_stroke(
      Paint::linear(
          -30, -30, 24, 40, {{0, cloth}, {0.6, darker(cloth, 0.04)}, {1, darker(cloth, 0.22)}}),
      faded(rgb("#5b7fa0"), 0.9),
      1.6);
  canvas.path("M -14 -36 C -8 -22 8 -22 14 -36").stroke(rgb("#5b7fa0"), 2.2);
  canvas
      .path("M -26 -6 C -22 4 -22 20 -24 30 M 26 -6 C 22 4 22 20 24 30 M -8 -18 C -4 0 -6 20 -2 36")
      .stroke(faded(rgb("#5b7fa0"), 0.35), 1.8);
  placed(canvas, 22, -2, 0, 1.3, [&] {
    canvas.path("M 0 -10 C 1 -3 3 -1 10 0 C 3 1 1 3 0 10 C -1 3 -3 1 -10 0 C -3 -1 -1 -3 0 -10 Z")
        .fill(rgb("#38b6e8"));
  });
}

void draw_motif_sun(Canvas& canvas, const MotifInk&) {
  for (int ray = 0; ray < 12; ++ray) {
    placed(canvas, 0, 0, ray * std::numbers::pi / 6, 1, [&] {
      canvas.path(ray % 2 == 0 ? "M 28 -7 L 49 0 L 28 7 Z" : "M 28 -5 L 42 0 L 28 5 Z");
      canvas.fill_and_stroke(rgb("#fbb31c"), faded(rgb("#d9860a"), 0.7), 1);
    });
  }
  canvas.circle(0, 0, 27).fill_and_stroke(
      Paint::radial(
          0, 0, 27, -8, -9, {{0, rgb("#fff6bd")}, {0.5, rgb("#ffdb3f")}, {1, rgb("#f59f15")}}),
      faded(rgb("#d9860a"), 0.7),
      1.2);
}

void draw_motif_tissue(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 32, 94, 14});
  const Color paper = rgb("#fbfbf8");
  // A roll, standing, with its loose end.
  canvas.path("M -36 -26 L -36 30 C -36 40 20 40 20 30 L 20 -26 Z");
  canvas.fill_and_stroke(
      Paint::linear(
          -36,
          0,
          20,
          0,
          {{0, rgb("#d8e0e6")}, {0.3, paper}, {0.7, rgb("#f0f3f4")}, {1, rgb("#b4c0c8")}}),
      faded(rgb("#8fa3b2"), 0.7),
      1.2);
  canvas.path("M 20 -26 L 38 -22 L 40 36 C 34 30 28 40 20 33 Z")
      .fill_and_stroke(lit_across({20, -26, 20, 66}, paper), faded(rgb("#8fa3b2"), 0.7), 1.2);
  canvas.path("M 21 4 L 39 8").stroke(faded(rgb("#8fa3b2"), 0.7), 1.2);
  canvas.ellipse(-8, -26, 28, 10).fill_and_stroke(paper, faded(rgb("#8fa3b2"), 0.8), 1.2);
  for (const double r : {22.0, 16.0})
    canvas.ellipse(-8, -26, r, r * 0.36).stroke(faded(rgb("#8fa3b2"), 0.5), 1);
  canvas.ellipse(-8, -26, 9, 3.4).fill(rgb("#a58a66"));
}

void draw_motif_toilet(Canvas& canvas, const MotifInk&) {
  const Color china = rgb("#f4f8fa");
  const Color edge = rgb("#93aab8");
  ground_shadow(canvas, {-38, 38, 78, 10});
  canvas.rounded({-24, -46, 48, 32}, 4)
      .fill_and_stroke(lit_across({-24, -46, 48, 44}, china), edge, 1.4);
  canvas.rounded({-5, -49, 10, 4}, 1.5).fill(rgb("#aab7bf"));
  canvas.path("M -15 16 C -12 30 -16 36 -18 44 L 18 44 C 16 36 12 30 15 16 Z")
      .fill_and_stroke(lit_across({-18, 16, 36, 30}, darker(china, 0.05)), edge, 1.4);
  canvas.path("M -34 -6 C -34 16 -18 24 0 24 C 18 24 34 16 34 -6 Z")
      .fill_and_stroke(lit_across({-34, -6, 68, 40}, china), edge, 1.4);
  canvas.ellipse(0, -6, 35, 11).fill_and_stroke(paper_white, edge, 1.6);
  canvas.ellipse(0, -5, 26, 7)
      .fill(Paint::linear(0, -12, 0, 2, {{0, rgb("#b7d8ea")}, {1, rgb("#6cc0f0")}}));
}

void draw_motif_window(Canvas& canvas, const MotifInk&) {
  const Area frame{-38, -44, 76, 88};
  canvas.rounded(frame, 3).fill(lit_across(frame, rgb("#f3ede2")));
  canvas.rounded(frame, 3).stroke(rgb("#9a8f7c"), 1.6);
  for (const double x : {-32.0, 3.0}) {
    for (const double y : {-38.0, 3.0}) {
      const Area pane{x, y, 29, 35};
      canvas.rectangle(pane).fill(Paint::linear(
          x, y, x + 29, y + 35, {{0, rgb("#cfeeff")}, {0.5, rgb("#8fd0f4")}, {1, rgb("#4fa3d8")}}));
      const Canvas::Saved saved = canvas.saved();
      canvas.rectangle(pane).clip();
      placed(canvas, x, y, 0, 1, [&] {
        canvas.path("M 4 35 L 22 0 L 30 0 L 12 35 Z").fill(faded(paper_white, 0.45));
      });
    }
  }
  placed(canvas, 22, -24, 0, 1.6, [&] {
    canvas.path("M 0 -10 C 1 -3 3 -1 10 0 C 3 1 1 3 0 10 C -1 3 -3 1 -10 0 C -3 -1 -1 -3 0 -10 Z")
        .fill(paper_white);
  });
}

void draw_motif_cat(Canvas& canvas, const MotifInk&) {
  const Color fur = rgb("#e09a4a");
  for (const double side : {-1.0, 1.0}) {
    const Canvas::Saved saved = canvas.saved();
    canvas.scale(side, 1);
    canvas.path("M -32 -4 C -36 -24 -34 -38 -30 -44 C -20 -40 -10 -32 -6 -24 Z")
        .fill(lit({-24, -22, 24}, fur));
    canvas.path("M -29 -12 C -31 -24 -30 -33 -28 -37 C -22 -34 -16 -29 -13 -24 Z")
        .fill(rgb("#f3b7a2"));
  }
  pet_face(canvas, fur);
  canvas.path("M 0 -25 L 0 -14 M -9 -23 L -7 -14 M 9 -23 L 7 -14 M -33 6 L -24 8 M 33 6 L 24 8")
      .stroke(darker(fur, 0.4), 3.6);
  canvas.ellipse(-8, 16, 10, 8).fill(rgb("#fdf0dc"));
  canvas.ellipse(8, 16, 10, 8).fill(rgb("#fdf0dc"));
  pet_eyes(canvas, rgb("#9bcf4a"));
  canvas.path("M -4 9 L 4 9 L 0 14 Z").fill(rgb("#d9566a"));
  canvas.path("M 0 14 C 0 20 -8 21 -10 18 M 0 14 C 0 20 8 21 10 18").stroke(rgb("#5d3414"), 1.8);
  canvas.path("M -14 14 L -42 8 M -14 18 L -42 20 M 14 14 L 42 8 M 14 18 L 42 20")
      .stroke(faded(paper_white, 0.95), 1.5);
}

void draw_motif_dog(Canvas& canvas, const MotifInk&) {
  const Color fur = rgb("#b9834a");
  pet_face(canvas, fur);
  canvas.path("M -7 -26 C -9 -8 -13 8 -16 16 C -4 26 4 26 16 16 C 13 8 9 -8 7 -26 Z")
      .fill(rgb("#f6e9d2"));
  for (const double side : {-1.0, 1.0}) {
    const Canvas::Saved saved = canvas.saved();
    canvas.scale(side, 1);
    canvas.path("M -22 -24 C -36 -26 -46 -12 -44 8 C -43 20 -34 22 -30 12 C -27 2 -24 -8 -18 -18 Z")
        .fill(lit({-36, -4, 24}, darker(fur, 0.35)));
  }
  canvas.ellipse(0, 20, 17, 13).fill(lit({0, 18, 18}, rgb("#fbf2e2")));
  pet_eyes(canvas, rgb("#6b4423"));
  canvas.path("M -8 11 C -8 6 8 6 8 11 C 8 16 3 19 0 19 C -3 19 -8 16 -8 11 Z")
      .fill(rgb("#241a16"));
  gloss(canvas, {-5, 8, 6, 4}, 0, 0.8);
  canvas.path("M 0 19 L 0 24 M -9 24 C -6 28 -2 27 0 24 C 2 27 6 28 9 24")
      .stroke(rgb("#3a2a22"), 1.8);
  canvas.path("M -4 27 L 4 27 C 5 36 -5 36 -4 27 Z").fill(rgb("#e8697a"));
}

void draw_motif_fish_bowl(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-40, 38, 82, 10});
  canvas.path("M -20 -38 C -54 -20 -50 30 -22 42 L 22 42 C 50 30 54 -20 20 -38 Z")
      .fill(faded(rgb("#e4f4fb"), 0.9));
  canvas.path("M -40 -14 C -48 16 -38 34 -21 40 L 21 40 C 38 34 48 16 40 -14 Z");
  canvas.fill(Paint::linear(0, -14, 0, 40, {{0, rgb("#a9dcf3")}, {1, rgb("#3f9ad0")}}));
  canvas.ellipse(0, -14, 40, 6).fill(rgb("#d3eefa"));
  canvas.path("M 12 12 L 30 0 C 27 8 27 18 30 26 Z").fill(rgb("#f07a1c"));
  canvas.path("M -26 12 C -16 -4 10 -4 18 12 C 10 28 -16 28 -26 12 Z")
      .fill(lit({-4, 12, 24}, rgb("#f58a1f")));
  canvas.path("M -4 -2 C 0 8 0 16 -4 26 M 6 1 C 9 8 9 16 6 23")
      .stroke(faded(paper_white, 0.85), 3.4);
  canvas.circle(-16, 9, 3.2).fill(paper_white);
  canvas.circle(-16.5, 9, 1.9).fill(rgb("#10222c"));
  for (const Ball& air : {Ball{-30, -2, 2.4}, Ball{-27, -9, 1.7}, Ball{-31, 6, 1.4}})
    canvas.circle(air.x, air.y, air.radius)
        .fill_and_stroke(faded(paper_white, 0.7), faded(rgb("#2f7fb5"), 0.7), 0.8);
  canvas.ellipse(0, -38, 21, 4).stroke(rgb("#8fb6c8"), 2);
  gloss(canvas, {-38, -22, 12, 40}, 0.2, 0.8);
}

}  // namespace marketgen::assets
