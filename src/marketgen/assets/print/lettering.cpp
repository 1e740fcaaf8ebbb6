#include "assets/print/lettering.h"

#include <pango/pangocairo.h>
#include <pango/pangofc-fontmap.h>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <vector>

#include "assets/print/fonts.h"
#include "base/text.h"

namespace marketgen::assets {
namespace {

struct ReleaseObject {
  void operator()(gpointer object) const { g_object_unref(object); }
};
template <class T>
using Shared = std::unique_ptr<T, ReleaseObject>;

// Held by every public function here. Cairo 1.16 shares the glyphs of a font among all threads and
// evicts some while another thread draws them: labels made side by side came out wrong, or crashed.
std::mutex glyph_mutex;

Shared<PangoFontMap> our_font_map() {
  FcConfig* const config = font_config();  // before Pango looks for the machine's
  Shared<PangoFontMap> map(pango_cairo_font_map_new_for_font_type(CAIRO_FONT_TYPE_FT));
  pango_fc_font_map_set_config(PANGO_FC_FONT_MAP(map.get()), config);
  return map;
}

// One thread's fonts. Pango's maps are not thread-safe, hence one each.
struct FontRoom {
  Shared<PangoFontMap> map = our_font_map();
  Shared<PangoContext> context{pango_font_map_create_context(map.get())};

  FontRoom() {
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(context.get(), options);
    cairo_font_options_destroy(options);
    pango_cairo_context_set_resolution(context.get(), 72);
    pango_context_set_language(context.get(), pango_language_from_string("en"));
    pango_context_set_base_dir(context.get(), PANGO_DIRECTION_LTR);
    pango_context_set_round_glyph_positions(context.get(), FALSE);
  }
};

FontRoom& font_room() {
  thread_local FontRoom room;
  return room;
}

// Layouts are shaped at this size and scaled to the wanted one, so that Pango's fixed-point units
// never show.
constexpr double shaping_size = 64;

std::string cased(const std::string& text, LetterCase letter_case) {
  if (letter_case == LetterCase::as_written) return text;
  const auto convert = letter_case == LetterCase::upper ? g_utf8_strup : g_utf8_strdown;
  const std::unique_ptr<char, decltype(&g_free)> converted(
      convert(text.data(), static_cast<gssize>(text.size())), g_free);
  return converted.get();
}

Shared<PangoLayout> shape(const std::string& text, const Typeface& face, Align align) {
  Shared<PangoLayout> layout(pango_layout_new(font_room().context.get()));
  PangoFontDescription* font = pango_font_description_new();
  pango_font_description_set_family(font, std::string(face.family).c_str());
  pango_font_description_set_weight(font, static_cast<PangoWeight>(face.weight));
  pango_font_description_set_style(font, face.italic ? PANGO_STYLE_ITALIC : PANGO_STYLE_NORMAL);
  pango_font_description_set_stretch(
      font, face.condensed ? PANGO_STRETCH_CONDENSED : PANGO_STRETCH_NORMAL);
  pango_font_description_set_absolute_size(font, shaping_size * PANGO_SCALE);
  pango_layout_set_font_description(layout.get(), font);
  pango_font_description_free(font);
  if (face.tracking_em != 0) {
    PangoAttrList* attributes = pango_attr_list_new();
    pango_attr_list_insert(attributes,
                           pango_attr_letter_spacing_new(
                               static_cast<int>(face.tracking_em * shaping_size * PANGO_SCALE)));
    pango_layout_set_attributes(layout.get(), attributes);
    pango_attr_list_unref(attributes);
  }
  pango_layout_set_alignment(layout.get(),
                             align == Align::left     ? PANGO_ALIGN_LEFT
                             : align == Align::center ? PANGO_ALIGN_CENTER
                                                      : PANGO_ALIGN_RIGHT);
  pango_layout_set_text(layout.get(), text.data(), static_cast<int>(text.size()));
  return layout;
}

// Width of one line at the shaping size; letter spacing after the last letter not counted.
double measured_width(const std::string& text, const Typeface& face) {
  const Shared<PangoLayout> layout = shape(text, face, Align::left);
  PangoRectangle logical;
  pango_layout_get_extents(layout.get(), nullptr, &logical);
  return static_cast<double>(logical.width) / PANGO_SCALE -
         std::max(0.0, face.tracking_em) * shaping_size;
}

// The same, from memory when the line has been measured before: a shop's packs say the same words
// again and again. Only while glyph_mutex is held.
double line_width(const std::string& text, const Typeface& face) {
  using Key = std::tuple<std::string, std::string, int, bool, bool, double>;
  static std::map<Key, double> known;
  constexpr std::size_t max_known = 50'000;
  if (known.size() > max_known) known.clear();
  const auto [entry, is_new] = known.try_emplace(
      {text, std::string(face.family), face.weight, face.italic, face.condensed, face.tracking_em});
  if (is_new) entry->second = measured_width(text, face);
  return entry->second;
}

struct BrokenText {
  std::vector<std::string> lines;
  double width = 0;  // of the longest line at the shaping size
};

// The words on `count` lines so that the longest is as short as greedy filling finds: the bound
// grows until they fit.
BrokenText broken(const std::vector<std::string>& words,
                  const std::vector<double>& widths,
                  double blank,
                  std::size_t count) {
  double longest = *std::max_element(widths.begin(), widths.end());
  for (;;) {
    BrokenText text;
    double used = 0;
    double too_long = 1e300;  // the shortest line that did not fit: the next bound to try
    for (std::size_t i = 0; i < words.size(); ++i) {
      const double with_word = used + blank + widths[i];
      if (!text.lines.empty() && with_word <= longest + 1e-9) {
        text.lines.back() += " " + words[i];
        used = with_word;
      } else {
        if (!text.lines.empty()) too_long = std::min(too_long, with_word);
        text.lines.push_back(words[i]);
        used = widths[i];
      }
      text.width = std::max(text.width, used);
    }
    if (text.lines.size() <= count) return text;
    longest = too_long;
  }
}

struct FittedText {
  std::vector<std::string> lines;
  double size = 0;
  double width = 0;  // of the longest line, at that size
};

FittedText fitted(const Headline& headline) {
  const std::string text = cased(headline.text, headline.face.letter_case);
  std::vector<std::string> words = marketgen::split(text, ' ');
  std::erase(words, "");
  if (words.empty() || headline.area.w <= 0 || headline.area.h <= 0) return {};
  std::vector<double> widths;
  widths.reserve(words.size());
  for (const std::string& word : words)
    widths.push_back(line_width(word, headline.face));
  const double blank =
      0.27 * shaping_size +
      headline.face.tracking_em * 2 * shaping_size;  // a word space is about a quarter em
  FittedText best;
  const std::size_t most =
      std::min(words.size(), static_cast<std::size_t>(std::max(1, headline.max_lines)));
  for (std::size_t count = 1; count <= most; ++count) {
    const BrokenText text_lines = broken(words, widths, blank, count);
    double width = 0;
    for (const std::string& line : text_lines.lines) {
      width = std::max(width, line_width(line, headline.face));
    }
    const double by_width = headline.area.w / (width / shaping_size);
    const double by_height =
        headline.area.h / (static_cast<double>(text_lines.lines.size()) * headline.line_height_em);
    const double size = std::min({by_width, by_height, headline.max_size});
    if (size > best.size * 1.02) best = {text_lines.lines, size, width * size / shaping_size};
  }
  return best;
}

// Left edge of a line of `width` in `area`.
double aligned_x(const Area& area, double width, Align align) {
  if (align == Align::left) return area.x;
  return align == Align::center ? area.center_x() - width / 2 : area.right() - width;
}

double aligned_y(const Area& area, double height, VerticalAlign align) {
  if (align == VerticalAlign::top) return area.y;
  return align == VerticalAlign::middle ? area.center_y() - height / 2 : area.bottom() - height;
}

void show(Canvas& canvas, PangoLayout* layout, double x, double y, double size) {
  const Canvas::Saved saved = canvas.saved();
  canvas.translate(x, y);
  canvas.scale(size / shaping_size, size / shaping_size);
  pango_cairo_show_layout(canvas.context(), layout);
}

// Grey bars for lines too small to read.
void show_greeked(Canvas& canvas, PangoLayout* layout, const Paragraph& paragraph) {
  const double scale = paragraph.size / shaping_size / PANGO_SCALE;
  PangoLayoutIter* line = pango_layout_get_iter(layout);
  do {
    PangoRectangle logical;
    pango_layout_iter_get_line_extents(line, nullptr, &logical);
    const double baseline = pango_layout_iter_get_baseline(line) * scale;
    canvas.rectangle({paragraph.area.x + logical.x * scale,
                      paragraph.area.y + baseline - 0.48 * paragraph.size,
                      logical.width * scale,
                      0.5 * paragraph.size});
  } while (pango_layout_iter_next_line(line));
  pango_layout_iter_free(line);
  canvas.fill(faded(paragraph.color, 0.45));
}

}  // namespace

HeadlineFit fit_headline(const Headline& headline) {
  const std::lock_guard lock(glyph_mutex);
  const FittedText text = fitted(headline);
  return {text.size, text.width, static_cast<int>(text.lines.size())};
}

Area draw_headline(Canvas& canvas, const Headline& headline) {
  const std::lock_guard lock(glyph_mutex);
  const FittedText text = fitted(headline);
  if (text.lines.empty()) return {headline.area.x, headline.area.y, 0, 0};
  const double step = text.size * headline.line_height_em;
  const double height = step * static_cast<double>(text.lines.size());
  double y = aligned_y(headline.area, height, headline.vertical);
  Area used{headline.area.right(), y, 0, height};
  double right = headline.area.x;
  cairo_set_source_rgba(
      canvas.context(), headline.color.r, headline.color.g, headline.color.b, headline.color.a);
  for (const std::string& line : text.lines) {
    const Shared<PangoLayout> layout = shape(line, headline.face, Align::left);
    const double width = line_width(line, headline.face) * text.size / shaping_size;
    const double x = aligned_x(headline.area, width, headline.align);
    // The middle of the capitals (0.36 em over the baseline) comes to the middle of the line.
    const double baseline = y + step / 2 + 0.36 * text.size;
    const double ascent =
        pango_layout_get_baseline(layout.get()) / static_cast<double>(PANGO_SCALE) / shaping_size;
    show(canvas, layout.get(), x, baseline - ascent * text.size, text.size);
    used.x = std::min(used.x, x);
    right = std::max(right, x + width);
    y += step;
  }
  used.w = right - used.x;
  return used;
}

Area draw_paragraph(Canvas& canvas, const Paragraph& paragraph) {
  const std::lock_guard lock(glyph_mutex);
  const Area& area = paragraph.area;
  if (paragraph.text.empty() || area.w <= 0 || area.h < paragraph.size)
    return {area.x, area.y, 0, 0};
  const std::string text = cased(paragraph.text, paragraph.face.letter_case);
  const Shared<PangoLayout> layout = shape(text, paragraph.face, paragraph.align);
  const double scale = paragraph.size / shaping_size;
  pango_layout_set_width(layout.get(), static_cast<int>(area.w / scale * PANGO_SCALE));
  pango_layout_set_height(layout.get(), static_cast<int>(area.h / scale * PANGO_SCALE));
  pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD);
  pango_layout_set_ellipsize(layout.get(), PANGO_ELLIPSIZE_END);
  constexpr double readable_px = 4;
  if (paragraph.size * canvas.pixels_per_unit_y() < readable_px) {
    show_greeked(canvas, layout.get(), paragraph);
  } else {
    cairo_set_source_rgba(canvas.context(),
                          paragraph.color.r,
                          paragraph.color.g,
                          paragraph.color.b,
                          paragraph.color.a);
    show(canvas, layout.get(), area.x, area.y, paragraph.size);
  }
  PangoRectangle logical;
  pango_layout_get_extents(layout.get(), nullptr, &logical);
  return {
      area.x, area.y, logical.width * scale / PANGO_SCALE, logical.height * scale / PANGO_SCALE};
}

}  // namespace marketgen::assets
