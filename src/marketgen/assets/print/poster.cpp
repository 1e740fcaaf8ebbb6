#include "assets/print/poster.h"

#include <array>
#include <cmath>
#include <string>

#include "assets/print/label_motif.h"
#include "assets/print/lettering.h"

namespace marketgen::assets {
namespace {

constexpr int min_poster_px = 64, max_poster_px = 4096;
constexpr unsigned designs = 3;

struct PosterSheet {
  Canvas& canvas;
  const Poster& poster;
  const LabelMotif& motif;
  MotifInk ink;
  Area area;
};

void write_poster_line(PosterSheet& sheet,
                       std::string_view text,
                       const Typeface& face,
                       const Color& color,
                       const Area& area,
                       int lines) {
  draw_headline(
      sheet.canvas,
      {std::string(text), face, color, area, Align::center, VerticalAlign::middle, lines});
}

// A cream sheet, the motif in the middle, a strap of the house's colour at the foot.
void draw_cream_poster(PosterSheet& sheet) {
  const Area a = sheet.area;
  const Color paper{0.97, 0.945, 0.885}, print{0.16, 0.15, 0.13};
  sheet.canvas.rectangle(a).fill(
      Paint::radial(a.center_x(),
                    a.center_y(),
                    a.h * 0.75,
                    a.center_x(),
                    a.center_y(),
                    {{0, lighter(paper, 0.5)}, {1, darker(paper, 0.08)}}));
  draw_motif(sheet.canvas, sheet.motif, sheet.ink, a.part(0.07, 0.26, 0.93, 0.82));
  write_poster_line(
      sheet, sheet.poster.headline, {"Lato", 900}, print, a.part(0.08, 0.05, 0.92, 0.25), 2);
  sheet.canvas.rectangle(a.part(0, 0.87, 1, 1)).fill(sheet.ink.primary);
  write_poster_line(
      sheet, sheet.poster.line, {"Lato", 500}, Color{1, 1, 1}, a.part(0.08, 0.895, 0.92, 0.975), 1);
}

// The house's colour all over, the motif on a light disc that the sheet's edge cuts.
void draw_disc_poster(PosterSheet& sheet) {
  const Area a = sheet.area;
  const Color ground = sheet.ink.primary;
  sheet.canvas.rectangle(a).fill(
      Paint::linear(0, 0, 0, a.h, {{0, lighter(ground, 0.10)}, {1, darker(ground, 0.18)}}));
  sheet.canvas.circle(a.center_x(), a.y + a.h * 0.66, a.w * 0.56).fill(lighter(ground, 0.82));
  draw_motif(sheet.canvas, sheet.motif, sheet.ink, a.part(0.05, 0.38, 0.95, 0.94));
  write_poster_line(sheet,
                    sheet.poster.headline,
                    {"Lato", 900},
                    Color{1, 1, 1},
                    a.part(0.07, 0.05, 0.93, 0.25),
                    2);
  write_poster_line(sheet,
                    sheet.poster.line,
                    {"Lato", 400, true},
                    lighter(ground, 0.75),
                    a.part(0.1, 0.255, 0.9, 0.32),
                    1);
}

// The motif larger than the sheet, headline on a dark foot: like a photograph cut tight.
void draw_close_poster(PosterSheet& sheet) {
  const Area a = sheet.area;
  const Color back{0.90, 0.91, 0.88}, foot{0.13, 0.13, 0.13};
  sheet.canvas.rectangle(a).fill(
      Paint::linear(0, 0, a.w, a.h, {{0, Color{0.98, 0.98, 0.96}}, {1, darker(back, 0.12)}}));
  draw_motif(sheet.canvas, sheet.motif, sheet.ink, a.part(-0.22, -0.02, 1.22, 0.80));
  sheet.canvas.rectangle(a.part(0, 0.76, 1, 1)).fill(foot);
  sheet.canvas.rectangle(a.part(0, 0.75, 1, 0.765)).fill(sheet.ink.primary);
  write_poster_line(sheet,
                    sheet.poster.headline,
                    {"Lato", 800},
                    Color{1, 1, 1},
                    a.part(0.07, 0.785, 0.93, 0.905),
                    1);
  write_poster_line(sheet,
                    sheet.poster.line,
                    {"Lato", 400},
                    Color{0.85, 0.85, 0.82},
                    a.part(0.09, 0.905, 0.91, 0.965),
                    1);
}

}  // namespace

const std::vector<Poster>& posters() {
  static const std::vector<Poster> rows{
#define POSTER(zone_type, motif, headline, line) {zone_type, motif, headline, line},
#include "assets/print/posters.inc"
#undef POSTER
  };
  return rows;
}

std::vector<const Poster*> posters_for(std::string_view zone_type) {
  std::vector<const Poster*> own, any;
  for (const Poster& poster : posters()) {
    if (poster.zone_type == zone_type) own.push_back(&poster);
    if (poster.zone_type.empty()) any.push_back(&poster);
  }
  return own.empty() ? any : own;
}

Result<Image> draw_poster(const Poster& poster,
                          std::string_view accent,
                          unsigned design,
                          int height_px) {
  if (height_px < min_poster_px || height_px > max_poster_px)
    return Error{"assets.bad_row", "poster", "a poster must be 64 to 4096 pixels high"};
  MARKETGEN_TRY(const LabelMotif* motif, find_motif(poster.motif, "posters.inc"));
  MARKETGEN_TRY(const Color house, parse_color(accent, "poster/accent"));
  const int width_px = static_cast<int>(std::lround(height_px * poster_aspect));
  Canvas canvas(width_px, height_px, Color{1, 1, 1});
  PosterSheet sheet{canvas,
                    poster,
                    *motif,
                    {house, lighter(house, 0.5), darker(house, 0.2)},
                    {0, 0, static_cast<double>(width_px), static_cast<double>(height_px)}};
  constexpr std::array<void (*)(PosterSheet&), designs> draw{
      draw_cream_poster, draw_disc_poster, draw_close_poster};
  draw[design % designs](sheet);
  return canvas.image();
}

}  // namespace marketgen::assets
