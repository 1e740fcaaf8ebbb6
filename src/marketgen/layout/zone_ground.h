// The floor each zone really has: rectangles on which its fixtures may stand, their walls and their
// neighbours.
#pragma once
#include <array>
#include <vector>

#include "geometry/rectangle.h"
#include "layout/design.h"
#include "layout/floor.h"
#include "layout/layout.h"
#include "plan/plan.h"

namespace marketgen::layout {

// A rectangular piece of a zone. A zone has one, or up to three where the outline cuts into it.
struct Ground {
  std::size_t zone = 0;  // index into Plan::zones
  RectMm rect;
  std::array<std::vector<Span>, 4>
      walls;  // by side: where a wall stands behind it, half the gaps to neighbours included
  std::array<int, 4> gap_mm{};  // by side: to the next piece of a zone or the wall beyond it
  bool touches_wall(Side side) const { return !walls[index_of(side)].empty(); }
};

// In the order of the plan's zones; zones without a usable piece are missing. Precondition: valid
// plan.
std::vector<Ground> zone_grounds(const plan::Plan& plan, const Floor& floor);

// The zone's floor for pictures and areas: its BSP rectangle clipped to the outline.
PolygonMm zone_polygon(const RectMm& rect, const Floor& floor);

// The zones of the plan's layout, in the plan's order. Precondition: valid plan.
std::vector<LayoutZone> layout_zones(const Design& design);

}  // namespace marketgen::layout
