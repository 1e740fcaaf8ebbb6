#include "assets/print/price_type.h"

#include <fmt/format.h>

#include <cmath>

#include "assets/print/lettering.h"
#include "catalog/country.h"

namespace marketgen::assets {

namespace {

// Where the parts stand in the area, as shares of its width.
struct PriceParts {
  double sign_x, sign_w, whole_x, whole_right, coins_x;
};
constexpr PriceParts sign_behind{0.68, 0.3, 0.12, 0.66, 0.68};
constexpr PriceParts sign_before{0.02, 0.14, 0.17, 0.70, 0.72};
constexpr PriceParts without_coins{0.02, 0.2, 0.24, 0.98, 1};

PriceParts parts_of(const catalog::Country& country) {
  if (!country.sign_first) return sign_behind;
  return country.minor_digits > 0 ? sign_before : without_coins;
}

Headline small_figures(std::string text,
                       const Typeface& face,
                       const Color& color,
                       const Area& area,
                       VerticalAlign vertical = VerticalAlign::top) {
  return {std::move(text), face, color, area, Align::left, vertical, 1, 1e9, 1.0};
}

// As high as a capital and at its top where it goes first, else below the raised coins.
Headline sign_of(const catalog::Country& country,
                 const Typeface& face,
                 const Color& color,
                 const Area& area,
                 double top,
                 double size) {
  const PriceParts parts = parts_of(country);
  const double x = area.x + area.w * parts.sign_x, w = area.w * parts.sign_w;
  const std::string sign(country.sign);
  if (country.sign_first)
    return small_figures(sign, face, color, {x, top - size * 0.06, w, size * 0.54});
  return small_figures(
      sign, face, color, {x, top + size * 0.42, w, size * 0.34}, VerticalAlign::middle);
}

}  // namespace

void draw_price(Canvas& canvas,
                const catalog::Product& product,
                const Area& area,
                const Color& color) {
  const catalog::Country& country = catalog::country_of(product);
  const PriceParts parts = parts_of(country);
  const auto coins = std::lround(product.price * 100);
  const Typeface face{"Open Sans", 800, false, false, -0.02};
  const Headline whole{fmt::format("{}", coins / 100),
                       face,
                       color,
                       area.part(parts.whole_x, 0, parts.whole_right, 1),
                       Align::right,
                       VerticalAlign::middle,
                       1,
                       area.h * 0.98,
                       1.0};
  const HeadlineFit fit = fit_headline(whole);
  draw_headline(canvas, whole);
  const double top = area.center_y() - fit.size * 0.36;
  const Area raised{
      area.x + area.w * parts.coins_x, top - fit.size * 0.06, area.w * 0.30, fit.size * 0.54};
  if (country.minor_digits > 0)
    draw_headline(canvas, small_figures(fmt::format("{:02}", coins % 100), face, color, raised));
  draw_headline(canvas, sign_of(country, face, color, area, top, fit.size));
}

std::string title_text(const catalog::Product& product) {
  return product.brand.empty() ? product.name : product.brand + " " + product.name;
}

std::string detail_text(const catalog::Product& product) {
  const std::string net = catalog::net_text(product);
  return product.variant.empty() ? net : product.variant + ", " + net;
}

}  // namespace marketgen::assets
