// Type on a canvas: fonts, fitting and paragraphs, by Pango.
//
// Sizes are in the canvas's current units (labels: millimetres), so type is never stretched.
// Hinting and metric rounding are off: the same text breaks the same way at every resolution.
// Thread-safe; fonts are cached per thread.
#pragma once
#include <string>
#include <string_view>

#include "assets/print/canvas.h"

namespace marketgen::assets {

enum class LetterCase { as_written, upper, lower };

struct Typeface {
  std::string_view family =
      "Lato";        // DejaVu Sans, DejaVu Serif, DejaVu Sans Mono, Lato or Open Sans
  int weight = 400;  // 100 thin .. 900 black
  bool italic = false;
  bool condensed = false;
  double tracking_em = 0;  // added between letters
  LetterCase letter_case = LetterCase::as_written;
};

enum class Align { left, center, right };
enum class VerticalAlign { top, middle, bottom };

// A headline: as large as it fits.
struct Headline {
  std::string text;
  Typeface face;
  Color color;
  Area area;
  Align align = Align::center;
  VerticalAlign vertical = VerticalAlign::middle;
  int max_lines = 1;
  double max_size = 1e9;  // font size (em), not line height
  double line_height_em = 1.08;
};

// Draws the text on the number of lines that makes it largest; words are never broken. Returns the
// box that the ink of the lines takes. Empty text draws nothing.
Area draw_headline(Canvas& canvas, const Headline& headline);

// How draw_headline would set it: font size, width of the longest line, number of lines. All 0 for
// empty text.
struct HeadlineFit {
  double size = 0, width = 0;
  int lines = 0;
};
HeadlineFit fit_headline(const Headline& headline);

// Small print of a fixed size, wrapped at words, cut with an ellipsis at the area's bottom. Type
// that would be under four pixels high is drawn as grey lines of the words' lengths, as an eye at
// that distance sees it. Returns the used area.
struct Paragraph {
  std::string text;
  Typeface face;
  Color color;
  Area area;
  double size = 2;
  Align align = Align::left;
};
Area draw_paragraph(Canvas& canvas, const Paragraph& paragraph);

}  // namespace marketgen::assets
