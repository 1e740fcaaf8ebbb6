#include "assets/print/brand_pen.h"

#include <algorithm>

namespace marketgen::assets {
namespace {

int lines_of(const std::string& brand) {
  constexpr std::size_t long_name = 10;
  return brand.find(' ') != std::string::npos && brand.size() > long_name ? 2 : 1;
}

}  // namespace

Color MarkPen::free_ink() const {
  return readable_on(ground, contrast(ground, look.plate) >= 3.5 ? look.plate : paper_white);
}

Color MarkPen::free_trim() const {
  return contrast(ground, look.trim) >= 1.5 ? look.trim : readable_on(ground, look.plate);
}

Area MarkPen::words(const Area& at, const Color& color, Align across) const {
  return draw_headline(
      canvas,
      {brand, look.mark_face, color, at, across, VerticalAlign::middle, lines_of(brand), 1e9, 1.0});
}

Area MarkPen::line(const Area& at) const {
  return draw_headline(
      canvas, {brand, look.mark_face, free_ink(), at, align, VerticalAlign::middle, 1, 1e9, 1.0});
}

Area MarkPen::plate(const PlateShape& shape) const {
  const HeadlineFit fit = fit_headline({brand,
                                        look.mark_face,
                                        {},
                                        {0, 0, area.w * shape.fill_x, area.h * shape.fill_y},
                                        Align::center,
                                        VerticalAlign::middle,
                                        lines_of(brand),
                                        1e9,
                                        1.0});
  const double h = std::min(area.h, fit.size * fit.lines / shape.fill_y);
  const double w = std::min(area.w, std::max(h * shape.min_aspect, fit.width / shape.fill_x));
  const double x = align == Align::left    ? area.x
                   : align == Align::right ? area.right() - w
                                           : area.center_x() - w / 2;
  return {x, area.center_y() - h / 2, w, h};
}

void MarkPen::fill_plate(double line_width) const {
  const Color outline = contrast(look.plate, look.trim) >= 1.6 ? look.trim : paper_white;
  canvas.fill_and_stroke(look.plate, outline, line_width);
}

}  // namespace marketgen::assets
