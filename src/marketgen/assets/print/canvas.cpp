#include "assets/print/canvas.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "base/result.h"

namespace marketgen::assets {
namespace {

// Reads the next number of a path; commas and blanks part numbers.
double next_number(std::string_view& commands) {
  const std::size_t start = commands.find_first_not_of(" ,\n");
  if (start == std::string_view::npos) fatal("Canvas::path: a number is missing at the end");
  commands.remove_prefix(start);
  double number = 0;
  const auto [end, error] =
      std::from_chars(commands.data(), commands.data() + commands.size(), number);
  if (error != std::errc()) fatal("Canvas::path: not a number");
  commands.remove_prefix(static_cast<std::size_t>(end - commands.data()));
  return number;
}

struct PathPoint {
  double x, y;
};

PathPoint next_point(std::string_view& commands) {
  const double x = next_number(commands);
  return {x, next_number(commands)};
}

// Runs one command, of which `letter` has been read.
void run_command(cairo_t* context, char letter, std::string_view& rest) {
  switch (letter) {
    case 'M': {
      const PathPoint p = next_point(rest);
      cairo_move_to(context, p.x, p.y);
      return;
    }
    case 'L': {
      const PathPoint p = next_point(rest);
      cairo_line_to(context, p.x, p.y);
      return;
    }
    case 'C': {
      const PathPoint a = next_point(rest);
      const PathPoint b = next_point(rest);
      const PathPoint p = next_point(rest);
      cairo_curve_to(context, a.x, a.y, b.x, b.y, p.x, p.y);
      return;
    }
    case 'Z':
      cairo_close_path(context);
      return;
    default:
      fatal("Canvas::path: only M, L, C and Z are known");
  }
}

double unit_length(cairo_t* context, double dx, double dy) {
  cairo_user_to_device_distance(context, &dx, &dy);
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace

Paint::Paint(const Color& color)
    : pattern_(cairo_pattern_create_rgba(color.r, color.g, color.b, color.a),
               cairo_pattern_destroy) {}

Paint::Paint(cairo_pattern_t* pattern, const std::vector<ColorStop>& stops)
    : pattern_(pattern, cairo_pattern_destroy) {
  for (const auto& [at, c] : stops) {
    cairo_pattern_add_color_stop_rgba(pattern, at, c.r, c.g, c.b, c.a);
  }
}

Paint Paint::linear(
    double x0, double y0, double x1, double y1, const std::vector<ColorStop>& stops) {
  return Paint(cairo_pattern_create_linear(x0, y0, x1, y1), stops);
}

Paint Paint::radial(double x,
                    double y,
                    double radius,
                    double focus_x,
                    double focus_y,
                    const std::vector<ColorStop>& stops) {
  return Paint(cairo_pattern_create_radial(focus_x, focus_y, 0, x, y, radius), stops);
}

Canvas::Canvas(int width_px, int height_px, const Color& ground)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px),
               cairo_surface_destroy),
      context_(cairo_create(surface_.get()), cairo_destroy) {
  if (cairo_surface_status(surface_.get()) != CAIRO_STATUS_SUCCESS) {
    fatal("Canvas: Cairo cannot make a surface of this size");
  }
  cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_antialias(context_.get(), CAIRO_ANTIALIAS_GRAY);
  cairo_set_source_rgb(context_.get(), ground.r, ground.g, ground.b);
  cairo_paint(context_.get());
}

Canvas& Canvas::path(std::string_view commands) {
  constexpr std::string_view blanks = " ,\n";
  for (std::size_t at; (at = commands.find_first_not_of(blanks)) != std::string_view::npos;) {
    const char letter = commands[at];
    commands.remove_prefix(at + 1);
    run_command(context_.get(), letter, commands);
  }
  return *this;
}

Canvas& Canvas::rectangle(const Area& area) {
  cairo_rectangle(context_.get(), area.x, area.y, area.w, area.h);
  return *this;
}

Canvas& Canvas::rounded(const Area& area, double radius) {
  constexpr double quarter = std::numbers::pi / 2;
  const double r = std::min({radius, area.w / 2, area.h / 2});
  cairo_new_sub_path(context_.get());
  cairo_arc(context_.get(), area.right() - r, area.y + r, r, -quarter, 0);
  cairo_arc(context_.get(), area.right() - r, area.bottom() - r, r, 0, quarter);
  cairo_arc(context_.get(), area.x + r, area.bottom() - r, r, quarter, 2 * quarter);
  cairo_arc(context_.get(), area.x + r, area.y + r, r, 2 * quarter, 3 * quarter);
  cairo_close_path(context_.get());
  return *this;
}

Canvas& Canvas::ellipse(double x, double y, double radius_x, double radius_y) {
  // Four cubics; 0.5523 makes them meet the circle in the middle of each quarter.
  constexpr double k = 0.5522847498;
  const double kx = radius_x * k;
  const double ky = radius_y * k;
  cairo_t* c = context_.get();
  cairo_move_to(c, x + radius_x, y);
  cairo_curve_to(c, x + radius_x, y + ky, x + kx, y + radius_y, x, y + radius_y);
  cairo_curve_to(c, x - kx, y + radius_y, x - radius_x, y + ky, x - radius_x, y);
  cairo_curve_to(c, x - radius_x, y - ky, x - kx, y - radius_y, x, y - radius_y);
  cairo_curve_to(c, x + kx, y - radius_y, x + radius_x, y - ky, x + radius_x, y);
  cairo_close_path(c);
  return *this;
}

Canvas& Canvas::polygon(const std::vector<std::array<double, 2>>& points) {
  cairo_new_sub_path(context_.get());
  for (const auto& [x, y] : points)
    cairo_line_to(context_.get(), x, y);
  cairo_close_path(context_.get());
  return *this;
}

void Canvas::fill(const Paint& paint) {
  cairo_set_source(context_.get(), paint.pattern());
  cairo_fill(context_.get());
}

void Canvas::stroke(const Paint& paint, double width) {
  cairo_set_source(context_.get(), paint.pattern());
  cairo_set_line_width(context_.get(), width);
  cairo_stroke(context_.get());
}

void Canvas::fill_and_stroke(const Paint& paint, const Paint& line, double width) {
  cairo_set_source(context_.get(), paint.pattern());
  cairo_fill_preserve(context_.get());
  stroke(line, width);
}

void Canvas::clip() {
  cairo_clip(context_.get());
}

double Canvas::pixels_per_unit_x() const {
  return unit_length(context_.get(), 1, 0);
}
double Canvas::pixels_per_unit_y() const {
  return unit_length(context_.get(), 0, 1);
}

Image Canvas::image() const {
  cairo_surface_flush(surface_.get());
  const unsigned char* data = cairo_image_surface_get_data(surface_.get());
  const int stride = cairo_image_surface_get_stride(surface_.get());
  Image image(width_px(), height_px());
  for (int y = 0; y < image.height; ++y) {
    const unsigned char* from = data + std::ptrdiff_t{y} * stride;  // B, G, R, unused
    std::uint8_t* to = image.at(0, y);
    for (int x = 0; x < image.width; ++x, from += 4, to += 3) {
      to[0] = from[2];
      to[1] = from[1];
      to[2] = from[0];
    }
  }
  return image;
}

void Canvas::put(const Image& image, int x_px, int y_px) {
  cairo_surface_flush(surface_.get());
  unsigned char* data = cairo_image_surface_get_data(surface_.get());
  const int stride = cairo_image_surface_get_stride(surface_.get());
  const int rows = std::min(image.height, height_px() - y_px);
  const int columns = std::min(image.width, width_px() - x_px);
  for (int y = 0; y < rows; ++y) {
    const std::uint8_t* from = image.at(0, y);
    unsigned char* to = data + std::ptrdiff_t{y + y_px} * stride + std::ptrdiff_t{x_px} * 4;
    for (int x = 0; x < columns; ++x, from += image.channels, to += 4) {
      to[2] = from[0];
      to[1] = from[1];
      to[0] = from[2];
    }
  }
  cairo_surface_mark_dirty(surface_.get());
}

}  // namespace marketgen::assets
