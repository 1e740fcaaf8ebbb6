#include "assets/print/pack_ornament.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

namespace marketgen::assets {
namespace {

// One repeat of a pattern, drawn in the unit square over its neighbours' parts too.
void draw_pattern_cell(cairo_t* c, int pattern) {
  constexpr double full_turn = 2 * std::numbers::pi;
  if (pattern == 1) {
    // Dots in the middle and at the corners.
    for (const auto& [x, y] : {std::array{0.5, 0.5},
                               std::array{0.0, 0.0},
                               std::array{1.0, 0.0},
                               std::array{0.0, 1.0},
                               std::array{1.0, 1.0}}) {
      cairo_new_sub_path(c);
      cairo_arc(c, x, y, 0.12, 0, full_turn);
    }
    cairo_fill(c);
  } else if (pattern == 2) {
    for (const double shift : {-1.0, 0.0, 1.0}) {
      cairo_move_to(c, shift - 0.2, 1.2);
      cairo_line_to(c, shift + 1.2, -0.2);
    }
    cairo_set_line_width(c, 0.16);
    cairo_stroke(c);
  } else {
    for (const double radius : {0.40, 0.20}) {
      cairo_new_sub_path(c);
      cairo_arc(c, 0.5, 0.5, radius, 0, full_turn);
    }
    cairo_set_line_width(c, 0.06);
    cairo_stroke(c);
  }
}

using TileSurface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

// The repeat on whole pixels, so that it can be laid side by side without blur.
TileSurface pattern_tile(int pattern, int side_px, const Color& color) {
  TileSurface tile(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, side_px, side_px),
                   cairo_surface_destroy);
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> c(cairo_create(tile.get()),
                                                             cairo_destroy);
  cairo_scale(c.get(), side_px, side_px);
  cairo_set_source_rgba(c.get(), color.r, color.g, color.b, color.a);
  draw_pattern_cell(c.get(), pattern);
  return tile;
}

}  // namespace

void draw_pattern(Canvas& canvas, int pattern, const Area& area, double pitch, const Color& color) {
  if (pattern == 0) return;
  const int side_px =
      std::max(4, static_cast<int>(std::lround(pitch * canvas.pixels_per_unit_y())));
  const TileSurface tile = pattern_tile(pattern, side_px, color);
  double x = area.x;
  double y = area.y;
  cairo_user_to_device(canvas.context(), &x, &y);
  cairo_t* c = canvas.context();
  canvas.rectangle(area);
  const Canvas::Saved saved = canvas.saved();
  cairo_identity_matrix(c);
  cairo_set_source_surface(c, tile.get(), std::floor(x), std::floor(y));
  cairo_pattern_set_extend(cairo_get_source(c), CAIRO_EXTEND_REPEAT);
  cairo_pattern_set_filter(cairo_get_source(c), CAIRO_FILTER_NEAREST);
  cairo_fill(c);
}

void draw_glow(
    Canvas& canvas, double x, double y, double radius, const Color& color, double strength) {
  canvas.circle(x, y, radius);
  canvas.fill(Paint::radial(
      x,
      y,
      radius,
      x,
      y,
      {{0, faded(color, strength)}, {0.55, faded(color, strength * 0.62)}, {1, faded(color, 0)}}));
}

void fill_below_wave(
    Canvas& canvas, const Area& area, double y, double height, int waves, const Paint& paint) {
  cairo_t* c = canvas.context();
  const double length = area.w / waves;
  cairo_move_to(c, area.x, y);
  for (int i = 0; i < waves; ++i) {
    const double x = area.x + i * length;
    cairo_curve_to(
        c, x + length * 0.25, y - height, x + length * 0.35, y - height, x + length / 2, y);
    cairo_curve_to(c, x + length * 0.65, y + height, x + length * 0.75, y + height, x + length, y);
  }
  cairo_line_to(c, area.right(), area.bottom());
  cairo_line_to(c, area.x, area.bottom());
  cairo_close_path(c);
  canvas.fill(paint);
}

}  // namespace marketgen::assets
