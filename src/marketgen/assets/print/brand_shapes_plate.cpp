// Brand marks whose words stand on a plate.
#include <cmath>
#include <numbers>
#include <string_view>

#include "assets/print/brand_pen.h"

namespace marketgen::assets {
namespace {

// Fills an outline drawn in the square 0..100 stretched to the plate.
void stretched_plate(const MarkPen& pen,
                     const Area& plate,
                     std::string_view outline,
                     double line_width) {
  const Canvas::Saved saved = pen.canvas.saved();
  pen.canvas.translate(plate.x, plate.y);
  pen.canvas.scale(plate.w / 100, plate.h / 100);
  pen.canvas.path(outline);
  pen.fill_plate(line_width);
}

}  // namespace

void draw_mark_oval(const MarkPen& pen) {
  const Area p = pen.plate({0.80, 0.52, 1.7});
  pen.canvas.ellipse(p.center_x(), p.center_y(), p.w * 0.49, p.h * 0.48);
  pen.fill_plate(p.h * 0.05);
  pen.canvas.ellipse(p.center_x(), p.center_y(), p.w * 0.455, p.h * 0.405)
      .stroke(faded(pen.plate_ink(), 0.7), p.h * 0.018);
  pen.plate_words(p.part(0.10, 0.24, 0.90, 0.76));
}

void draw_mark_block(const MarkPen& pen) {
  const Area p = pen.plate({0.86, 0.66, 1.6});
  pen.canvas.rounded(p.inset(p.h * 0.03), p.h * 0.14);
  pen.fill_plate(p.h * 0.035);
  pen.plate_words(p.part(0.07, 0.17, 0.93, 0.83));
}

void draw_mark_shield(const MarkPen& pen) {
  const Area p = pen.plate({0.82, 0.46, 1.15});
  stretched_plate(
      pen,
      p,
      "M 3 10 C 22 10 38 8 50 2 C 62 8 78 10 97 10 L 97 56 C 97 80 72 90 50 98 C 28 90 3 80 3 56 Z",
      3.4);
  pen.plate_words(p.part(0.09, 0.23, 0.91, 0.69));
}

void draw_mark_ribbon(const MarkPen& pen) {
  const Area p = pen.plate({0.76, 0.60, 1.8});
  {
    const Canvas::Saved saved = pen.canvas.saved();
    pen.canvas.translate(p.x, p.y);
    pen.canvas.scale(p.w / 100, p.h / 100);
    pen.canvas
        .path("M 0 24 L 14 24 L 14 96 L 0 96 L 6 60 Z M 100 24 L 86 24 L 86 96 L 100 96 L 94 60 Z")
        .fill(darker(pen.look.plate, 0.35));
  }
  stretched_plate(pen, p, "M 8 8 L 92 8 L 92 82 L 8 82 Z", 2.2);
  pen.plate_words(p.part(0.12, 0.15, 0.88, 0.75));
}

void draw_mark_hexagon(const MarkPen& pen) {
  const Area p = pen.plate({0.72, 0.56, 1.6});
  // The points lean as in a hexagon of the plate's height, whatever its width.
  const double point = p.h * 0.28;
  pen.canvas.polygon({{p.x + p.h * 0.03, p.center_y()},
                      {p.x + point, p.y + p.h * 0.04},
                      {p.right() - point, p.y + p.h * 0.04},
                      {p.right() - p.h * 0.03, p.center_y()},
                      {p.right() - point, p.bottom() - p.h * 0.04},
                      {p.x + point, p.bottom() - p.h * 0.04}});
  pen.fill_plate(p.h * 0.05);
  pen.plate_words(p.part(0.14, 0.22, 0.86, 0.78));
}

void draw_mark_arch(const MarkPen& pen) {
  const Area p = pen.plate({0.84, 0.50, 1.3});
  stretched_plate(pen, p, "M 3 97 L 3 44 C 16 4 84 4 97 44 L 97 97 Z", 3);
  const double y = p.y + p.h * 0.27;
  for (const double x : {-0.5, 0.0, 0.5})
    pen.canvas.circle(p.center_x() + x * p.h * 0.2, y - (x == 0.0 ? p.h * 0.03 : 0.0), p.h * 0.028)
        .fill(pen.plate_ink());
  pen.plate_words(p.part(0.08, 0.40, 0.92, 0.90));
}

void draw_mark_ticket(const MarkPen& pen) {
  const Area p = pen.plate({0.78, 0.60, 1.7});
  const double r = p.h * 0.13;
  const Area body{p.x + p.h * 0.03, p.y + p.h * 0.04, p.w - p.h * 0.06, p.h * 0.92};
  pen.canvas.rounded(body, p.h * 0.06);
  pen.fill_plate(p.h * 0.03);
  for (const double x : {body.x, body.right()})
    pen.canvas.circle(x, p.center_y(), r).fill(pen.ground);
  const Area dashes = body.inset(p.h * 0.09);
  for (double x = dashes.x; x + p.h * 0.06 < dashes.right(); x += p.h * 0.1) {
    for (const double y : {dashes.y, dashes.bottom()})
      pen.canvas.rectangle({x, y - p.h * 0.012, p.h * 0.06, p.h * 0.024});
  }
  pen.canvas.fill(faded(pen.plate_ink(), 0.75));
  pen.plate_words(p.part(0.11, 0.22, 0.89, 0.78));
}

void draw_mark_banner(const MarkPen& pen) {
  const Area p = pen.plate({0.78, 0.62, 1.7});
  const double slant = p.h * 0.16;
  const double shade = p.h * 0.06;
  const auto slab = [&](double shift, double top) {
    pen.canvas.polygon({{p.x + slant + shift, p.y + top},
                        {p.right() - shade + shift, p.y + top},
                        {p.right() - shade - slant + shift, p.bottom() - shade * 1.5 + top},
                        {p.x + shift, p.bottom() - shade * 1.5 + top}});
  };
  slab(shade, shade * 1.4);
  pen.canvas.fill(pen.free_trim());
  slab(0, 0);
  pen.canvas.fill(pen.look.plate);
  pen.words(
      p.part(0.11, 0.14, 0.87, 0.78), readable_on(pen.look.plate, paper_white), Align::center);
}

void draw_mark_corner(const MarkPen& pen) {
  const Area p = pen.plate({0.84, 0.64, 1.6});
  const double cut = p.h * 0.3;
  pen.canvas.polygon({{p.x + p.h * 0.03, p.y + p.h * 0.03},
                      {p.right() - cut, p.y + p.h * 0.03},
                      {p.right() - p.h * 0.03, p.y + cut},
                      {p.right() - p.h * 0.03, p.bottom() - p.h * 0.03},
                      {p.x + cut, p.bottom() - p.h * 0.03},
                      {p.x + p.h * 0.03, p.bottom() - cut}});
  pen.fill_plate(p.h * 0.04);
  pen.plate_words(p.part(0.08, 0.18, 0.92, 0.82));
}

void draw_mark_frame(const MarkPen& pen) {
  const Area p = pen.plate({0.84, 0.62, 1.6});
  const double line = p.h * 0.045;
  pen.canvas.rectangle(p.inset(line)).stroke(pen.free_ink(), line);
  pen.canvas.rectangle(p.inset(line * 2.4)).stroke(pen.free_trim(), line * 0.45);
  pen.words(p.part(0.09, 0.20, 0.91, 0.80), pen.free_ink(), Align::center);
}

void draw_mark_cloud(const MarkPen& pen) {
  const Area p = pen.plate({0.74, 0.54, 1.6});
  // Scallops of one size along an ellipse that the words fit into.
  const double r = p.h * 0.13;
  const double rx = p.w / 2 - r, ry = p.h / 2 - r;
  const double round = std::numbers::pi * (rx + ry);
  const int bumps = 2 * static_cast<int>(std::lround(round / (r * 3.2)));
  for (const double grow : {1.18, 1.0}) {
    for (int i = 0; i < bumps; ++i) {
      const double angle = i * 2 * std::numbers::pi / bumps;
      pen.canvas.circle(
          p.center_x() + rx * std::cos(angle), p.center_y() + ry * std::sin(angle), r * grow);
      pen.canvas.fill(grow > 1 ? pen.free_trim() : pen.look.plate);
    }
  }
  pen.canvas.ellipse(p.center_x(), p.center_y(), rx, ry).fill(pen.look.plate);
  pen.words(
      p.part(0.13, 0.23, 0.87, 0.77), readable_on(pen.look.plate, pen.look.trim), Align::center);
}

}  // namespace marketgen::assets
