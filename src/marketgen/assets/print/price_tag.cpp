// Price tags of the shelf edge.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "assets/print/barcode.h"
#include "assets/print/label.h"
#include "assets/print/label_bars.h"
#include "assets/print/lettering.h"
#include "assets/print/price_type.h"
#include "catalog/country.h"

namespace marketgen::assets {
namespace {

// Tags of electronic and paper strips alike are about 39 mm high and 2.5 times as wide.
constexpr double tag_aspect = 2.5;
constexpr double tag_height_mm = 39;
constexpr int min_tag_px = 24;
constexpr int max_tag_px = 2048;
constexpr const char* offer_word = "SPECIAL OFFER";

// Loose goods have a number for the scales; empty without.
std::string plu_text(const catalog::Product& product) {
  return product.plu.empty() ? "" : "PLU " + product.plu;
}

struct TagColors {
  Color ground, price_ground, price, type;
};

constexpr TagColors plain_tag{rgb("#fdfdfb"), rgb("#fdfdfb"), rgb("#141416"), rgb("#26262a")};
constexpr TagColors promotion_tag{rgb("#ffd91f"), rgb("#d5121e"), rgb("#ffffff"), rgb("#1d1a08")};

void draw_tag_words(Canvas& canvas,
                    const catalog::Product& product,
                    const Area& tag,
                    const Color& type) {
  draw_headline(canvas,
                {title_text(product),
                 {"Open Sans", 700},
                 type,
                 tag.part(0.03, 0.05, 0.56, 0.36),
                 Align::left,
                 VerticalAlign::top,
                 2,
                 tag.h * 0.17,
                 1.1});
  draw_headline(canvas,
                {detail_text(product),
                 {"Open Sans", 400},
                 type,
                 tag.part(0.03, 0.38, 0.56, 0.53),
                 Align::left,
                 VerticalAlign::middle,
                 1,
                 tag.h * 0.12});
  draw_headline(canvas,
                {catalog::unit_price_text(product),
                 {"Open Sans", 600},
                 type,
                 tag.part(0.60, 0.76, 0.97, 0.94),
                 Align::right,
                 VerticalAlign::middle,
                 1,
                 tag.h * 0.13});
}

// The code's lower left corner and size on the tag.
constexpr double code_margin_mm = 1.4, code_height_mm = 15.5;

// In whole pixels.
BarcodePlace code_in_pixels(int height_px) {
  BarcodePlace place;
  place.module_px = std::max(1, height_px / 96);
  place.x = height_px / 24;
  place.height_px = static_cast<int>(height_px * 0.40);
  place.y = height_px - place.height_px - height_px / 32;
  return place;
}

// At 0.33 mm a module, counted in thousandths of a millimetre.
BarcodePlace code_in_micrometres() {
  BarcodePlace place;
  place.module_px = 330;
  place.height_px = static_cast<int>(code_height_mm * 1000);
  place.x = static_cast<int>(code_margin_mm * 1000);
  place.y = static_cast<int>((tag_height_mm - code_height_mm - code_margin_mm) * 1000);
  return place;
}

// The article's EAN at the lower left; the PLU in figures for loose goods.
Result<void> draw_tag_code(Canvas& canvas,
                           const catalog::Product& product,
                           int height_px,
                           bool bars_apart) {
  if (product.ean.empty()) {
    draw_headline(canvas,
                  {plu_text(product),
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
  if (bars_apart)
    leave_barcode(canvas, bars, product.ean, code_in_micrometres(), 1e-3);
  else
    draw_barcode(canvas, bars, product.ean, code_in_pixels(height_px));
  return {};
}

Result<PrintedPicture> drawn_tag(const catalog::Product& product,
                                 bool promotion,
                                 int height_px,
                                 bool bars_apart) {
  if (height_px < min_tag_px || height_px > max_tag_px) {
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
             product,
             promotion ? price.part(0, 0.24, 1, 0.97) : price.part(0, 0.06, 1, 0.94),
             colors.price);
  draw_tag_words(canvas, product, tag, colors.type);
  MARKETGEN_CHECK(draw_tag_code(canvas, product, height_px, bars_apart));
  if (promotion) {
    draw_headline(canvas,
                  {offer_word,
                   {"Open Sans", 800, true, false, 0.02},
                   colors.ground,
                   price.part(0.04, 0.04, 0.96, 0.24)});
  }
  canvas.rectangle(tag.inset(0.15)).stroke(faded(print_ink, 0.35), 0.3);
  if (!canvas.healthy()) {
    return Error{"internal.bug", product.sku, "Cairo refused a part of the tag: please report it"};
  }
  return PrintedPicture{canvas.image(), label_bars(canvas)};
}

}  // namespace

std::vector<std::string> price_tag_text(const catalog::Product& product, bool promotion) {
  std::vector<std::string> lines;
  for (std::string line : {std::string(promotion ? offer_word : ""),
                           title_text(product),
                           detail_text(product),
                           catalog::price_text(product.price, catalog::country_of(product)),
                           catalog::unit_price_text(product),
                           product.ean.empty() ? plu_text(product) : product.ean}) {
    if (!line.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

Result<Image> draw_price_tag(const catalog::Product& product, bool promotion, int height_px) {
  MARKETGEN_TRY(PrintedPicture tag, drawn_tag(product, promotion, height_px, false));
  return std::move(tag.picture);
}

Result<PrintedPicture> print_price_tag(const catalog::Product& product,
                                       bool promotion,
                                       int height_px) {
  return drawn_tag(product, promotion, height_px, true);
}

}  // namespace marketgen::assets
