#include "layout/visual_prompt.h"

#include <fmt/format.h>

#include <algorithm>

#include "layout/picture_sheet.h"

namespace marketgen::layout {
namespace {

constexpr double margin_px = 56;
constexpr int dots_a_side = 5;
constexpr double mark_px = 13, dot_px = 3;

// The room in the middle of a square sheet.
Sheet square_sheet(assets::Canvas& canvas, const Layout& layout, const catalog::Catalog& catalog) {
  const RectMm room{0, 0, layout.shell.width_mm, layout.shell.depth_mm};
  const double free_px = visual_prompt_px - 2 * margin_px;
  const double px_per_mm = free_px / std::max(room.width(), room.depth());
  const double w = room.width() * px_per_mm, h = room.depth() * px_per_mm;
  const assets::Area plan{(visual_prompt_px - w) / 2, (visual_prompt_px - h) / 2, w, h};
  return {canvas, layout, catalog, room, plan, px_per_mm, {}};
}

void draw_zone_marks(Sheet& sheet) {
  for (std::size_t i = 0; i < sheet.layout.zones.size(); ++i) {
    const assets::Area zone = sheet.area(bounds_of(sheet.layout.zones[i].polygon_mm));
    const assets::Area mark{
        zone.center_x() - mark_px, zone.center_y() - mark_px, 2 * mark_px, 2 * mark_px};
    sheet.canvas.rounded(mark, 4);
    sheet.canvas.fill_and_stroke(sheet_ink, assets::rgb("#ffffff"), 1.5);
    letter(sheet, mark, std::string(1, mark_of_zone(i)), 17, assets::rgb("#ffffff"), 800);
    sheet.take(mark);
  }
}

void draw_dots(Sheet& sheet) {
  for (int row = 0; row < dots_a_side; ++row) {
    for (int column = 0; column < dots_a_side; ++column) {
      const double x_mm = sheet.bounds.width() * (column + 0.5) / dots_a_side;
      const double y_mm = sheet.bounds.depth() * (row + 0.5) / dots_a_side;
      const double x = sheet.x(x_mm), y = sheet.y(y_mm);
      sheet.canvas.circle(x, y, dot_px);
      sheet.canvas.fill(sheet_ink);
      letter(sheet,
             {x - 34, y + 4, 68, 13},
             fmt::format("{:.1f}, {:.1f}", x_mm * 1e-3, y_mm * 1e-3),
             10.5,
             sheet_ink);
    }
  }
}

}  // namespace

char mark_of_zone(std::size_t index) {
  constexpr std::size_t letters = 26;
  return index < letters ? static_cast<char>('A' + index) : '?';
}

Image draw_visual_prompt(const Layout& layout, const catalog::Catalog& catalog) {
  assets::Canvas canvas(visual_prompt_px, visual_prompt_px, sheet_paper);
  Sheet sheet = square_sheet(canvas, layout, catalog);
  draw_floor(sheet);
  draw_walls(sheet);
  draw_fixtures(sheet);
  draw_route(sheet);
  draw_zone_marks(sheet);
  draw_violations(sheet);
  draw_aisle_widths(sheet);
  draw_opening_labels(sheet);
  draw_dots(sheet);
  return canvas.image();
}

}  // namespace marketgen::layout
