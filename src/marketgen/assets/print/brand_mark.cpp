#include "assets/print/brand_mark.h"

#include "assets/print/brand_pen.h"
#include "base/hash.h"
#include "base/seed.h"

namespace marketgen::assets {
namespace {

// Lettering with enough weight to be read on a pack 60 pixels wide.
constexpr Typeface mark_faces[] = {
    {"Lato", 900, true, false, -0.02, LetterCase::as_written},
    {"Lato", 900, false, false, 0.04, LetterCase::upper},
    {"Lato", 800, false, false, 0.0, LetterCase::lower},
    {"Lato", 900, false, false, -0.03, LetterCase::as_written},
    {"Lato", 700, false, false, 0.14, LetterCase::upper},
    {"Lato", 800, true, false, 0.06, LetterCase::upper},
    {"Open Sans", 800, false, false, -0.02, LetterCase::as_written},
    {"Open Sans", 800, true, false, -0.01, LetterCase::as_written},
    {"Open Sans", 700, false, true, 0.03, LetterCase::upper},
    {"Open Sans", 700, false, true, 0.0, LetterCase::as_written},
    {"Open Sans", 800, false, false, -0.03, LetterCase::lower},
    {"DejaVu Serif", 700, false, false, 0.0, LetterCase::as_written},
    {"DejaVu Serif", 700, true, true, -0.01, LetterCase::as_written},
    {"DejaVu Serif", 700, false, true, 0.08, LetterCase::upper},
    {"DejaVu Serif", 400, true, false, 0.0, LetterCase::as_written},
    {"DejaVu Sans", 700, false, true, 0.0, LetterCase::as_written},
    {"DejaVu Sans", 700, true, true, 0.0, LetterCase::lower},
    {"DejaVu Sans", 700, false, false, 0.10, LetterCase::upper},
    {"DejaVu Sans Mono", 700, false, false, -0.04, LetterCase::lower},
    {"DejaVu Sans Mono", 700, false, false, 0.0, LetterCase::upper},
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

// Dark plates with light trim, bright plates with dark trim, and pale ones.
constexpr MarkColors mark_colors[] = {
    {rgb("#c8102e"), rgb("#ffd23f")}, {rgb("#003f87"), rgb("#ffffff")},
    {rgb("#00693e"), rgb("#f4e04d")}, {rgb("#1b1b1e"), rgb("#d9b45b")},
    {rgb("#e4572e"), rgb("#ffffff")}, {rgb("#5b2a86"), rgb("#f7c5e0")},
    {rgb("#006d77"), rgb("#ffe8a3")}, {rgb("#9b2226"), rgb("#f5e6c8")},
    {rgb("#0b3954"), rgb("#ff9f1c")}, {rgb("#ffffff"), rgb("#c8102e")},
    {rgb("#f6c90e"), rgb("#7a1f1f")}, {rgb("#fff6e0"), rgb("#264f36")},
    {rgb("#d6006d"), rgb("#ffffff")}, {rgb("#0097a7"), rgb("#fdf3d8")},
    {rgb("#4e342e"), rgb("#f2c488")}, {rgb("#7cb518"), rgb("#10331c")},
    {rgb("#1f2a63"), rgb("#f26a8d")}, {rgb("#ff7f11"), rgb("#2b1a00")},
    {rgb("#8d99ae"), rgb("#14213d")}, {rgb("#33691e"), rgb("#ffb74d")},
    {rgb("#6a0f2a"), rgb("#e7c873")}, {rgb("#1565c0"), rgb("#ffe600")},
    {rgb("#f7d6e0"), rgb("#7b1e4b")}, {rgb("#d7efe3"), rgb("#00594c")},
    {rgb("#2b2d42"), rgb("#ef476f")}, {rgb("#b5651d"), rgb("#fff1d6")},
    {rgb("#00856f"), rgb("#ffffff")}, {rgb("#ffd400"), rgb("#00529b")},
    {rgb("#3d1f5c"), rgb("#a6e22e")}, {rgb("#e8e3d3"), rgb("#8b1e1e")},
    {rgb("#ad1f66"), rgb("#ffd9a0")}, {rgb("#12355b"), rgb("#7fd1e8")},
    {rgb("#5c6b1e"), rgb("#fbf2c0")}, {rgb("#ff5a5f"), rgb("#ffffff")},
    {rgb("#283618"), rgb("#dda15e")}, {rgb("#dbe9f6"), rgb("#0b4f8a")},
};

template <class T, std::size_t count>
const T& drawn(const T (&items)[count], Stream& draw) {
  return items[draw.integer(0, static_cast<int>(count) - 1)];
}

using DrawMark = void (*)(const MarkPen& pen);
constexpr DrawMark mark_drawings[] = {
#define MARK_SHAPE(name, description) draw_mark_##name,
#include "assets/print/brand_shapes.inc"
#undef MARK_SHAPE
};

}  // namespace

// The number was searched for: with it, no two brands of data/products share shape, type and
// colours (a test looks); a new brand that looks like another needs a new number.
BrandLook brand_look(std::string_view brand) {
  Stream draw = Seed(hash64(brand)).child("brand look 30").stream();
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
  mark_drawings[static_cast<std::size_t>(look.shape)]({canvas, look, brand, area, ground, align});
}

}  // namespace marketgen::assets
