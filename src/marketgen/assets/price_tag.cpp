// Price tags of the shelf edge.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "assets/barcode.h"
#include "assets/label.h"
#include "assets/lettering.h"

namespace marketgen {
namespace {

// Tags of electronic and paper strips alike are about 39 mm high and 2.5 times as wide.
constexpr double tag_aspect = 2.5;
constexpr double tag_height_mm = 39;
constexpr int least_tag_px = 24;
constexpr int most_tag_px = 2048;

struct TagColors {
  Color ground, price_ground, price, type;
};

constexpr TagColors plain_tag{rgb("#fdfdfb"), rgb("#fdfdfb"), rgb("#141416"), rgb("#26262a")};
constexpr TagColors promotion_tag{rgb("#ffd91f"), rgb("#d5121e"), rgb("#ffffff"), rgb("#1d1a08")};

// Price per litre, kilogram or piece (directive 98/6/EC asks for it on every tag).
std::string unit_price_text(const Product& product) {
  const double unit_price = product.price / std::max(1e-6, product.unit_amount);
  return fmt::format("\u20ac {:.2f} / {}", unit_price, product.unit_of_measure);
}

// Large euros with raised cents.
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

void draw_tag_words(Canvas& canvas, const Product& product, const Area& tag, const Color& type) {
  const std::string title =
      product.brand.empty() ? product.name : product.brand + " " + product.name;
  draw_headline(canvas,
                {title,
                 {"Open Sans", 700},
                 type,
                 tag.part(0.03, 0.05, 0.56, 0.36),
                 Align::left,
                 VerticalAlign::top,
                 2,
                 tag.h * 0.17,
                 1.1});
  const std::string detail =
      product.variant.empty() ? product.net : product.variant + ", " + product.net;
  draw_headline(canvas,
                {detail,
                 {"Open Sans", 400},
                 type,
                 tag.part(0.03, 0.38, 0.56, 0.53),
                 Align::left,
                 VerticalAlign::middle,
                 1,
                 tag.h * 0.12});
  draw_headline(canvas,
                {unit_price_text(product),
                 {"Open Sans", 600},
                 type,
                 tag.part(0.60, 0.76, 0.97, 0.94),
                 Align::right,
                 VerticalAlign::middle,
                 1,
                 tag.h * 0.13});
}

// The article's EAN in whole pixels at the lower left; the PLU in figures for loose goods.
Result<void> draw_tag_code(Canvas& canvas, const Product& product, int height_px) {
  if (product.ean.empty()) {
    const std::string plu = product.plu.empty() ? "" : "PLU " + product.plu;
    draw_headline(canvas,
                  {plu,
                   {"DejaVu Sans Mono", 700},
                   print_ink,
                   {3, 22, 40, 13},
                   Align::left,
                   VerticalAlign::middle,
                   1,
                   7});
    return {};
  }
  MARKETGEN_TRY(const std::string bars, ean13_modules(product.ean, product.sku + "/ean"));
  BarcodePlace place;
  place.module_px = std::max(1, height_px / 96);
  place.x = height_px / 24;
  place.height_px = static_cast<int>(height_px * 0.40);
  place.y = height_px - place.height_px - height_px / 32;
  draw_barcode(canvas, bars, product.ean, place);
  return {};
}

}  // namespace

Result<Image> draw_price_tag(const Product& product, bool promotion, int height_px) {
  if (height_px < least_tag_px || height_px > most_tag_px) {
    return Error{"assets.bad_row",
                 product.sku,
                 fmt::format("a price tag cannot be {} pixels high; choose 24 to 2048", height_px)};
  }
  const TagColors& colors = promotion ? promotion_tag : plain_tag;
  const int width_px = static_cast<int>(std::lround(height_px * tag_aspect));
  Canvas canvas(width_px, height_px, colors.ground);
  canvas.scale(width_px / (tag_height_mm * tag_aspect), height_px / tag_height_mm);
  const Area tag{0, 0, tag_height_mm * tag_aspect, tag_height_mm};
  const Area price = tag.part(0.57, 0.06, 0.985, 0.74);
  canvas.rounded(price, 1.5).fill(colors.price_ground);
  draw_price(canvas,
             product.price,
             promotion ? price.part(0, 0.24, 1, 0.97) : price.part(0, 0.06, 1, 0.94),
             colors.price);
  draw_tag_words(canvas, product, tag, colors.type);
  MARKETGEN_CHECK(draw_tag_code(canvas, product, height_px));
  if (promotion) {
    draw_headline(canvas,
                  {"SPECIAL OFFER",
                   {"Open Sans", 800, true, false, 0.02},
                   colors.ground,
                   price.part(0.04, 0.04, 0.96, 0.24)});
  }
  canvas.rectangle(tag.inset(0.15)).stroke(faded(print_ink, 0.35), 0.3);
  if (!canvas.healthy()) {
    return Error{"internal.bug", product.sku, "Cairo refused a part of the tag: please report it"};
  }
  return canvas.image();
}

}  // namespace marketgen
