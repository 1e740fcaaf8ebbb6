// Brand marks whose words stand on the pack itself, with an ornament.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "assets/print/brand_pen.h"
#include "assets/print/motif_brush.h"

namespace marketgen::assets {
namespace {

// The first character of UTF-8 text, with its continuation bytes.
std::string first_letter(const std::string& text) {
  std::size_t end = 1;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
    ++end;
  return text.substr(0, end);
}

}  // namespace

void draw_mark_wordmark(const MarkPen& pen) {
  const double lift = pen.area.h * 0.018;
  Area shadow = pen.area;
  shadow.x += lift;
  shadow.y += lift;
  pen.words(shadow, faded(darker(pen.ground, 0.6), 0.35), pen.align);
  pen.words(pen.area, pen.free_ink(), pen.align);
}

void draw_mark_swoosh(const MarkPen& pen) {
  const Area word = pen.line(pen.area.part(0, 0, 1, 0.80));
  placed(pen.canvas, word.x, word.bottom(), 0, word.w / 100, [&] {
    pen.canvas.path("M 2 3 C 30 -3 70 -4 99 1 C 70 0 30 3 6 8 C 3 8 1 5 2 3 Z")
        .fill(pen.free_trim());
  });
}

void draw_mark_leaf(const MarkPen& pen) {
  const Area& a = pen.area;
  const Area word = pen.line(a.part(0, 0.22, 0.9, 1));
  const double length = std::min(a.h * 0.42, word.h * 0.75);
  const Color green = contrast(pen.ground, rgb("#3f9b3a")) > 1.5 ? rgb("#3f9b3a") : rgb("#c5e08a");
  const double x = word.right() - length * 0.2, y = word.y + word.h * 0.16;
  leaf(pen.canvas, x, y, -0.75, length, green);
  leaf(pen.canvas, x, y, -1.75, length * 0.7, lighter(green, 0.2));
}

void draw_mark_roundel(const MarkPen& pen) {
  const Area& a = pen.area;
  const double r = std::min(a.h * 0.46, a.w * 0.15);
  const double x = pen.align == Align::center ? a.x + r * 1.1 : a.x + r;
  pen.canvas.circle(x, a.center_y(), r);
  pen.fill_plate(r * 0.12);
  draw_headline(pen.canvas,
                {first_letter(pen.brand),
                 pen.look.mark_face,
                 pen.plate_ink(),
                 {x - r * 0.7, a.center_y() - r * 0.75, r * 1.4, r * 1.5}});
  pen.words({x + r * 1.3, a.y + a.h * 0.12, a.right() - x - r * 1.3, a.h * 0.76},
            pen.free_ink(),
            Align::left);
}

void draw_mark_rules(const MarkPen& pen) {
  const Area word = pen.line(pen.area.part(0, 0.16, 1, 0.84));
  const double line = word.h * 0.05;
  pen.canvas.rectangle({word.x, word.y - line, word.w, line}).fill(pen.free_trim());
  pen.canvas.rectangle({word.x, word.bottom(), word.w, line}).fill(pen.free_trim());
}

void draw_mark_sun(const MarkPen& pen) {
  const Area& a = pen.area;
  const Area word = pen.line(a.part(0, 0.32, 1, 1));
  const double r = std::min(a.h * 0.30, word.w * 0.22);
  const double y = word.y + word.h * 0.04;
  for (int ray = 0; ray < 9; ++ray) {
    placed(pen.canvas, word.center_x(), y, std::numbers::pi * (1 + (ray + 0.5) / 9), r / 10, [&] {
      pen.canvas.path("M 6.4 -0.9 L 10.5 0 L 6.4 0.9 Z").fill(pen.free_trim());
    });
  }
  const Canvas::Saved saved = pen.canvas.saved();
  pen.canvas.rectangle({word.center_x() - r, y - r, 2 * r, r}).clip();
  pen.canvas.circle(word.center_x(), y, r * 0.52).fill(pen.free_trim());
}

void draw_mark_diamond(const MarkPen& pen) {
  const Area& a = pen.area;
  const Area word = pen.line(a.part(0, 0.30, 1, 1));
  const double r = std::min(a.h * 0.11, word.w * 0.05);
  const double y = word.y - r * 0.7;
  for (const double shift : {-2.6, 0.0, 2.6}) {
    const double x = word.center_x() + shift * r;
    const double s = shift == 0.0 ? r * 1.25 : r * 0.8;
    pen.canvas.polygon({{x, y - s}, {x + s * 0.8, y}, {x, y + s}, {x - s * 0.8, y}});
    pen.canvas.fill(pen.free_trim());
  }
}

void draw_mark_initial(const MarkPen& pen) {
  const Area word = pen.line(pen.area.part(0.04, 0.08, 0.96, 0.92));
  const double r = word.h * 0.10;
  pen.canvas.circle(word.right() + r * 1.6, word.y + word.h * 0.70, r).fill(pen.free_trim());
}

void draw_mark_waves(const MarkPen& pen) {
  const Area word = pen.line(pen.area.part(0, 0, 1, 0.72));
  for (const double row : {0.0, 1.0}) {
    placed(pen.canvas, word.x, word.bottom() + row * word.w * 0.045, 0, word.w / 100, [&] {
      pen.canvas.path(
          "M 0 3 C 8 -2 17 -2 25 3 C 33 8 42 8 50 3 C 58 -2 67 -2 75 3 C 83 8 92 8 100 3");
      pen.canvas.stroke(row == 0.0 ? pen.free_trim() : faded(pen.free_trim(), 0.6), 2.2);
    });
  }
}

void draw_mark_crown(const MarkPen& pen) {
  const Area& a = pen.area;
  const Area word = pen.line(a.part(0, 0.34, 1, 1));
  const double w = std::min(a.h * 0.5, word.w * 0.3);
  placed(pen.canvas, word.center_x(), word.y + word.h * 0.03, 0, w / 100, [&] {
    pen.canvas.path("M -50 0 L -56 -44 L -28 -20 L 0 -56 L 28 -20 L 56 -44 L 50 0 Z")
        .fill(pen.free_trim());
    for (const auto& [x, y] : {std::array{-56.0, -50.0}, {0.0, -62.0}, {56.0, -50.0}})
      pen.canvas.circle(x, y, 7).fill(pen.free_trim());
  });
}

void draw_mark_peaks(const MarkPen& pen) {
  const Area& a = pen.area;
  const Area word = pen.line(a.part(0, 0.34, 1, 1));
  const double w = std::min(a.h * 0.75, word.w * 0.42);
  placed(pen.canvas, word.center_x(), word.y + word.h * 0.03, 0, w / 100, [&] {
    pen.canvas.path("M -50 0 L -18 -34 L -4 -20 L 16 -44 L 52 0 Z").fill(pen.free_trim());
    pen.canvas.path("M 16 -44 L 25 -33 L 18 -28 L 12 -33 L 7 -32 Z").fill(pen.free_ink());
    pen.canvas.path("M -18 -34 L -11 -26 L -17 -22 L -25 -26 Z").fill(pen.free_ink());
  });
}

void draw_mark_star(const MarkPen& pen) {
  const Area& a = pen.area;
  const Area word = pen.words(a.part(0.16, 0.08, 1, 0.92), pen.free_ink(), pen.align);
  const double r = std::min(word.h * 0.34, a.w * 0.065);
  const double x = std::max(a.x + r, word.x - r * 1.4);
  std::vector<std::array<double, 2>> star;
  for (int i = 0; i < 10; ++i) {
    const double angle = i * std::numbers::pi / 5;
    const double reach = i % 2 == 0 ? r : r * 0.42;
    star.push_back({x + reach * std::sin(angle), word.center_y() - reach * std::cos(angle)});
  }
  pen.canvas.polygon(star).fill(pen.free_trim());
}

void draw_mark_bars(const MarkPen& pen) {
  const Area& a = pen.area;
  const Area word = pen.words(a.part(0.16, 0.06, 1, 0.94), pen.free_ink(), pen.align);
  const double w = std::min(word.h * 0.14, a.w * 0.035);
  const double high = word.h * 0.62;
  for (int i = 0; i < 3; ++i) {
    const double x = std::max(a.x, word.x - w * 6) + i * w * 1.6;
    const double h = high * (0.55 + 0.225 * i);
    pen.canvas.rectangle({x, word.center_y() + high / 2 - h, w, h})
        .fill(i == 2 ? pen.free_ink() : pen.free_trim());
  }
}

}  // namespace marketgen::assets
