#include "layout/layout_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "layout/picture_sheet.h"

namespace marketgen::layout {
namespace {

constexpr double side_margin = 78, header = 110, footer = 86;  // pixels at the usual size
constexpr double violation_line = 17;
constexpr double key_width = 470;
constexpr int max_listed = 8;

struct Page {
  int width = 0, height = 0;
  assets::Area plan;
  double px_per_mm = 1;
  double swing_below = 0;  // room for doors that open southwards
};

double list_height(const Layout& layout) {
  const auto count = std::min<std::size_t>(layout.violations.size(), max_listed + 1);
  return layout.violations.empty() ? 0 : violation_line * static_cast<double>(count) + 14;
}

// How far the leaves of a wall's doors swing out of the room.
int swing_mm(const Layout& layout, plan::Wall wall) {
  int widest = 0;
  for (const plan::Opening& opening : layout.shell.openings) {
    const bool swings =
        opening.kind == plan::OpeningKind::service || opening.kind == plan::OpeningKind::emergency;
    if (swings && opening.wall == wall) widest = std::max(widest, opening.width_mm);
  }
  return widest / 2;
}

// The longer side of the page is `size_px`; the room takes what margins and lettering leave.
Page make_page(const Layout& layout, const RectMm& room, int size_px) {
  const int above_mm = swing_mm(layout, plan::Wall::north),
            below_mm = swing_mm(layout, plan::Wall::south);
  const double lettering = header + footer + list_height(layout);
  const double by_width = (size_px - 2 * side_margin) / room.width();
  const double by_height = (size_px - lettering) / (room.depth() + above_mm + below_mm);
  Page page;
  page.px_per_mm = std::min(by_width, by_height);
  page.swing_below = below_mm * page.px_per_mm;
  const double above = above_mm * page.px_per_mm;
  const double vertical = lettering + above + page.swing_below;
  const double w = room.width() * page.px_per_mm, h = room.depth() * page.px_per_mm;
  page.width = static_cast<int>(w + 2 * side_margin + 0.5);
  page.height = static_cast<int>(h + vertical + 0.5);
  page.plan = {side_margin, header + above, w, h};
  return page;
}

void draw_title(Sheet& sheet) {
  const Layout& layout = sheet.layout;
  const catalog::ProfileRow* profile = sheet.catalog.profile(layout.profile);
  const double w = sheet.canvas.width_px() - 2 * side_margin - 60;
  letter(sheet, {side_margin, 14, w, 32}, layout.name, 26, sheet_ink, 800, assets::Align::left);
  double zones_m2 = 0;
  for (const LayoutZone& zone : layout.zones)
    zones_m2 += zone.area_m2;
  const std::string facts = fmt::format(
      "{}  ·  {:.1f} × {:.1f} m  ·  {:.0f} m²  ·  {} zones on {:.0f} m²  ·  {} fixture modules",
      profile != nullptr ? profile->name : layout.profile,
      layout.shell.width_mm * 1e-3,
      layout.shell.depth_mm * 1e-3,
      area_m2(*layout.shell.outline_mm),
      layout.zones.size(),
      zones_m2,
      layout.fixtures.size());
  letter(sheet, {side_margin, 46, w, 20}, facts, 14, sheet_grey, 500, assets::Align::left);
}

void draw_north(Sheet& sheet) {
  const double x = sheet.canvas.width_px() - side_margin - 20, y = 38;
  sheet.canvas.circle(x, y, 20);
  sheet.canvas.stroke(sheet_ink, 1.2);
  sheet.canvas.polygon({{x, y - 17}, {x + 7, y + 10}, {x, y + 5}});
  sheet.canvas.fill(sheet_ink);
  sheet.canvas.polygon({{x, y - 17}, {x - 7, y + 10}, {x, y + 5}});
  sheet.canvas.fill_and_stroke(assets::rgb("#ffffff"), sheet_ink, 0.8);
  letter(sheet, {x - 44, y - 9, 18, 18}, "N", 15, sheet_ink, 800);
}

void draw_scale_bar(Sheet& sheet, double top) {
  // Four parts of 1, 2 or 5 m that stay clear of the key on the right.
  const double room = sheet.canvas.width_px() - 2 * side_margin - key_width - 40;
  int step_mm = 1000;
  for (const int longer : {2000, 5000}) {
    if (4 * sheet.px(longer) <= room) step_mm = longer;
  }
  const double step = sheet.px(step_mm);
  for (int i = 0; i < 4; ++i) {
    sheet.canvas.rectangle({side_margin + i * step, top, step, 7});
    sheet.canvas.fill_and_stroke(i % 2 == 0 ? sheet_ink : assets::rgb("#ffffff"), sheet_ink, 1);
  }
  for (int i = 0; i <= 4; i += 2) {
    letter(sheet,
           {side_margin + i * step - 25, top + 9, 50, 14},
           fmt::format("{} m", i * step_mm / 1000),
           12,
           sheet_ink);
  }
}

void draw_key(Sheet& sheet, double top) {
  const double right = sheet.canvas.width_px() - side_margin;
  const double x = right - key_width;
  sheet.canvas.rectangle({x, top + 2, 22, 2});
  sheet.canvas.fill(sheet_route);
  letter(sheet,
         {x + 28, top - 5, 190, 16},
         "entrance – checkout – exit",
         12,
         sheet_ink,
         500,
         assets::Align::left);
  sheet.canvas.rectangle({x + 222, top - 2, 16, 10});
  sheet.canvas.fill_and_stroke(assets::rgb("#dfe3e6"), sheet_ink, 0.8);
  sheet.canvas.rectangle({x + 222, top + 6, 16, 2.5});
  sheet.canvas.fill(sheet_ink);
  letter(sheet,
         {x + 244, top - 5, 100, 16},
         "fixture, front",
         12,
         sheet_ink,
         500,
         assets::Align::left);
  sheet.canvas.rectangle({x + 350, top + 2.6, 20, 0.9});
  sheet.canvas.fill(assets::rgb("#4a6fa5"));
  letter(
      sheet, {x + 376, top - 5, 94, 16}, "free width, m", 12, sheet_ink, 500, assets::Align::left);
}

void draw_violation_list(Sheet& sheet, double top) {
  const double w = sheet.canvas.width_px() - 2 * side_margin;
  const auto count = sheet.layout.violations.size();
  for (std::size_t i = 0; i < std::min<std::size_t>(count, max_listed); ++i) {
    const Violation& v = sheet.layout.violations[i];
    const std::string text =
        fmt::format("{}  {} ({}): {}", i + 1, v.code, name_of(v.severity), v.message);
    letter(sheet,
           {side_margin, top, w, violation_line},
           text,
           12.5,
           v.severity == Severity::hard ? sheet_alarm : sheet_ink,
           500,
           assets::Align::left);
    top += violation_line;
  }
  if (count > max_listed) {
    letter(sheet,
           {side_margin, top, w, violation_line},
           fmt::format("and {} more", count - max_listed),
           12.5,
           sheet_grey,
           500,
           assets::Align::left);
  }
}

}  // namespace

Image draw_layout(const Layout& layout, const catalog::Catalog& catalog, int size_px) {
  const RectMm room{0, 0, layout.shell.width_mm, layout.shell.depth_mm};
  const Page page = make_page(layout, room, size_px);
  assets::Canvas canvas(page.width, page.height, sheet_paper);
  Sheet sheet{canvas, layout, catalog, room, page.plan, page.px_per_mm, {}};
  draw_floor(sheet);
  draw_walls(sheet);
  draw_fixtures(sheet);
  draw_route(sheet);
  draw_violations(sheet);
  draw_zone_labels(sheet);
  draw_aisle_widths(sheet);
  draw_opening_labels(sheet);
  draw_title(sheet);
  draw_north(sheet);
  const double below = page.plan.bottom() + page.swing_below + 46;
  draw_scale_bar(sheet, below);
  draw_key(sheet, below + 2);
  draw_violation_list(sheet, below + 32);
  return canvas.image();
}

}  // namespace marketgen::layout
