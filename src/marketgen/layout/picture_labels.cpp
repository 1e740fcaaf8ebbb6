// Lettering of the layout picture: zone names with their areas, and the widths of aisles. No two
// labels overlap.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "layout/aisles.h"
#include "layout/picture_sheet.h"
#include "layout/side.h"

namespace marketgen::layout {
namespace {

constexpr double step_px = 8;            // between tried places
constexpr int overhang_mm = 700;         // a label may reach this far out of a narrow zone
constexpr double off_center_cost = 0.9;  // against lying wholly on fixtures = 1
constexpr double upright_cost = 0.12;    // for turned lettering

struct LabelPlace {
  assets::Area area;
  bool upright = false;
  double size = 0;
  double cost = 0;
};

std::string area_text(double m2) {
  return m2 < 10 ? fmt::format("{:.1f} m²", m2) : fmt::format("{:.0f} m²", m2);
}

std::vector<assets::Area> fixture_areas(const Sheet& sheet) {
  std::vector<assets::Area> areas;
  for (const Fixture& fixture : sheet.layout.fixtures)
    areas.push_back(sheet.area(footprint_of(fixture)));
  return areas;
}

double covered_share(const assets::Area& a, const std::vector<assets::Area>& fixtures) {
  double covered = 0;
  for (const assets::Area& b : fixtures) {
    const double w = std::min(a.right(), b.right()) - std::max(a.x, b.x);
    const double h = std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y);
    if (w > 0 && h > 0) covered += w * h;
  }
  return covered / (a.w * a.h);
}

// The best free place for a box of w x h in the zone, if there is one.
std::optional<LabelPlace> best_place(const Sheet& sheet,
                                     const std::vector<assets::Area>& fixtures,
                                     const assets::Area& zone,
                                     double w,
                                     double h,
                                     bool upright,
                                     double size) {
  std::optional<LabelPlace> best;
  const double reach = sheet.px(overhang_mm);
  // Steps are counted from the zone's middle, so that the middle itself is tried.
  const int columns = static_cast<int>(((zone.w - w) / 2 + reach) / step_px);
  const int rows = static_cast<int>(((zone.h - h) / 2 + reach) / step_px);
  for (int row = -rows; row <= rows; ++row) {
    for (int column = -columns; column <= columns; ++column) {
      const double x = zone.center_x() - w / 2 + column * step_px,
                   y = zone.center_y() - h / 2 + row * step_px;
      const assets::Area area{x, y, w, h};
      if (area.x < sheet.plan.x || area.right() > sheet.plan.right() || area.y < sheet.plan.y ||
          area.bottom() > sheet.plan.bottom() || !sheet.is_free(area)) {
        continue;
      }
      const double dx = (area.center_x() - zone.center_x()) / std::max(zone.w, w);
      const double dy = (area.center_y() - zone.center_y()) / std::max(zone.h, h);
      const double cost = covered_share(area, fixtures) +
                          off_center_cost * (dx * dx + dy * dy) * 4 + (upright ? upright_cost : 0);
      if (!best || cost < best->cost - 1e-9) best = LabelPlace{area, upright, size, cost};
    }
  }
  return best;
}

std::optional<LabelPlace> place_of(const Sheet& sheet,
                                   const std::vector<assets::Area>& fixtures,
                                   const LayoutZone& zone) {
  const assets::Area area = sheet.area(bounds_of(zone.polygon_mm));
  for (const double size : {19.0, 16.0, 14.0, 12.0, 10.0, 8.5}) {
    const double w =
        std::max(type_width(zone.label, size), type_width(area_text(zone.area_m2), size * 0.75)) +
        0.9 * size;
    const double h = size * 2.35;
    const auto level = best_place(sheet, fixtures, area, w, h, false, size);
    const auto upright = best_place(sheet, fixtures, area, h, w, true, size);
    if (level && (!upright || level->cost <= upright->cost)) return level;
    if (upright) return upright;
  }
  return std::nullopt;
}

void draw_zone_label(Sheet& sheet, const LayoutZone& zone, const LabelPlace& place) {
  const assets::Color color = zone_color(sheet, zone.id);
  const auto saved = sheet.canvas.saved();
  const double w = place.upright ? place.area.h : place.area.w,
               h = place.upright ? place.area.w : place.area.h;
  sheet.canvas.translate(place.area.center_x(), place.area.center_y());
  if (place.upright) sheet.canvas.rotate(-1.5707963267948966);
  const assets::Area box{-w / 2, -h / 2, w, h};
  sheet.canvas.rounded(box.inset(1), 5);
  sheet.canvas.fill_and_stroke(assets::rgb("#ffffff"), assets::darker(color, 0.25), 1.1);
  const double pad = place.size * 0.3;
  letter(sheet,
         {box.x + pad, box.y + h * 0.06, w - 2 * pad, h * 0.54},
         zone.label,
         place.size,
         sheet_ink,
         700);
  letter(sheet,
         {box.x + pad, box.y + h * 0.57, w - 2 * pad, h * 0.36},
         area_text(zone.area_m2),
         place.size * 0.75,
         sheet_grey,
         500);
}

// A line across the aisle with a tick at either end, and the width in metres beside it.
bool draw_width(Sheet& sheet,
                const Aisle& aisle,
                double at_share,
                const std::vector<assets::Area>& fixtures) {
  const RectMm rect = bounds_of(aisle.polygon_mm);
  const bool along_x = runs_along_x(aisle);
  const std::string text = fmt::format("{:.2f}", aisle.width_mm * 1e-3);
  const double size = 11, w = type_width(text, size) + 4, h = size + 2;
  const assets::Area strip = sheet.area(rect);
  const double cx = along_x ? strip.x + strip.w * at_share : strip.center_x();
  const double cy = along_x ? strip.center_y() : strip.y + strip.h * at_share;
  const assets::Area box{along_x ? cx + 4 : cx - w / 2, along_x ? cy - h / 2 : cy - h - 3, w, h};
  if (!sheet.is_free(box.inset(-2)) || covered_share(box, fixtures) > 0) return false;
  const assets::Color ink = assets::rgb("#4a6fa5");
  const double half = (along_x ? strip.h : strip.w) / 2 - 2;
  const assets::Area line = along_x ? assets::Area{cx - 0.4, cy - half, 0.8, 2 * half}
                                    : assets::Area{cx - half, cy - 0.4, 2 * half, 0.8};
  sheet.canvas.rectangle(line);
  sheet.canvas.fill(ink);
  for (const double end : {-half, half}) {
    sheet.canvas.rectangle(along_x ? assets::Area{cx - 3.5, cy + end - 0.6, 7, 1.2}
                                   : assets::Area{cx + end - 0.6, cy - 3.5, 1.2, 7});
    sheet.canvas.fill(ink);
  }
  letter(sheet, box, text, size, ink, 700);
  sheet.take(box);
  return true;
}

}  // namespace

void draw_zone_labels(Sheet& sheet) {
  const std::vector<assets::Area> fixtures = fixture_areas(sheet);
  // Small zones first: they have the fewest places to go.
  std::vector<const LayoutZone*> zones;
  for (const LayoutZone& zone : sheet.layout.zones)
    zones.push_back(&zone);
  std::ranges::stable_sort(zones, {}, [](const LayoutZone* zone) { return zone->area_m2; });
  for (const LayoutZone* zone : zones) {
    if (zone->polygon_mm.empty() || zone->label.empty()) continue;
    const auto place = place_of(sheet, fixtures, *zone);
    if (!place) continue;
    draw_zone_label(sheet, *zone, *place);
    sheet.take(place->area);
  }
}

void draw_aisle_widths(Sheet& sheet) {
  constexpr int min_length_mm = 1500, widest_mm = 4800;
  const std::vector<assets::Area> fixtures = fixture_areas(sheet);
  for (const Aisle& aisle : sheet.layout.aisles) {
    const RectMm rect = bounds_of(aisle.polygon_mm);
    if (std::max(rect.width(), rect.depth()) < min_length_mm || aisle.width_mm > widest_mm)
      continue;
    for (const double share : {0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9}) {
      if (draw_width(sheet, aisle, share, fixtures)) break;
    }
  }
}

}  // namespace marketgen::layout
