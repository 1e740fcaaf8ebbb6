// Cold cuts, seafood and dairy on labels.
#include <cmath>
#include <numbers>
#include <string_view>
#include <tuple>
#include <utility>

#include "assets/print/motif_brush.h"

namespace marketgen::assets {
namespace {

constexpr Color parsley = rgb("#3f8f3a");

void bacon_strip(Canvas& canvas, double y, double phase) {
  const auto band = [&](double top, double width, const Color& color) {
    cairo_t* c = canvas.context();
    cairo_move_to(c, -45, y + top);
    for (int i = 0; i < 4; ++i) {
      const double x = -45 + i * 22.5;
      const double swing = (i % 2 == 0 ? 1 : -1) * phase;
      cairo_curve_to(c, x + 8, y + top - swing, x + 15, y + top - swing, x + 22.5, y + top);
    }
    canvas.stroke(color, width);
  };
  band(1.4, 22, rgb("#7c2417"));
  band(0, 20, rgb("#b5402c"));
  band(-6.5, 4.5, rgb("#f6d3bd"));
  band(1.5, 3.6, rgb("#f2c2a6"));
  band(7, 3, rgb("#f6d3bd"));
}

// A frankfurter bent a little, from (-40, 8) up to (40, 8).
void one_sausage(Canvas& canvas, const Color& skin) {
  constexpr std::string_view bend = "M -34 6 C -18 -12 18 -12 34 6";
  cairo_set_line_cap(canvas.context(), CAIRO_LINE_CAP_ROUND);
  canvas.path(bend).stroke(darker(skin, 0.45), 25);
  canvas.path(bend).stroke(skin, 22);
  placed(
      canvas, 0, -3, 0, 1, [&] { canvas.path(bend).stroke(faded(lighter(skin, 0.35), 0.8), 10); });
  placed(canvas, 0, -6, 0, 1, [&] { canvas.path(bend).stroke(faded(paper_white, 0.4), 3); });
  for (const double x : {-16.0, 0.0, 16.0}) {
    placed(canvas, x, -7 + x * x * 0.012, 0.5, 1, [&] {
      canvas.path("M -2 -7 L 2 7").stroke(faded(darker(skin, 0.6), 0.7), 2.6);
    });
  }
  canvas.path("M -44 12 L -50 16 M 44 12 L 50 16").stroke(rgb("#d9b07a"), 3);
}

void one_shrimp(Canvas& canvas) {
  const Color pink = rgb("#f58b6a");
  canvas.path("M 20 34 C 10 44 -2 46 -12 42 C -4 38 4 34 10 28 Z").fill(darker(pink, 0.15));
  canvas.path("M 20 34 C 22 42 30 48 40 46 C 38 38 34 32 26 28 Z").fill(pink);
  // The tail's segments, from the fan up round to the head.
  constexpr double bend = 0.48;
  for (int i = 0; i < 7; ++i) {
    const double a = 1.1 - i * bend;
    const double r = 20 + i * 0.6;
    const double x = 4 + std::cos(a) * r, y = 4 + std::sin(a) * r;
    const double size = 9 + i * 1.35;
    canvas.circle(x, y, size)
        .fill_and_stroke(lit({x, y, size}, i % 2 == 0 ? pink : lighter(pink, 0.22)),
                         faded(rgb("#b5402c"), 0.55),
                         1.4);
  }
  canvas.path("M -12 -14 C -26 -12 -38 -2 -44 10 C -34 8 -22 8 -12 12 Z")
      .fill(lit({-22, 0, 24}, pink));
  canvas
      .path(
          "M -36 4 C -44 16 -46 28 -40 42 M -32 6 C -36 18 -36 26 -30 36 M -14 14 L -16 26 M -6 16 "
          "L -7 27")
      .stroke(rgb("#d9583a"), 1.8);
  canvas.circle(-27, -1, 3.2).fill(rgb("#241210"));
  canvas.circle(-28, -2, 1).fill(paper_white);
}

}  // namespace

void draw_motif_bacon(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-48, 22, 98, 24});
  placed(canvas, 0, 0, -0.3, 0.84, [&] {
    bacon_strip(canvas, -22, 12);
    bacon_strip(canvas, 2, -12);
    bacon_strip(canvas, 26, 12);
  });
}

void draw_motif_ham(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-48, 24, 98, 22});
  const auto slice = [&](double x, double y, double angle, double size) {
    placed(canvas, x, y, angle, size, [&] {
      canvas
          .path(
              "M -36 2 C -40 -22 -14 -34 8 -32 C 32 -30 42 -10 36 8 C 30 26 6 32 -14 28 C -28 26 "
              "-34 16 -36 2 Z")
          .fill(rgb("#fbeee2"));
      canvas.path(
          "M -31 2 C -35 -18 -12 -28 8 -27 C 28 -25 36 -8 31 7 C 26 22 5 27 -12 23 C -24 21 -30 13 "
          "-31 2 Z");
      canvas.fill(Paint::radial(
          0, 0, 36, -10, -10, {{0, rgb("#f9b9b0")}, {0.6, rgb("#ef9a94")}, {1, rgb("#d6716f")}}));
      canvas.path("M -18 -8 C -6 -14 6 -10 16 -14 M -12 10 C 0 4 12 10 20 4")
          .stroke(faded(rgb("#fde4da"), 0.8), 2.4);
    });
  };
  slice(14, -14, 0.4, 0.82);
  slice(-4, 0, 0.1, 0.92);
  slice(-6, 14, -0.25, 0.86);
  leaf(canvas, 26, 34, -0.6, 22, parsley);
  leaf(canvas, 26, 34, -1.4, 22, darker(parsley, 0.1));
}

void draw_motif_sausage(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-48, 24, 98, 20});
  placed(canvas, 2, -16, -0.25, 0.9, [&] { one_sausage(canvas, rgb("#b5502a")); });
  placed(canvas, -2, 14, -0.2, 0.94, [&] { one_sausage(canvas, rgb("#a4421f")); });
  leaf(canvas, 22, 38, -0.5, 22, parsley);
}

void draw_motif_salmon(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-48, 24, 98, 20});
  const Color flesh = rgb("#f58a5f");
  canvas
      .path(
          "M -44 14 C -46 -4 -34 -24 -8 -28 C 14 -31 36 -24 46 -6 L 44 12 C 30 4 14 8 0 18 C -16 "
          "28 -40 30 -44 14 Z")
      .fill(rgb("#8fa0a8"));
  canvas.path(
      "M -44 8 C -44 -8 -32 -26 -8 -30 C 14 -33 36 -26 46 -8 C 30 -6 14 2 0 12 C -16 22 -42 24 -44 "
      "8 Z");
  canvas.fill(Paint::linear(
      -30, -28, 20, 16, {{0, lighter(flesh, 0.35)}, {0.5, flesh}, {1, rgb("#d9562f")}}));
  canvas.path(
      "M -34 -10 C -28 -4 -26 6 -30 16 M -22 -20 C -14 -10 -12 4 -18 16 M -8 -26 C 0 -16 2 -2 -4 "
      "10 M "
      "8 -28 C 16 -20 16 -8 10 4 M 24 -24 C 30 -18 30 -10 24 -3");
  canvas.stroke(faded(rgb("#ffe3d0"), 0.9), 2.8);
  canvas.circle(24, 26, 15).fill(lit({24, 26, 15}, rgb("#f2cb1c")));
  canvas.circle(24, 26, 12).fill(rgb("#fff2a6"));
  for (int i = 0; i < 8; ++i) {
    placed(canvas, 24, 26, i * std::numbers::pi / 4, 1, [&] {
      canvas.path("M 2 0 C 5 -4 9 -4 11 -2 L 11 2 C 9 4 5 4 2 0 Z").fill(rgb("#f7dc4a"));
    });
  }
  leaf(canvas, -20, 36, -0.4, 26, parsley);
}

void draw_motif_shrimp(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-44, 32, 90, 14});
  placed(canvas, 2, -2, 0.05, 0.98, [&] { one_shrimp(canvas); });
}

void draw_motif_crab(Canvas& canvas, const MotifInk&) {
  const Color red = rgb("#d9432a");
  ground_shadow(canvas, {-46, 30, 94, 16});
  for (const double side : {-1.0, 1.0}) {
    const Canvas::Saved saved = canvas.saved();
    canvas.scale(side, 1);
    canvas
        .path("M 22 14 C 34 12 40 18 44 28 M 20 20 C 30 22 34 28 34 38 M 14 24 C 20 28 22 34 20 42")
        .stroke(darker(red, 0.2), 5);
    canvas.path("M 22 4 C 34 2 40 -6 38 -14").stroke(darker(red, 0.15), 7);
    canvas
        .path(
            "M 38 -12 C 26 -18 24 -34 34 -42 C 34 -34 36 -30 40 -28 C 40 -34 44 -38 48 -38 C 52 "
            "-26 48 -14 38 -12 Z")
        .fill(lit({36, -26, 18}, red));
    canvas.path("M 8 -12 L 10 -22").stroke(darker(red, 0.2), 3);
    ball(canvas, {10, -24, 4.4}, rgb("#241210"));
  }
  canvas
      .path(
          "M -32 4 C -32 -12 -16 -18 0 -18 C 16 -18 32 -12 32 4 C 32 22 14 30 0 30 C -14 30 -32 22 "
          "-32 4 Z")
      .fill(lit({0, 4, 34}, red));
  gloss(canvas, {-22, -13, 26, 13}, -0.2, 0.6);
  canvas.path("M -12 16 C -5 21 5 21 12 16").stroke(faded(rgb("#6d160c"), 0.7), 2.4);
}

void draw_motif_butter(Canvas& canvas, const MotifInk&) {
  const Color yellow = rgb("#f9dc62");
  ground_shadow(canvas, {-50, 26, 100, 20});
  canvas.ellipse(0, 26, 48, 15).fill(lit({0, 26, 48}, rgb("#e4ecf2")));
  canvas.ellipse(0, 24, 40, 11).fill(rgb("#f6fafc"));
  canvas.path("M -34 -6 L -16 -22 L 36 -22 L 20 -6 Z").fill(lighter(yellow, 0.5));
  canvas.rectangle({-34, -6, 54, 28}).fill(lit_across({-34, -6, 54, 40}, yellow));
  canvas.path("M 20 -6 L 36 -22 L 36 6 L 20 22 Z").fill(darker(yellow, 0.22));
  // A curl cut off at the left.
  canvas.path("M -44 22 C -50 8 -40 0 -32 6 C -26 12 -32 20 -38 18 C -42 16 -40 11 -36 12")
      .fill_and_stroke(lighter(yellow, 0.25), darker(yellow, 0.3), 1.8);
}

void draw_motif_cream(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-46, 32, 94, 16});
  // A whipped swirl in three turns with a tip.
  const auto turn = [&](double y, double w, double h) {
    canvas.ellipse(0, y, w, h)
        .fill(Paint::radial(0,
                            y,
                            w,
                            -w * 0.4,
                            y - h * 0.5,
                            {{0, paper_white},
                             {0.55, rgb("#fffaf0")},
                             {0.85, rgb("#e8dcc8")},
                             {1, rgb("#bfae92")}}));
    for (int groove = -2; groove <= 2; ++groove) {
      placed(canvas, groove * w * 0.34, y, 0.35, h / 14, [&] {
        canvas.path("M -2 -10 C 3 -4 3 4 -1 11").stroke(faded(rgb("#b5a182"), 0.5), 2);
      });
    }
  };
  turn(28, 42, 16);
  turn(10, 32, 14);
  turn(-7, 22, 12);
  canvas.path("M -13 -12 C -10 -26 2 -30 6 -46 C 14 -32 16 -20 12 -11 C 6 -6 -8 -6 -13 -12 Z");
  canvas.fill(Paint::linear(
      -10, -30, 14, -10, {{0, paper_white}, {0.6, rgb("#f7efdf")}, {1, rgb("#c9b898")}}));
}

void draw_motif_yogurt(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-48, 32, 98, 14});
  const Color bowl = rgb("#4f8fc0");
  canvas.path("M -46 -4 C -44 26 -24 40 -14 42 L 14 42 C 24 40 44 26 46 -4 Z");
  canvas.fill(Paint::linear(
      -40, 0, 40, 30, {{0, lighter(bowl, 0.45)}, {0.4, bowl}, {1, darker(bowl, 0.4)}}));
  canvas.ellipse(0, -4, 46, 17).fill(lighter(bowl, 0.75));
  canvas.ellipse(0, -4, 41, 14)
      .fill(Paint::radial(
          0, -4, 41, -10, -8, {{0, paper_white}, {0.7, rgb("#fdfbf6")}, {1, rgb("#d8d5cc")}}));
  canvas.path("M -26 -4 C -18 -14 16 -14 20 -5 C 20 2 -10 3 -10 -3 C -9 -7 6 -7 6 -4")
      .stroke(faded(rgb("#b9b6ac"), 0.8), 2.4);
  // The spoon stands in it.
  canvas.path("M 18 -8 L 40 -48").stroke(rgb("#8b949c"), 5);
  canvas.path("M 17 -9 L 39 -48").stroke(rgb("#e3e9ee"), 2);
  canvas.ellipse(17, -6, 7, 4).fill(rgb("#fdfbf6"));
}

void draw_motif_ice_cream(Canvas& canvas, const MotifInk&) {
  ground_shadow(canvas, {-26, 42, 54, 8});
  const auto scoop = [&](double x, double y, double r, const Color& color) {
    ball(canvas, {x, y, r}, color);
    for (int i = 0; i < 6; ++i) {
      const double cx = x - r * 0.85 + i * r * 0.34;
      canvas.circle(cx, y + r * (i % 2 == 0 ? 0.72 : 0.60), r * 0.24)
          .fill(lit({cx, y + r * 0.6, r * 0.26}, color));
    }
  };
  {
    const Canvas::Saved saved = canvas.saved();
    canvas.path("M -24 2 L 24 2 L 2 48 L -2 48 Z").clip();
    canvas.rectangle({-26, 0, 52, 50}).fill(lit_across({-24, 0, 48, 50}, rgb("#dc9f4e")));
    for (int i = -6; i < 8; ++i) {
      placed(canvas, i * 8.0, 0, 0, 1, [&] {
        canvas.path("M -14 -4 L 14 52 M 14 -4 L -14 52").stroke(faded(rgb("#8f5718"), 0.6), 1.6);
      });
    }
  }
  scoop(-13, -8, 17, rgb("#f7c9d5"));
  scoop(14, -8, 17, rgb("#7a4526"));
  scoop(0, -28, 18, rgb("#fbeec2"));
  ball(canvas, {2, -46, 4}, rgb("#c3122a"));
}

}  // namespace marketgen::assets
