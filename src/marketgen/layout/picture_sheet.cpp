#include "layout/picture_sheet.h"

#include <algorithm>

namespace marketgen::layout {
namespace {

constexpr double mean_letter_em = 0.56;  // Lato Bold, mixed case, a little generous

}  // namespace

bool Sheet::is_free(const assets::Area& a) const {
  return std::ranges::none_of(taken, [&](const assets::Area& b) {
    return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
  });
}

assets::Color zone_color(const Sheet& sheet, std::string_view zone_id) {
  const LayoutZone* zone = find_zone(sheet.layout, zone_id);
  const catalog::ZoneTypeRow* type =
      zone == nullptr ? nullptr : sheet.catalog.zone_type(zone->type);
  if (type == nullptr) return assets::rgb("#b0b0b0");
  const Result<assets::Color> color = assets::parse_color(type->color, type->type);
  return color.ok() ? *color : assets::rgb("#b0b0b0");
}

void add_polygon(Sheet& sheet, const PolygonMm& polygon) {
  std::vector<std::array<double, 2>> points;
  for (const PointMm& p : polygon)
    points.push_back({sheet.x(p[0]), sheet.y(p[1])});
  sheet.canvas.polygon(points);
}

double type_width(std::string_view text, double size) {
  // Bytes that continue a UTF-8 letter take no room.
  const auto letters = std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; });
  return size * mean_letter_em * static_cast<double>(letters);
}

void letter(Sheet& sheet,
            const assets::Area& area,
            const std::string& text,
            double size,
            const assets::Color& color,
            int weight,
            assets::Align align) {
  assets::Headline line;
  line.text = text;
  line.face.weight = weight;
  line.color = color;
  line.area = area;
  line.align = align;
  line.max_size = size;
  assets::draw_headline(sheet.canvas, line);
}

}  // namespace marketgen::layout
