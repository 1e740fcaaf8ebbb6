#include "layout/layout.h"

#include <algorithm>

#include "layout/side.h"

namespace marketgen::layout {

RectMm footprint_of(const Fixture& fixture) {
  const bool along_x = lies_along_x(facing_of(fixture.yaw_deg));
  const int wide = along_x ? fixture.width_mm : fixture.depth_mm;
  const int deep = along_x ? fixture.depth_mm : fixture.width_mm;
  const int x0 = fixture.x_mm - wide / 2, y0 = fixture.y_mm - deep / 2;
  return {x0, y0, x0 + wide, y0 + deep};
}

const Fixture* find_fixture(const Layout& layout, std::string_view id) {
  const auto found = std::ranges::find(layout.fixtures, id, &Fixture::id);
  return found == layout.fixtures.end() ? nullptr : &*found;
}

const LayoutZone* find_zone(const Layout& layout, std::string_view id) {
  const auto found = std::ranges::find(layout.zones, id, &LayoutZone::id);
  return found == layout.zones.end() ? nullptr : &*found;
}

}  // namespace marketgen::layout
