#include "assets/print/plu_sticker.h"

#include <algorithm>
#include <array>

#include "assets/print/canvas.h"
#include "assets/print/label_sheet.h"
#include "assets/print/lettering.h"
#include "assets/shapes/archetypes/fruit.h"

namespace marketgen::assets {
namespace {

constexpr std::string_view stickered[] = {"apple",
                                          "pear",
                                          "citrus",
                                          "peach",
                                          "plum",
                                          "mango",
                                          "avocado",
                                          "kiwi",
                                          "melon",
                                          "coconut",
                                          "watermelon",
                                          "tomato",
                                          "pumpkin",
                                          "bell_pepper",
                                          "cucumber",
                                          "aubergine",
                                          "sweet_potato",
                                          "banana_bunch",
                                          "round_produce"};

// Ordinary stickers are 20 to 26 mm wide (IFPS PLU user's guide shows them at about 24 x 19).
constexpr double sticker_width_mm = 24, sticker_aspect = 1.25;
constexpr double largest_share = 0.115;  // of the way around the fruit

struct Grower {
  std::string_view name;
  Color ground, trim;
};
constexpr std::array<Grower, 6> growers{{{"Sonnhof", rgb("#c8202c"), rgb("#ffd23c")},
                                         {"Vallerico", rgb("#123f8c"), rgb("#ffd23c")},
                                         {"Solbrisa", rgb("#0f7a3c"), rgb("#f7f3d6")},
                                         {"Verdalia", rgb("#2b6f1f"), rgb("#f2b632")},
                                         {"Orchara", rgb("#7a1550"), rgb("#f7d9e6")},
                                         {"Tropanda", rgb("#0a6a7a"), rgb("#ffe07a")}}};

// In millimetres about the sticker's middle.
void draw_sticker(Canvas& canvas, const PackArt& art, const Grower& grower, double width) {
  const double height = width / sticker_aspect;
  const std::string name =
      art.product->brand.empty() ? std::string(grower.name) : art.product->brand;
  canvas.ellipse(0, 0, width / 2, height / 2).fill(paper_white);
  canvas.ellipse(0, 0, width * 0.465, height * 0.455).fill(grower.ground);
  canvas.ellipse(0, height * 0.17, width * 0.40, height * 0.235).fill(paper_white);
  draw_headline(canvas,
                {.text = name,
                 .face = {.weight = 900, .italic = true},
                 .color = grower.trim,
                 .area = {-width * 0.36, -height * 0.36, width * 0.72, height * 0.27}});
  draw_headline(canvas,
                {.text = "#" + art.product->plu,
                 .face = {.weight = 900, .condensed = true},
                 .color = print_ink,
                 .area = {-width * 0.32, height * 0.02, width * 0.64, height * 0.30}});
}

}  // namespace

bool carries_plu_sticker(const catalog::Product& product) {
  return !product.plu.empty() &&
         std::find(std::begin(stickered), std::end(stickered), product.archetype) !=
             std::end(stickered);
}

void put_plu_sticker(Image& skin, const PackArt& art) {
  const Result<SheetSize> sheet = sheet_size_of(*art.product);
  if (!sheet.ok()) return;  // draw_label has reported it
  const double around_mm = static_cast<double>(sheet.value().width_m) * 1e3;
  const double along_mm = static_cast<double>(sheet.value().height_m) * 1e3;
  Stream draw = art.seed.child("sticker").stream();
  const Grower& grower = growers[static_cast<std::size_t>(draw.integer(0, growers.size() - 1))];
  const double width = std::min({sticker_width_mm, largest_share * around_mm, 0.3 * along_mm});
  // Lying goods have u = 0.5 on top: a little in front of it faces the shopper.
  const double front_u = lies_along_x(*art.product) ? 0.41 : 0.5;
  constexpr double upper_v = 0.42, stray = 0.04;

  Canvas canvas(skin.width, skin.height, paper_white);
  canvas.put(skin, 0, 0);
  canvas.scale(skin.width / around_mm, skin.height / along_mm);
  canvas.translate((front_u + draw.uniform(-stray, stray)) * around_mm,
                   (upper_v + draw.uniform(-stray, stray)) * along_mm);
  canvas.rotate(draw.uniform(-0.35, 0.35));
  draw_sticker(canvas, art, grower, width);
  skin = canvas.image();
}

}  // namespace marketgen::assets
