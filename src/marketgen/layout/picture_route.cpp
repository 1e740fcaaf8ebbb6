// The shopper's way through the shop, and the broken rules, on the layout picture.
#include <algorithm>
#include <cmath>

#include "layout/floor.h"
#include "layout/picture_sheet.h"
#include "layout/route.h"

namespace marketgen::layout {
namespace {

void draw_arrow(Sheet& sheet, double x, double y, double dx, double dy) {
  const double length = std::sqrt(dx * dx + dy * dy);
  if (length <= 0) return;
  const double ux = dx / length * 6, uy = dy / length * 6;
  sheet.canvas.polygon({{x + ux, y + uy},
                        {x - ux - 0.7 * uy, y - uy + 0.7 * ux},
                        {x - ux + 0.7 * uy, y - uy - 0.7 * ux}});
  sheet.canvas.fill(sheet_route);
}

void draw_leg(Sheet& sheet, const navigation::GridPath& path) {
  cairo_t* cairo = sheet.canvas.context();
  const std::array dash{9.0, 5.0};
  cairo_set_dash(cairo, dash.data(), 2, 0);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const double x = sheet.x(path.points[i][0]), y = sheet.y(path.points[i][1]);
    if (i == 0) {
      cairo_move_to(cairo, x, y);
    } else {
      cairo_line_to(cairo, x, y);
    }
  }
  sheet.canvas.stroke(assets::faded(sheet_route, 0.85), 2.2);
  cairo_set_dash(cairo, nullptr, 0, 0);
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    const PointMm a = path.points[i], b = path.points[i + 1];
    const double dx = sheet.px(b[0] - a[0]), dy = -sheet.px(b[1] - a[1]);
    if (dx * dx + dy * dy < 40 * 40) continue;
    draw_arrow(sheet, sheet.x((a[0] + b[0]) / 2), sheet.y((a[1] + b[1]) / 2), dx, dy);
  }
}

// Diagonal lines over the place, and the rule's number in a disc.
void draw_mark(Sheet& sheet, const assets::Area& place, int number) {
  {
    const auto saved = sheet.canvas.saved();
    sheet.canvas.rectangle(place);
    sheet.canvas.clip();
    cairo_t* cairo = sheet.canvas.context();
    for (double x = place.x - place.h; x < place.right(); x += 9) {
      cairo_move_to(cairo, x, place.bottom());
      cairo_line_to(cairo, x + place.h, place.y);
    }
    sheet.canvas.stroke(assets::faded(sheet_alarm, 0.55), 1.3);
  }
  sheet.canvas.rectangle(place);
  sheet.canvas.stroke(sheet_alarm, 1.4);
  const double radius = 10;
  const double x = std::clamp(place.center_x(), sheet.plan.x + radius, sheet.plan.right() - radius);
  const double y =
      std::clamp(place.center_y(), sheet.plan.y + radius, sheet.plan.bottom() - radius);
  sheet.canvas.circle(x, y, radius);
  sheet.canvas.fill_and_stroke(sheet_alarm, assets::rgb("#ffffff"), 1.5);
  letter(sheet,
         {x - radius, y - 7, 2 * radius, 14},
         std::to_string(number),
         12,
         assets::rgb("#ffffff"),
         800);
  sheet.take({x - radius, y - radius, 2 * radius, 2 * radius});
}

assets::Area place_of(const Sheet& sheet, const Violation& violation) {
  if (const Fixture* fixture = find_fixture(sheet.layout, violation.where))
    return sheet.area(footprint_of(*fixture));
  for (const Aisle& aisle : sheet.layout.aisles) {
    if (aisle.id == violation.where) return sheet.area(bounds_of(aisle.polygon_mm));
  }
  const PointMm at = violation.at_mm.value_or(sheet.bounds.center());
  return {sheet.x(at[0]) - 14, sheet.y(at[1]) - 14, 28, 28};
}

}  // namespace

void draw_route(Sheet& sheet) {
  const Route route = shopper_route(sheet.layout, sheet.catalog);
  for (const navigation::GridPath& leg : route.legs)
    draw_leg(sheet, leg);
}

void draw_violations(Sheet& sheet) {
  int number = 0;
  for (const Violation& violation : sheet.layout.violations)
    draw_mark(sheet, place_of(sheet, violation), ++number);
}

}  // namespace marketgen::layout
