#include "assets/print/price_type.h"

#include <fmt/format.h>

#include <cmath>

#include "assets/print/lettering.h"
#include "catalog/unit_price.h"

namespace marketgen::assets {

std::string unit_price_text(const catalog::Product& product) {
  return fmt::format("\u20ac {:.2f} / {}", catalog::unit_price(product), product.unit_of_measure);
}

std::string price_text(double price) {
  const auto cents = std::lround(price * 100);
  return fmt::format("{}.{:02} \u20ac", cents / 100, cents % 100);
}

void draw_price(Canvas& canvas, double price, const Area& area, const Color& color) {
  const auto cents = std::lround(price * 100);
  const Typeface face{"Open Sans", 800, false, false, -0.02};
  const Headline whole{fmt::format("{}", cents / 100),
                       face,
                       color,
                       area.part(0.12, 0, 0.66, 1),
                       Align::right,
                       VerticalAlign::middle,
                       1,
                       area.h * 0.98,
                       1.0};
  const HeadlineFit fit = fit_headline(whole);
  draw_headline(canvas, whole);
  const double top = area.center_y() - fit.size * 0.36;
  draw_headline(canvas,
                {fmt::format("{:02}", cents % 100),
                 face,
                 color,
                 {area.x + area.w * 0.68, top - fit.size * 0.06, area.w * 0.30, fit.size * 0.54},
                 Align::left,
                 VerticalAlign::top,
                 1,
                 1e9,
                 1.0});
  draw_headline(
      canvas,
      {"\u20ac",
       face,
       color,
       {area.right() - area.w * 0.32, top + fit.size * 0.42, area.w * 0.3, fit.size * 0.34},
       Align::left,
       VerticalAlign::middle,
       1,
       1e9,
       1.0});
}

std::string title_text(const catalog::Product& product) {
  return product.brand.empty() ? product.name : product.brand + " " + product.name;
}

std::string detail_text(const catalog::Product& product) {
  return product.variant.empty() ? product.net : product.variant + ", " + product.net;
}

}  // namespace marketgen::assets
