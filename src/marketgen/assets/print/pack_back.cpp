#include "assets/print/pack_back.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assets/print/barcode.h"
#include "assets/print/lettering.h"
#include "assets/print/pack_facts.h"

namespace marketgen::assets {
namespace {

constexpr Typeface small_face{"Open Sans", 400};
constexpr Typeface small_bold{"Open Sans", 700};

// Small print grows with the pack: regulation (EU) 1169/2011 asks for an x-height of 1.2 mm (0.9 on
// small packs), half an em.
double small_size(const Area& area) {
  return std::clamp(std::sqrt(std::max(1.0, area.w * area.h)) * 0.034, 1.8, 7.0);
}

// Pixel box of an area in the canvas's units (no turn in the transform).
Area in_pixels(Canvas& canvas, const Area& a) {
  double x0 = a.x;
  double y0 = a.y;
  double x1 = a.right();
  double y1 = a.bottom();
  cairo_user_to_device(canvas.context(), &x0, &y0);
  cairo_user_to_device(canvas.context(), &x1, &y1);
  x0 = std::ceil(x0 - 1e-6);
  y0 = std::ceil(y0 - 1e-6);
  return {x0, y0, std::floor(x1 + 1e-6) - x0, std::floor(y1 + 1e-6) - y0};
}

Area in_units(Canvas& canvas, const Area& px) {
  double x0 = px.x;
  double y0 = px.y;
  double x1 = px.right();
  double y1 = px.bottom();
  cairo_device_to_user(canvas.context(), &x0, &y0);
  cairo_device_to_user(canvas.context(), &x1, &y1);
  return {x0, y0, x1 - x0, y1 - y0};
}

// GS1 general specifications, EAN-13 with digits: height and module at nominal size, and the
// smallest module allowed (80 %).
constexpr double nominal_height_mm = 25.9, nominal_module_mm = 0.33, min_module_mm = 0.264;

// Pixels a module wants: two at a sheet of 512 pixels, more on larger sheets, and at least nominal
// size (X = 0.33 mm).
int wanted_module_px(Canvas& canvas) {
  const int by_sheet = std::max(2, canvas.height_px() / 256);
  return std::max(by_sheet,
                  static_cast<int>(std::lround(nominal_module_mm * canvas.pixels_per_unit_x())));
}

// The code stands at the foot of a field, or beside the words where the field is low.
bool is_high(const Area& field) {
  return field.h > field.w * 0.5;
}

// Bags swell in the middle and fall away to their sides, where a scanner sees the modules crowd.
bool swells(const catalog::Product& product) {
  constexpr std::array<std::string_view, 3> bags{"pouch", "pillow_bag", "flow_pack"};
  return std::find(bags.begin(), bags.end(), product.archetype) != bags.end();
}

// The EAN's place at the foot of the area, or anywhere in it where the foot would make its modules
// smaller than `least`; at the right, or in the middle where the pack swells. All in whole units of
// the area.
BarcodePlace ean_place(const Area& area,
                       int wanted,
                       int least,
                       double wanted_height,
                       const catalog::Product& product) {
  const Area foot = is_high(area) ? area.part(0, 0.42, 1, 1) : area.part(0.45, 0, 1, 1);
  BarcodePlace place = place_barcode(foot, wanted, wanted_height);
  if (place.module_px < least) place = place_barcode(area, wanted, wanted_height);
  if (swells(product) && is_high(area)) {
    const int width = place.ladder ? place.height_px : place.module_px * ean13_width_modules;
    place.x = static_cast<int>(area.x + (area.w - width) / 2);
  }
  return place;
}

// What the symbol covers, in the units of its place.
Area covered(const BarcodePlace& place) {
  const double length = place.module_px * ean13_width_modules;
  const double across = place.height_px;
  return {static_cast<double>(place.x),
          static_cast<double>(place.y),
          place.ladder ? across : length,
          place.ladder ? length : across};
}

// True to size: modules are counted in thousandths of a millimetre.
Area leave_ean(Canvas& canvas, const PackArt& art, const Area& area) {
  constexpr double fine = 1000;
  const BarcodePlace place = ean_place({area.x * fine, area.y * fine, area.w * fine, area.h * fine},
                                       static_cast<int>(nominal_module_mm * fine),
                                       static_cast<int>(min_module_mm * fine),
                                       nominal_height_mm * fine,
                                       *art.product);
  leave_barcode(canvas, art.bars, art.product->ean, place, 1 / fine);
  const Area taken = covered(place);
  return {taken.x / fine, taken.y / fine, taken.w / fine, taken.h / fine};
}

// Draws the EAN at the foot of the area; returns what it covers, empty without an EAN.
Area draw_ean(Canvas& canvas, const PackArt& art, const Area& area) {
  if (art.bars.empty()) return {area.right(), area.bottom(), 0, 0};
  if (art.bars_apart) return leave_ean(canvas, art, area);
  const int wanted = wanted_module_px(canvas);
  const BarcodePlace place = ean_place(in_pixels(canvas, area),
                                       wanted,
                                       wanted,
                                       nominal_height_mm * canvas.pixels_per_unit_y(),
                                       *art.product);
  draw_barcode(canvas, art.bars, art.product->ean, place);
  return in_units(canvas, covered(place));
}

// Two arrows in a ring: "the pack can be recycled".
void draw_recycling_mark(Canvas& canvas, const Area& area, const Color& color) {
  const double r = std::min(area.w, area.h) * 0.42;
  if (r <= 0) return;
  const Canvas::Saved saved = canvas.saved();
  canvas.translate(area.center_x(), area.center_y());
  canvas.scale(r / 10, r / 10);
  canvas.path("M -10 0 C -10 -7 -5 -10 0 -10 C 3 -10 6 -9 8 -6").stroke(color, 2.2);
  canvas.path("M 10 0 C 10 7 5 10 0 10 C -3 10 -6 9 -8 6").stroke(color, 2.2);
  canvas.path("M 10 -9 L 9.5 -2.5 L 4 -5.5 Z M -10 9 L -9.5 2.5 L -4 5.5 Z").fill(color);
}

// Natural line height of Open Sans over its size (ascender 2189, descender 600 of 2048 units an
// em).
constexpr double line_height_em = 1.362;

// Names left, amounts right, as two columns of lines; returns the used area. Rows are at most
// `row_height` high.
Area draw_nutrition_table(Canvas& canvas,
                          const PackFacts& facts,
                          const Area& area,
                          double row_height,
                          const Color& type) {
  const int rows = static_cast<int>(facts.nutrition.size()) + 1;
  // "1234 kJ / 295 kcal" needs nine em in its column.
  constexpr double size_by_width = 0.045;
  const double h = std::min({row_height, area.h / rows, area.w * size_by_width * line_height_em});
  const Area table{area.x, area.y, area.w, h * rows};
  canvas.rectangle({area.x, area.y, area.w, h}).fill(faded(type, 0.16));
  std::string names = "Nutrition";
  std::string amounts = facts.nutrition_head;
  for (const auto& [name, amount] : facts.nutrition) {
    names += "\n" + std::string(name.rfind("of which", 0) == 0 ? "   " : "") + name;
    amounts += "\n" + amount;
  }
  const double size = h / line_height_em;
  const Area cell{area.x + h * 0.25, area.y, area.w - h * 0.5, table.h + h};
  draw_paragraph(canvas, {names, small_bold, type, {cell.x, cell.y, cell.w * 0.6, cell.h}, size});
  draw_paragraph(canvas,
                 {amounts,
                  small_face,
                  type,
                  {cell.x + cell.w * 0.45, cell.y, cell.w * 0.55, cell.h},
                  size,
                  Align::right});
  for (int row = 1; row < rows; ++row)
    canvas.rectangle({area.x, area.y + row * h, area.w, h * 0.05});
  canvas.fill(faded(type, 0.7));
  canvas.rectangle(table).stroke(faded(type, 0.85), h * 0.08);
  return table;
}

// Writes a paragraph at the top of `area` and takes what it used off it.
void write_down(Canvas& canvas,
                Area& area,
                const std::string& text,
                const Typeface& face,
                double size,
                const Color& type,
                Align align = Align::left) {
  if (text.empty() || area.h < size * 1.3) return;
  const Area used = draw_paragraph(canvas, {text, face, type, area, size, align});
  const double step = used.h + size * 0.5;
  area.y += step;
  area.h -= step;
}

void take_top(Area& area, double height) {
  area.y += height;
  area.h -= height;
}

}  // namespace

Area draw_back(Canvas& canvas, const PackArt& art, const InfoField& field) {
  const PackFacts facts = pack_facts(art);
  const catalog::Product& product = *art.product;
  const double size = small_size(field.area);
  const Area& all = field.area;
  const bool high = is_high(all);
  const Area code = draw_ean(canvas, art, all);
  const std::string marks =
      facts.best_before.empty() ? facts.lot : facts.best_before + "  " + facts.lot;
  Area words{all.x, all.y, all.w, code.y - all.y - size * 0.5};
  if (high && !swells(product) && code.w < all.w * 0.62 && code.h <= all.h * 0.5) {
    Area left{all.x, code.y, all.w - code.w - size, code.h};
    const double mark = std::min({left.w, left.h * 0.5, size * 5});
    draw_recycling_mark(canvas, {left.x, left.y, mark, mark}, field.type);
    take_top(left, mark + size * 0.4);
    write_down(canvas, left, marks, small_bold, size, field.type);
  } else {
    if (!high || code.h > all.h * 0.5) words = {all.x, all.y, all.w - code.w - size, all.h};
    write_down(canvas, words, marks, small_bold, size, field.type);
  }
  const std::string title =
      product.brand + " " + product.name + (product.variant.empty() ? "" : " " + product.variant);
  write_down(canvas, words, title, small_bold, size * 1.35, field.type);
  for (const std::string& text : {product.description, facts.contents, facts.directions}) {
    write_down(canvas, words, text, small_face, size, field.type);
  }
  return words;
}

void draw_full_back(Canvas& canvas, const PackArt& art, const InfoField& field) {
  const Area rest = draw_back(canvas, art, field);
  const PackFacts facts = pack_facts(art);
  const double size = small_size(field.area);
  if (!facts.nutrition.empty() && rest.h > size * 9)
    draw_nutrition_table(canvas, facts, rest, size * 1.6, field.type);
}

void draw_nutrition_side(Canvas& canvas, const PackArt& art, const InfoField& field) {
  const PackFacts facts = pack_facts(art);
  const double size = small_size(field.area);
  Area rest = field.area;
  if (facts.nutrition.empty()) {
    write_down(
        canvas, rest, facts.food ? "Storage" : "Directions", small_bold, size * 1.5, field.type);
    write_down(canvas, rest, facts.directions, small_face, size * 1.15, field.type);
    write_down(canvas, rest, facts.contents, small_face, size, field.type);
    return;
  }
  const Area table = draw_nutrition_table(canvas, facts, rest, size * 2.0, field.type);
  take_top(rest, table.h + size);
  write_down(canvas, rest, facts.directions, small_face, size, field.type);
  write_down(canvas,
             rest,
             "Made for " + art.product->brand + ", Market Street 1. Please recycle.",
             small_face,
             size,
             field.type);
}

void draw_story_side(Canvas& canvas, const PackArt& art, const InfoField& field) {
  const Area& a = field.area;
  const bool wide = a.w > a.h;
  const Area picture = wide ? a.part(0, 0.05, 0.32, 0.95) : a.part(0.0, 0.04, 1.0, 0.44);
  Area words = wide ? a.part(0.37, 0.05, 1, 0.95) : a.part(0, 0.48, 1, 1);
  draw_motif(canvas, *art.motif, art.ink(), picture);
  Typeface face = art.look.name_face;
  const double title = std::min(words.h * 0.36, words.w * 0.45);
  const Area used = draw_headline(canvas,
                                  {art.product->name,
                                   face,
                                   field.type,
                                   {words.x, words.y, words.w, title},
                                   Align::center,
                                   VerticalAlign::top,
                                   2});
  take_top(words, used.h + title * 0.1);
  write_down(canvas,
             words,
             art.product->description,
             small_face,
             small_size(a) * 1.3,
             field.type,
             Align::center);
}

void draw_bottom(Canvas& canvas, const PackArt& art, const InfoField& field) {
  const PackFacts facts = pack_facts(art);
  const std::string text =
      facts.best_before.empty() ? facts.lot : facts.best_before + "  " + facts.lot;
  draw_headline(canvas,
                {text,
                 {"DejaVu Sans Mono", 700},
                 field.type,
                 field.area.part(0.1, 0.3, 0.9, 0.7),
                 Align::center,
                 VerticalAlign::middle,
                 2,
                 field.area.h * 0.14});
}

}  // namespace marketgen::assets
