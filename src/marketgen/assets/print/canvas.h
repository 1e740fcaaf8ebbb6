// A drawing surface: Cairo in RAII, with paths written like SVG's and colours by value.
//
// One Canvas belongs to one thread; canvases of different threads share nothing.
#pragma once
#include <cairo.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "assets/print/paint_color.h"
#include "geometry/image.h"

namespace marketgen::assets {

// An axis-aligned part of the canvas in its current units, y down.
struct Area {
  double x = 0, y = 0, w = 0, h = 0;

  double right() const { return x + w; }
  double bottom() const { return y + h; }
  double center_x() const { return x + w / 2; }
  double center_y() const { return y + h / 2; }
  Area inset(double by) const { return {x + by, y + by, w - 2 * by, h - 2 * by}; }
  // The part between shares 0..1 of the width and of the height.
  Area part(double x0, double y0, double x1, double y1) const {
    return {x + w * x0, y + h * y0, w * (x1 - x0), h * (y1 - y0)};
  }
};

struct ColorStop {
  double at = 0;  // 0..1 along the gradient
  Color color;
};

// What a shape is filled with.
class Paint {
 public:
  Paint(const Color& color);  // NOLINT(google-explicit-constructor)
  static Paint linear(
      double x0, double y0, double x1, double y1, const std::vector<ColorStop>& stops);
  // From the point (focus_x, focus_y) out to the circle.
  static Paint radial(double x,
                      double y,
                      double radius,
                      double focus_x,
                      double focus_y,
                      const std::vector<ColorStop>& stops);

  cairo_pattern_t* pattern() const { return pattern_.get(); }

 private:
  explicit Paint(cairo_pattern_t* pattern, const std::vector<ColorStop>& stops);
  std::shared_ptr<cairo_pattern_t> pattern_;
};

// Bars that are left out of the picture, for a reader that draws them as fine as the eye comes
// near.
struct BarField {
  Area px;              // all modules, the guard bars at full length
  std::string modules;  // '1' for a bar
  bool ladder = false;  // turned a quarter: modules follow one another downwards, feet to the left
  double foot = 0;      // share of the length that only guard bars reach into
};

class Canvas {
 public:
  Canvas(int width_px, int height_px, const Color& ground);

  // Path building; each returns the canvas, so that a shape reads as one line.
  Canvas& path(std::string_view commands);  // absolute "M x y", "L x y", "C x1 y1 x2 y2 x y", "Z"
  Canvas& rectangle(const Area& area);
  Canvas& rounded(const Area& area, double radius);
  Canvas& ellipse(double x, double y, double radius_x, double radius_y);
  Canvas& circle(double x, double y, double radius) { return ellipse(x, y, radius, radius); }
  Canvas& polygon(const std::vector<std::array<double, 2>>& points);

  // Using the path up.
  void fill(const Paint& paint);
  void stroke(const Paint& paint, double width);
  void fill_and_stroke(const Paint& paint, const Paint& line, double width);
  void clip();

  // Restores transform and clip when it leaves scope.
  class Saved {
   public:
    explicit Saved(cairo_t* context) : context_(context) { cairo_save(context_); }
    ~Saved() { cairo_restore(context_); }
    Saved(const Saved&) = delete;
    Saved& operator=(const Saved&) = delete;

   private:
    cairo_t* context_;
  };
  [[nodiscard]] Saved saved() { return Saved(context_.get()); }
  void translate(double x, double y) { cairo_translate(context_.get(), x, y); }
  void scale(double x, double y) { cairo_scale(context_.get(), x, y); }
  void rotate(double radians) { cairo_rotate(context_.get(), radians); }

  double pixels_per_unit_x() const;  // length of the unit vector along x on the surface
  double pixels_per_unit_y() const;
  int width_px() const { return cairo_image_surface_get_width(surface_.get()); }
  int height_px() const { return cairo_image_surface_get_height(surface_.get()); }
  cairo_t* context() const { return context_.get(); }

  // False once Cairo has refused something, a degenerate transform for one; it then ignores all
  // further drawing.
  bool healthy() const { return cairo_status(context_.get()) == CAIRO_STATUS_SUCCESS; }
  Image image() const;  // RGB copy of what has been drawn
  void leave_bars(BarField field) { bars_ = std::move(field); }
  const std::optional<BarField>& bars() const { return bars_; }
  void put(const Image& image,
           int x_px,
           int y_px);  // copies RGB pixels, transform and clip ignored

 private:
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context_;
  std::optional<BarField> bars_;
};

}  // namespace marketgen::assets
