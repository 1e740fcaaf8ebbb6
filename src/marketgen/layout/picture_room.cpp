// Floor, walls, doors and windows of the layout picture.
#include <algorithm>
#include <cmath>

#include "layout/floor.h"
#include "layout/picture_sheet.h"

namespace marketgen::layout {
namespace {

// Thickness of the walls, drawn outside the floor; thinner in small rooms, whose sheets are drawn
// large.
double wall_mm(const Sheet& sheet) {
  constexpr double usual_mm = 220, max_px = 16;
  return std::min(usual_mm, max_px / sheet.px_per_mm);
}

constexpr int tick_every_mm = 1000, number_every_mm = 5000;

// The part of the wall that the opening takes, drawn outside the floor.
RectMm wall_part(const Sheet& sheet, const Doorway& door) {
  return cut_along(strip_beyond(sheet.bounds, door.wall, static_cast<int>(wall_mm(sheet))),
                   door.wall,
                   door.span);
}

void draw_grid(Sheet& sheet) {
  const assets::Color line = assets::faded(sheet_grey, 0.13);
  for (int x = tick_every_mm; x < sheet.bounds.x1; x += tick_every_mm) {
    sheet.canvas.rectangle(
        {sheet.x(x), sheet.plan.y, x % number_every_mm == 0 ? 1.1 : 0.5, sheet.plan.h});
    sheet.canvas.fill(line);
  }
  for (int y = tick_every_mm; y < sheet.bounds.y1; y += tick_every_mm) {
    sheet.canvas.rectangle(
        {sheet.plan.x, sheet.y(y), sheet.plan.w, y % number_every_mm == 0 ? 1.1 : 0.5});
    sheet.canvas.fill(line);
  }
}

void draw_scale_numbers(Sheet& sheet) {
  const double off = sheet.px(wall_mm(sheet)) + 5;
  for (int x = 0; x <= sheet.bounds.x1; x += number_every_mm) {
    letter(sheet,
           {sheet.x(x) - 25, sheet.plan.y - off - 15, 50, 13},
           std::to_string(x / 1000) + " m",
           11,
           sheet_grey);
  }
  for (int y = 0; y <= sheet.bounds.y1; y += number_every_mm) {
    letter(sheet,
           {sheet.plan.x - off - 42, sheet.y(y) - 7, 40, 13},
           std::to_string(y / 1000) + " m",
           11,
           sheet_grey,
           500,
           assets::Align::right);
  }
}

// A leaf at each end of the opening, each half as wide, standing open outward with the arc it
// sweeps.
void draw_swing_doors(Sheet& sheet, const Doorway& door) {
  cairo_t* cairo = sheet.canvas.context();
  const double leaf = sheet.px(door.span.length()) / 2;
  const bool x = lies_along_x(door.wall);
  const double outward = door.wall == Side::north || door.wall == Side::west ? -1 : 1;
  for (const int end : {door.span.from, door.span.to}) {
    const double toward = (end == door.span.from ? 1 : -1) * (x ? 1 : -1);
    const double hx = x ? sheet.x(end) : sheet.x(coordinate(sheet.bounds, door.wall));
    const double hy = x ? sheet.y(coordinate(sheet.bounds, door.wall)) : sheet.y(end);
    const double tip_x = x ? hx : hx + outward * leaf, tip_y = x ? hy + outward * leaf : hy;
    const double shut_x = x ? hx + toward * leaf : hx, shut_y = x ? hy : hy + toward * leaf;
    cairo_set_line_width(cairo, 1.6);
    cairo_set_source_rgb(cairo, sheet_wall.r, sheet_wall.g, sheet_wall.b);
    cairo_move_to(cairo, hx, hy);
    cairo_line_to(cairo, tip_x, tip_y);
    cairo_stroke(cairo);
    cairo_set_line_width(cairo, 0.7);
    constexpr double round = 0.5523;  // control distance of a quarter circle
    cairo_move_to(cairo, tip_x, tip_y);
    cairo_curve_to(cairo,
                   tip_x + (shut_x - hx) * round,
                   tip_y + (shut_y - hy) * round,
                   shut_x + (tip_x - hx) * round,
                   shut_y + (tip_y - hy) * round,
                   shut_x,
                   shut_y);
    cairo_stroke(cairo);
  }
}

// Two glass panes, slid half open.
void draw_sliding_doors(Sheet& sheet, const Doorway& door) {
  const RectMm gap = wall_part(sheet, door);
  const Span span = along(gap, door.wall);
  const int pane = span.length() / 4;
  for (const Span& glass : {Span{span.from, span.from + pane}, Span{span.to - pane, span.to}}) {
    const RectMm whole = cut_along(gap, door.wall, glass);
    const RectMm thin = strip_inside(whole, door.wall, 50, 85);
    sheet.canvas.rectangle(sheet.area(thin));
    sheet.canvas.fill_and_stroke(assets::rgb("#9cc9de"), sheet_wall, 0.8);
  }
}

void draw_opening(Sheet& sheet, const Doorway& door) {
  const plan::Opening& opening = sheet.layout.shell.openings[door.opening];
  const assets::Area gap = sheet.area(wall_part(sheet, door));
  sheet.canvas.rectangle(gap);
  sheet.canvas.fill(opening.kind == plan::OpeningKind::window ? assets::rgb("#cfe3ec")
                                                              : sheet_paper);
  if (opening.kind == plan::OpeningKind::window) {
    sheet.canvas.rectangle(gap);
    sheet.canvas.stroke(sheet_wall, 1);
  } else if (opening.kind == plan::OpeningKind::entrance ||
             opening.kind == plan::OpeningKind::exit) {
    draw_sliding_doors(sheet, door);
  } else {
    draw_swing_doors(sheet, door);
  }
}

}  // namespace

void draw_floor(Sheet& sheet) {
  add_polygon(sheet, *sheet.layout.shell.outline_mm);
  sheet.canvas.fill(assets::rgb("#ffffff"));
  const auto saved = sheet.canvas.saved();
  add_polygon(sheet, *sheet.layout.shell.outline_mm);
  sheet.canvas.clip();
  draw_grid(sheet);
  for (const LayoutZone& zone : sheet.layout.zones) {
    const assets::Color color = zone_color(sheet, zone.id);
    add_polygon(sheet, zone.polygon_mm);
    sheet.canvas.fill(assets::faded(color, 0.30));
    cairo_set_dash(sheet.canvas.context(), std::array{7.0, 4.0}.data(), 2, 0);
    add_polygon(sheet, zone.polygon_mm);
    sheet.canvas.stroke(assets::faded(assets::darker(color, 0.25), 0.8), 1.1);
    cairo_set_dash(sheet.canvas.context(), nullptr, 0, 0);
  }
}

void draw_walls(Sheet& sheet) {
  cairo_t* cairo = sheet.canvas.context();
  {
    // A thick line of which the floor covers the inner half.
    const auto saved = sheet.canvas.saved();
    cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
    sheet.canvas.rectangle({0,
                            0,
                            static_cast<double>(sheet.canvas.width_px()),
                            static_cast<double>(sheet.canvas.height_px())});
    add_polygon(sheet, *sheet.layout.shell.outline_mm);
    sheet.canvas.clip();
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_MITER);
    add_polygon(sheet, *sheet.layout.shell.outline_mm);
    sheet.canvas.stroke(sheet_wall, 2 * sheet.px(wall_mm(sheet)));
  }
  const Floor floor = make_floor(sheet.layout.shell);
  for (const Doorway& door : floor.doorways)
    draw_opening(sheet, door);
  for (const RectMm& column : floor.columns) {
    sheet.canvas.rectangle(sheet.area(column));
    sheet.canvas.fill_and_stroke(sheet_wall, sheet_ink, 1);
  }
  draw_scale_numbers(sheet);
}

void draw_opening_labels(Sheet& sheet) {
  const Floor floor = make_floor(sheet.layout.shell);
  for (const Doorway& door : floor.doorways) {
    const plan::Opening& opening = sheet.layout.shell.openings[door.opening];
    if (opening.kind == plan::OpeningKind::window) continue;
    std::string text(name_of(opening.kind));
    std::ranges::transform(text, text.begin(), [](char c) {
      return static_cast<char>(c >= 'a' && c <= 'z' ? c - 32 : c);
    });
    const bool x = lies_along_x(door.wall);
    const bool swings =
        opening.kind == plan::OpeningKind::service || opening.kind == plan::OpeningKind::emergency;
    const double off =
        sheet.px(wall_mm(sheet)) + 4 + (swings ? sheet.px(door.span.length()) / 2 : 0);
    const double cx = sheet.x(door.threshold[0]), cy = sheet.y(door.threshold[1]);
    const double w = type_width(text, 13) + 16, h = 16;
    assets::Area area{cx - w / 2, cy + off, w, h};
    if (door.wall == Side::north) area.y = cy - off - h;
    if (!x) {
      const auto saved = sheet.canvas.saved();
      sheet.canvas.translate(cx + (door.wall == Side::east ? off + h / 2 : -off - h / 2), cy);
      sheet.canvas.rotate(-1.5707963267948966);
      sheet.canvas.rectangle({-w / 2, -h / 2, w, h});
      sheet.canvas.fill(sheet_paper);
      letter(sheet, {-w / 2, -h / 2, w, h}, text, 13, sheet_ink, 700);
      continue;
    }
    sheet.canvas.rectangle(area);
    sheet.canvas.fill(sheet_paper);
    letter(sheet, area, text, 13, sheet_ink, 700);
  }
}

}  // namespace marketgen::layout
