// Cards that hang at the shelf edge under what is on offer.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "assets/print/label.h"
#include "assets/print/lettering.h"
#include "assets/print/pack_art.h"
#include "assets/print/price_type.h"
#include "catalog/country.h"

namespace marketgen::assets {
namespace {

constexpr int min_card_px = 24, max_card_px = 2048;
constexpr Color card_yellow = rgb("#ffd91f");
constexpr Color card_red = rgb("#d5121e");
constexpr Color card_ink = rgb("#1d1a08");

// What the article cost before the offer: 10 to 35 % more off, ending as prices do (in euro: in
// nine cents).
double former_price(const PackArt& art) {
  Stream draw = art.seed.child("promotion").stream();
  const double saving = draw.uniform(0.10, 0.35);
  const catalog::Country& country = catalog::country_of(*art.product);
  if (country.id != "eu") {
    const double least = art.product->price + country.period / std::pow(10, country.minor_digits);
    return std::max(least, catalog::usual_price(art.product->price / (1 - saving), country));
  }
  return std::max(art.product->price + 0.1,
                  std::ceil(art.product->price / (1 - saving) * 10) / 10 - 0.01);
}

void draw_burst(Canvas& canvas, double x, double y, double radius) {
  constexpr int spikes = 14;
  std::vector<std::array<double, 2>> star;
  for (int i = 0; i < 2 * spikes; ++i) {
    const double angle = i * std::numbers::pi / spikes;
    const double r = i % 2 == 0 ? radius : radius * 0.84;
    star.push_back({x + r * std::sin(angle), y - r * std::cos(angle)});
  }
  canvas.polygon(star).fill(card_red);
}

void draw_saving(Canvas& canvas, const catalog::Product& product, double before, const Area& area) {
  const double r = area.w / 2;
  const Canvas::Saved saved = canvas.saved();
  canvas.translate(area.center_x(), area.center_y());
  canvas.rotate(-0.14);
  draw_burst(canvas, 0, 0, r);
  const long percent = std::lround((1 - product.price / before) * 100);
  draw_headline(canvas,
                {fmt::format("-{} %", percent),
                 {"Open Sans", 800, false, true},
                 paper_white,
                 {-r * 0.72, -r * 0.4, r * 1.44, r * 0.8}});
}

void draw_words(Canvas& canvas, const catalog::Product& product, const Area& area) {
  draw_headline(canvas,
                {title_text(product),
                 {"Open Sans", 800},
                 card_ink,
                 area.part(0, 0, 1, 0.62),
                 Align::left,
                 VerticalAlign::middle,
                 2,
                 area.h * 0.34,
                 1.05});
  draw_headline(canvas,
                {detail_text(product),
                 {"Open Sans", 600},
                 card_ink,
                 area.part(0, 0.66, 1, 1),
                 Align::left,
                 VerticalAlign::middle,
                 1,
                 area.h * 0.24});
}

// The former price, struck through, over the new one on its red field.
void draw_prices(Canvas& canvas, const catalog::Product& product, double before, const Area& area) {
  const Area old = area.part(0.04, 0, 0.96, 0.22);
  const Area ink =
      draw_headline(canvas,
                    {"before " + catalog::price_text(before, catalog::country_of(product)),
                     {"Open Sans", 700},
                     card_ink,
                     old,
                     Align::right,
                     VerticalAlign::middle,
                     1,
                     old.h * 0.8});
  const double line = old.h * 0.08;
  canvas.rectangle({ink.center_x(), ink.center_y() - line / 2, ink.w / 2, line}).fill(card_red);
  const Area field = area.part(0, 0.26, 1, 0.84);
  canvas.rounded(field, field.h * 0.10).fill(card_red);
  draw_price(canvas, product, field.part(0.02, 0.04, 0.98, 0.96), paper_white);
  draw_headline(canvas,
                {catalog::unit_price_text(product),
                 {"Open Sans", 600},
                 card_ink,
                 area.part(0, 0.87, 1, 1),
                 Align::right,
                 VerticalAlign::middle,
                 1,
                 area.h * 0.12});
}

}  // namespace

Result<Image> draw_promotion_card(const catalog::Product& product, int height_px) {
  if (height_px < min_card_px || height_px > max_card_px) {
    return Error{
        "assets.bad_row",
        product.sku,
        fmt::format("a promotion card cannot be {} pixels high; choose 24 to 2048", height_px)};
  }
  MARKETGEN_TRY(const PackArt art, pack_art(product));
  const double scale = height_px / promotion_card_height_mm;
  Canvas canvas(
      static_cast<int>(std::lround(promotion_card_width_mm * scale)), height_px, card_yellow);
  canvas.scale(scale, scale);
  const Area card{0, 0, promotion_card_width_mm, promotion_card_height_mm};
  canvas.rectangle(card.part(0, 0, 1, 0.20)).fill(card_red);
  draw_headline(canvas,
                {"SPECIAL OFFER",
                 {"Open Sans", 800, true, false, 0.02},
                 card_yellow,
                 card.part(0.03, 0.03, 0.97, 0.18)});
  const double before = former_price(art);
  draw_words(canvas, product, card.part(0.04, 0.23, 0.96, 0.46));
  draw_motif(canvas, *art.motif, art.ink(), card.part(0.04, 0.49, 0.40, 0.97));
  draw_prices(canvas, product, before, card.part(0.46, 0.48, 0.965, 0.98));
  draw_saving(canvas, product, before, card.part(0.30, 0.46, 0.47, 0.70));
  canvas.rectangle(card.inset(0.2)).stroke(faded(print_ink, 0.35), 0.4);
  if (!canvas.healthy()) {
    return Error{"internal.bug", product.sku, "Cairo refused a part of the card: please report it"};
  }
  return canvas.image();
}

}  // namespace marketgen::assets
