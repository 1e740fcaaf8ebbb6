// Fixtures of the layout picture: outline, front ticks, and a sign for what they are.
#include <algorithm>

#include "layout/picture_sheet.h"
#include "layout/side.h"

namespace marketgen::layout {
namespace {

constexpr int front_band_mm = 90;

assets::Color body_color(const Sheet& sheet,
                         const Fixture& fixture,
                         const catalog::FixtureKind* kind) {
  if (kind != nullptr && kind->role == catalog::FixtureRole::equipment)
    return assets::rgb("#d9d7d0");
  if (kind != nullptr && kind->role == catalog::FixtureRole::checkout)
    return assets::rgb("#8d99a6");
  return assets::blend(zone_color(sheet, fixture.zone), assets::rgb("#ffffff"), 0.12);
}

// A dark strip along the front and a small arrow out of it.
void draw_front(Sheet& sheet, const RectMm& rect, Side front, const assets::Color& color) {
  sheet.canvas.rectangle(sheet.area(strip_inside(rect, front, front_band_mm)));
  sheet.canvas.fill(assets::darker(color, 0.42));
  const Span line = along(rect, front);
  const double size = 75;  // mm
  const double middle = line.middle(), edge = coordinate(rect, front);
  const double out = front == Side::north || front == Side::east ? size : -size;
  std::vector<std::array<double, 2>> arrow;
  for (const auto& [along_mm, out_mm] :
       {std::pair{-size, 0.0}, std::pair{size, 0.0}, std::pair{0.0, out}}) {
    arrow.push_back(lies_along_x(front)
                        ? std::array{sheet.x(middle + along_mm), sheet.y(edge + out_mm)}
                        : std::array{sheet.x(edge + out_mm), sheet.y(middle + along_mm)});
  }
  sheet.canvas.polygon(arrow);
  sheet.canvas.fill(assets::darker(color, 0.42));
}

// The line along which a double-sided fixture stands back to back.
void draw_spine(Sheet& sheet, const RectMm& rect, Side front, const assets::Color& color) {
  const int depth = across(rect, front).length();
  sheet.canvas.rectangle(sheet.area(strip_inside(rect, front, 40, depth / 2 - 20)));
  sheet.canvas.fill(assets::darker(color, 0.35));
}

void draw_freezer_well(Sheet& sheet, const RectMm& rect, const assets::Color& color) {
  const assets::Area well = sheet.area(rect.grown(-180));
  if (well.w <= 0 || well.h <= 0) return;
  sheet.canvas.rounded(well, 2);
  sheet.canvas.fill_and_stroke(assets::lighter(color, 0.55), assets::darker(color, 0.3), 0.7);
}

// The belt at the shop's end beside the passage, the cashier's seat across from it. Which ends
// these are: assets/fixtures/checkout_lane.cpp.
void draw_lane(Sheet& sheet, const RectMm& rect, const Fixture& fixture) {
  const Side front = facing_of(fixture.yaw_deg);
  const bool deep = fixture.depth_mm > fixture.width_mm;
  const Side passage = deep ? opposite(left_of(front)) : front;
  const Side shop = deep ? opposite(front) : opposite(left_of(front));
  const int length = across(rect, shop).length(), width = across(rect, passage).length();
  const RectMm shop_end = strip_inside(rect, shop, length * 3 / 5, 90);
  sheet.canvas.rounded(sheet.area(strip_inside(shop_end, passage, width / 2 - 90, 90)), 2);
  sheet.canvas.fill(assets::rgb("#3f4650"));
  constexpr int seat_mm = 360;
  const RectMm till = strip_inside(rect, opposite(shop), seat_mm, length / 4);
  const assets::Area seat = sheet.area(strip_inside(till, opposite(passage), seat_mm, 120));
  sheet.canvas.circle(seat.center_x(), seat.center_y(), seat.w / 2);
  sheet.canvas.fill(assets::rgb("#eef1f4"));
}

void draw_fixture(Sheet& sheet, const Fixture& fixture) {
  const catalog::FixtureKind* kind = sheet.catalog.fixture_kind(fixture.kind);
  const assets::Color color = body_color(sheet, fixture, kind);
  const RectMm rect = footprint_of(fixture);
  const Side front = facing_of(fixture.yaw_deg);
  sheet.canvas.rectangle(sheet.area(rect));
  sheet.canvas.fill_and_stroke(color, assets::darker(color, 0.5), 0.9);
  const std::string generator = kind == nullptr ? "" : kind->generator;
  if (generator == "island_freezer" || generator == "chest_freezer" || generator == "bin") {
    draw_freezer_well(sheet, rect, color);
  }
  if (generator == "checkout_lane") {
    draw_lane(sheet, rect, fixture);
    return;
  }
  if (generator == "gate") return;
  if (fixture.sides == 2) draw_spine(sheet, rect, front, color);
  draw_front(sheet, rect, front, color);
  if (fixture.sides == 2) draw_front(sheet, rect, opposite(front), color);
}

}  // namespace

void draw_fixtures(Sheet& sheet) {
  for (const Fixture& fixture : sheet.layout.fixtures)
    draw_fixture(sheet, fixture);
}

}  // namespace marketgen::layout
