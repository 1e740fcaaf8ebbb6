#include "assets/brand_mark.h"

#include <algorithm>
#include <numbers>

#include "assets/motif_brush.h"
#include "base/hash.h"
#include "base/seed.h"

namespace marketgen {
namespace {

// Lettering with enough weight to be read on a pack 60 pixels wide.
constexpr Typeface mark_faces[] = {
    {"Lato", 900, true, false, -0.02, LetterCase::as_written},
    {"Lato", 900, false, false, 0.04, LetterCase::upper},
    {"Lato", 800, false, false, 0.0, LetterCase::lower},
    {"Open Sans", 800, false, false, -0.02, LetterCase::as_written},
    {"Open Sans", 800, true, false, -0.01, LetterCase::as_written},
    {"Open Sans", 700, false, true, 0.03, LetterCase::upper},
    {"DejaVu Serif", 700, false, false, 0.0, LetterCase::as_written},
    {"DejaVu Serif", 700, true, true, -0.01, LetterCase::as_written},
    {"DejaVu Serif", 700, false, true, 0.08, LetterCase::upper},
    {"DejaVu Sans", 700, false, true, 0.0, LetterCase::as_written},
    {"DejaVu Sans", 700, true, true, 0.0, LetterCase::lower},
    {"DejaVu Sans Mono", 700, false, false, -0.04, LetterCase::lower},
};

constexpr Typeface name_faces[] = {
    {"Lato", 800, false, false, 0.0, LetterCase::as_written},
    {"Open Sans", 700, false, true, 0.02, LetterCase::upper},
    {"Open Sans", 600, false, false, 0.0, LetterCase::as_written},
    {"DejaVu Serif", 700, false, true, 0.0, LetterCase::as_written},
    {"Lato", 700, true, false, 0.0, LetterCase::as_written},
    {"Lato", 900, false, false, 0.03, LetterCase::upper},
};

struct MarkColors {
  Color plate, trim;
};

constexpr MarkColors mark_colors[] = {
    {rgb("#c8102e"), rgb("#ffd23f")},
    {rgb("#003f87"), rgb("#ffffff")},
    {rgb("#00693e"), rgb("#f4e04d")},
    {rgb("#1b1b1e"), rgb("#d9b45b")},
    {rgb("#e4572e"), rgb("#ffffff")},
    {rgb("#5b2a86"), rgb("#f7c5e0")},
    {rgb("#006d77"), rgb("#ffe8a3")},
    {rgb("#9b2226"), rgb("#f5e6c8")},
    {rgb("#0b3954"), rgb("#ff9f1c")},
    {rgb("#ffffff"), rgb("#c8102e")},
    {rgb("#f6c90e"), rgb("#7a1f1f")},
    {rgb("#fff6e0"), rgb("#264f36")},
};

template <class T, std::size_t count>
const T& drawn(const T (&items)[count], Stream& draw) {
  return items[draw.integer(0, static_cast<int>(count) - 1)];
}

bool takes_two_lines(const std::string& brand) {
  return brand.find(' ') != std::string::npos && brand.size() > 10;
}

void mark_text(Canvas& canvas,
               const BrandLook& look,
               const std::string& brand,
               const Area& area,
               const Color& color,
               Align align) {
  draw_headline(canvas,
                {brand,
                 look.mark_face,
                 color,
                 area,
                 align,
                 VerticalAlign::middle,
                 takes_two_lines(brand) ? 2 : 1,
                 1e9,
                 1.0});
}

// How much of a plate its words may take, and the plate's least width over its height.
struct PlateShape {
  double fill_x, fill_y, least_aspect;
};

// The plate that the brand's words fill, as large as the area allows.
Area plate_area(const BrandLook& look,
                const std::string& brand,
                const Area& area,
                const PlateShape& shape,
                Align align) {
  const HeadlineFit fit = fit_headline({brand,
                                        look.mark_face,
                                        {},
                                        {0, 0, area.w * shape.fill_x, area.h * shape.fill_y},
                                        Align::center,
                                        VerticalAlign::middle,
                                        takes_two_lines(brand) ? 2 : 1,
                                        1e9,
                                        1.0});
  const double h = std::min(area.h, fit.size * fit.lines / shape.fill_y);
  const double w = std::min(area.w, std::max(h * shape.least_aspect, fit.width / shape.fill_x));
  const double x = align == Align::left    ? area.x
                   : align == Align::right ? area.right() - w
                                           : area.center_x() - w / 2;
  return {x, area.center_y() - h / 2, w, h};
}

struct MarkPen {
  Canvas& canvas;
  const BrandLook& look;
  const std::string& brand;
  Area area;
  Color ground;
  Align align;

  Color free_ink() const {
    return readable_on(ground, contrast(ground, look.plate) >= 3.5 ? look.plate : paper_white);
  }
  Color free_trim() const {
    return contrast(ground, look.trim) >= 1.5 ? look.trim : readable_on(ground, look.plate);
  }
  Color plate_ink() const { return readable_on(look.plate, look.trim); }
  void text(const Area& at, const Color& color) const {
    mark_text(canvas, look, brand, at, color, align);
  }
  void plate_text(const Area& at) const {
    mark_text(canvas, look, brand, at, plate_ink(), Align::center);
  }
};

// Plates carry a light outline, so that they stand off any pack.
void fill_plate(const MarkPen& pen, double line) {
  const Color outline =
      contrast(pen.look.plate, pen.look.trim) >= 1.6 ? pen.look.trim : paper_white;
  pen.canvas.fill_and_stroke(pen.look.plate, outline, line);
}

void draw_swoosh(const MarkPen& pen) {
  const Area& a = pen.area;
  const Area word = draw_headline(pen.canvas,
                                  {pen.brand,
                                   pen.look.mark_face,
                                   pen.free_ink(),
                                   a.part(0, 0, 1, 0.80),
                                   pen.align,
                                   VerticalAlign::middle,
                                   1,
                                   1e9,
                                   1.0});
  placed(pen.canvas, word.x, word.bottom(), 0, word.w / 100, [&] {
    pen.canvas.path("M 2 3 C 30 -3 70 -4 99 1 C 70 0 30 3 6 8 C 3 8 1 5 2 3 Z")
        .fill(pen.free_trim());
  });
}

void draw_oval(const MarkPen& pen) {
  const Area p = plate_area(pen.look, pen.brand, pen.area, {0.80, 0.52, 1.7}, pen.align);
  pen.canvas.ellipse(p.center_x(), p.center_y(), p.w * 0.49, p.h * 0.48);
  fill_plate(pen, p.h * 0.05);
  pen.canvas.ellipse(p.center_x(), p.center_y(), p.w * 0.455, p.h * 0.405)
      .stroke(faded(pen.plate_ink(), 0.7), p.h * 0.018);
  pen.plate_text(p.part(0.10, 0.24, 0.90, 0.76));
}

void draw_block(const MarkPen& pen) {
  const Area p = plate_area(pen.look, pen.brand, pen.area, {0.86, 0.66, 1.6}, pen.align);
  pen.canvas.rounded(p.inset(p.h * 0.03), p.h * 0.14);
  fill_plate(pen, p.h * 0.035);
  pen.plate_text(p.part(0.07, 0.17, 0.93, 0.83));
}

void draw_shield(const MarkPen& pen) {
  const Area p = plate_area(pen.look, pen.brand, pen.area, {0.82, 0.46, 1.15}, pen.align);
  const Canvas::Saved saved = pen.canvas.saved();
  pen.canvas.translate(p.x, p.y);
  pen.canvas.scale(p.w / 100, p.h / 100);
  pen.canvas.path(
      "M 3 10 C 22 10 38 8 50 2 C 62 8 78 10 97 10 L 97 56 C 97 80 72 90 50 98 C 28 90 3 80 3 56 "
      "Z");
  fill_plate(pen, 3.4);
  pen.canvas.scale(100 / p.w, 100 / p.h);
  pen.plate_text({p.w * 0.09, p.h * 0.23, p.w * 0.82, p.h * 0.46});
}

void draw_ribbon(const MarkPen& pen) {
  const Area p = plate_area(pen.look, pen.brand, pen.area, {0.76, 0.60, 1.8}, pen.align);
  const Canvas::Saved saved = pen.canvas.saved();
  pen.canvas.translate(p.x, p.y);
  pen.canvas.scale(p.w / 100, p.h / 100);
  pen.canvas
      .path("M 0 24 L 14 24 L 14 96 L 0 96 L 6 60 Z M 100 24 L 86 24 L 86 96 L 100 96 L 94 60 Z")
      .fill(darker(pen.look.plate, 0.35));
  pen.canvas.path("M 8 8 L 92 8 L 92 82 L 8 82 Z");
  fill_plate(pen, 2.2);
  pen.canvas.scale(100 / p.w, 100 / p.h);
  pen.plate_text({p.w * 0.12, p.h * 0.15, p.w * 0.76, p.h * 0.60});
}

void draw_leaf_mark(const MarkPen& pen) {
  const Area& a = pen.area;
  const Area word = draw_headline(pen.canvas,
                                  {pen.brand,
                                   pen.look.mark_face,
                                   pen.free_ink(),
                                   a.part(0, 0.22, 0.9, 1),
                                   pen.align,
                                   VerticalAlign::middle,
                                   1,
                                   1e9,
                                   1.0});
  const double length = std::min(a.h * 0.42, word.h * 0.75);
  const Color green = contrast(pen.ground, rgb("#3f9b3a")) > 1.5 ? rgb("#3f9b3a") : rgb("#c5e08a");
  leaf(pen.canvas, word.right() - length * 0.2, word.y + word.h * 0.16, -0.75, length, green);
  leaf(pen.canvas,
       word.right() - length * 0.2,
       word.y + word.h * 0.16,
       -1.75,
       length * 0.7,
       lighter(green, 0.2));
}

// The first character of UTF-8 text, with its continuation bytes.
std::string first_letter(const std::string& text) {
  std::size_t end = 1;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
    ++end;
  return text.substr(0, end);
}

void draw_roundel(const MarkPen& pen) {
  const Area& a = pen.area;
  const double r = std::min(a.h * 0.46, a.w * 0.15);
  const double x = pen.align == Align::center ? a.x + r * 1.1 : a.x + r;
  pen.canvas.circle(x, a.center_y(), r);
  fill_plate(pen, r * 0.12);
  const std::string first = first_letter(pen.brand);
  draw_headline(pen.canvas,
                {first,
                 pen.look.mark_face,
                 pen.plate_ink(),
                 {x - r * 0.7, a.center_y() - r * 0.75, r * 1.4, r * 1.5}});
  mark_text(pen.canvas,
            pen.look,
            pen.brand,
            {x + r * 1.3, a.y + a.h * 0.12, a.right() - x - r * 1.3, a.h * 0.76},
            pen.free_ink(),
            Align::left);
}

void draw_rules(const MarkPen& pen) {
  const Area& a = pen.area;
  const Area word = draw_headline(pen.canvas,
                                  {pen.brand,
                                   pen.look.mark_face,
                                   pen.free_ink(),
                                   a.part(0, 0.14, 1, 0.86),
                                   pen.align,
                                   VerticalAlign::middle,
                                   1,
                                   1e9,
                                   1.15});
  const double line = word.h * 0.05;
  pen.canvas.rectangle({word.x, word.y - line, word.w, line}).fill(pen.free_trim());
  pen.canvas.rectangle({word.x, word.bottom(), word.w, line}).fill(pen.free_trim());
}

void draw_sun(const MarkPen& pen) {
  const Area& a = pen.area;
  const Area word = draw_headline(pen.canvas,
                                  {pen.brand,
                                   pen.look.mark_face,
                                   pen.free_ink(),
                                   a.part(0, 0.32, 1, 1),
                                   pen.align,
                                   VerticalAlign::middle,
                                   1,
                                   1e9,
                                   1.0});
  const double r = std::min(a.h * 0.30, word.w * 0.22);
  const double y = word.y + word.h * 0.10;
  for (int ray = 0; ray < 9; ++ray) {
    placed(pen.canvas, word.center_x(), y, std::numbers::pi * (1 + (ray + 0.5) / 9), r / 10, [&] {
      pen.canvas.path("M 6.4 -0.9 L 10.5 0 L 6.4 0.9 Z").fill(pen.free_trim());
    });
  }
  {
    const Canvas::Saved saved = pen.canvas.saved();
    pen.canvas.rectangle({word.center_x() - r, y - r, 2 * r, r}).clip();
    pen.canvas.circle(word.center_x(), y, r * 0.52).fill(pen.free_trim());
  }
}

void draw_diamond(const MarkPen& pen) {
  const Area& a = pen.area;
  const Area word = draw_headline(pen.canvas,
                                  {pen.brand,
                                   pen.look.mark_face,
                                   pen.free_ink(),
                                   a.part(0, 0.24, 1, 1),
                                   pen.align,
                                   VerticalAlign::middle,
                                   1,
                                   1e9,
                                   1.0});
  const double r = std::min(a.h * 0.11, word.w * 0.05);
  const double y = word.y - r * 0.1;
  for (const double shift : {-2.6, 0.0, 2.6}) {
    const double x = word.center_x() + shift * r;
    const double s = shift == 0.0 ? r * 1.25 : r * 0.8;
    pen.canvas.polygon({{x, y - s}, {x + s * 0.8, y}, {x, y + s}, {x - s * 0.8, y}});
    pen.canvas.fill(pen.free_trim());
  }
}

void draw_initial(const MarkPen& pen) {
  const Area word = draw_headline(pen.canvas,
                                  {pen.brand,
                                   pen.look.mark_face,
                                   pen.free_ink(),
                                   pen.area.part(0.04, 0.08, 0.96, 0.92),
                                   pen.align,
                                   VerticalAlign::middle,
                                   1,
                                   1e9,
                                   1.0});
  const double r = word.h * 0.10;
  pen.canvas.circle(word.right() + r * 1.6, word.y + word.h * 0.70, r).fill(pen.free_trim());
}

void draw_wordmark(const MarkPen& pen) {
  const double lift = pen.area.h * 0.018;
  Area shadow = pen.area;
  shadow.x += lift;
  shadow.y += lift;
  pen.text(shadow, faded(darker(pen.ground, 0.6), 0.35));
  pen.text(pen.area, pen.free_ink());
}

}  // namespace

BrandLook brand_look(std::string_view brand) {
  Stream draw = Seed(hash64(brand)).child("brand look").stream();
  BrandLook look;
  look.shape =
      static_cast<MarkShape>(draw.integer(0, static_cast<int>(names_of(MarkShape{}).size()) - 1));
  look.mark_face = drawn(mark_faces, draw);
  look.name_face = drawn(name_faces, draw);
  const MarkColors& colors = drawn(mark_colors, draw);
  look.plate = colors.plate;
  look.trim = colors.trim;
  look.design = static_cast<std::size_t>(draw.integer(0, 999));
  look.pattern = draw.integer(0, 3);
  return look;
}

void draw_brand_mark(Canvas& canvas,
                     const BrandLook& look,
                     const std::string& brand,
                     const Area& area,
                     const Color& ground,
                     Align align) {
  if (brand.find_first_not_of(' ') == std::string::npos || area.w <= 0 || area.h <= 0) return;
  const MarkPen pen{canvas, look, brand, area, ground, align};
  switch (look.shape) {
    case MarkShape::wordmark:
      return draw_wordmark(pen);
    case MarkShape::swoosh:
      return draw_swoosh(pen);
    case MarkShape::oval:
      return draw_oval(pen);
    case MarkShape::block:
      return draw_block(pen);
    case MarkShape::shield:
      return draw_shield(pen);
    case MarkShape::ribbon:
      return draw_ribbon(pen);
    case MarkShape::leaf:
      return draw_leaf_mark(pen);
    case MarkShape::roundel:
      return draw_roundel(pen);
    case MarkShape::rules:
      return draw_rules(pen);
    case MarkShape::sun:
      return draw_sun(pen);
    case MarkShape::diamond:
      return draw_diamond(pen);
    case MarkShape::initial:
      return draw_initial(pen);
  }
}

}  // namespace marketgen
