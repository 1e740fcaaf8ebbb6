// The sheet of a layout picture: from store millimetres to pixels, the palette, and places that are
// taken by lettering.
#pragma once
#include <string>
#include <vector>

#include "assets/print/canvas.h"
#include "assets/print/lettering.h"
#include "layout/layout.h"

namespace marketgen::layout {

constexpr assets::Color sheet_paper = assets::rgb("#f7f5f0");
constexpr assets::Color sheet_ink = assets::rgb("#23282d");
constexpr assets::Color sheet_grey = assets::rgb("#7b8187");
constexpr assets::Color sheet_wall = assets::rgb("#3a4046");
constexpr assets::Color sheet_route = assets::rgb("#d1495b");
constexpr assets::Color sheet_alarm = assets::rgb("#c1121f");

struct Sheet {
  assets::Canvas& canvas;
  const Layout& layout;
  const catalog::Catalog& catalog;
  RectMm bounds;      // of the room
  assets::Area plan;  // where the room is drawn, pixels
  double px_per_mm = 1;
  std::vector<assets::Area> taken;  // by lettering

  double x(double mm) const { return plan.x + (mm - bounds.x0) * px_per_mm; }
  double y(double mm) const { return plan.bottom() - (mm - bounds.y0) * px_per_mm; }
  double px(double mm) const { return mm * px_per_mm; }
  assets::Area area(const RectMm& rect) const {
    return {x(rect.x0), y(rect.y1), px(rect.width()), px(rect.depth())};
  }
  bool is_free(const assets::Area& area) const;
  void take(const assets::Area& area) { taken.push_back(area); }
};

assets::Color zone_color(const Sheet& sheet, std::string_view zone_id);
void add_polygon(Sheet& sheet, const PolygonMm& polygon);

// Text drawn at a size in pixels within the area; smaller where it would not fit.
void letter(Sheet& sheet,
            const assets::Area& area,
            const std::string& text,
            double size,
            const assets::Color& color,
            int weight = 500,
            assets::Align align = assets::Align::center);
// A cautious guess at the width of a line of type.
double type_width(std::string_view text, double size);

// Parts of the picture, from the floor up.
void draw_floor(Sheet& sheet);
void draw_walls(Sheet& sheet);
void draw_fixtures(Sheet& sheet);
void draw_route(Sheet& sheet);
void draw_violations(Sheet& sheet);
void draw_zone_labels(Sheet& sheet);
void draw_opening_labels(Sheet& sheet);
void draw_aisle_widths(Sheet& sheet);

}  // namespace marketgen::layout
