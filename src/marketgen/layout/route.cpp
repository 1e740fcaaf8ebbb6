#include "layout/route.h"

#include <algorithm>

#include "layout/floor.h"
#include "layout/reach.h"
#include "layout/side.h"

namespace marketgen::layout {
namespace {

constexpr int route_cell_mm = 100;
constexpr int beside_lane_mm = 500;  // the middle of the passage
constexpr int queue_mm = 700;        // before the belt
constexpr int inside_door_mm = 900;  // from the door's line to where the way begins

PointMm inside(const Doorway& door) {
  PointMm p = door.threshold;
  switch (door.wall) {
    case Side::south:
      p[1] += inside_door_mm;
      break;
    case Side::north:
      p[1] -= inside_door_mm;
      break;
    case Side::west:
      p[0] += inside_door_mm;
      break;
    case Side::east:
      p[0] -= inside_door_mm;
      break;
  }
  return p;
}

}  // namespace

std::vector<PayingPlace> paying_places(const Layout& layout, const catalog::Catalog& catalog) {
  std::vector<PayingPlace> places;
  for (const Fixture& fixture : layout.fixtures) {
    const catalog::FixtureKind* kind = catalog.fixture_kind(fixture.kind);
    if (kind == nullptr || kind->role != catalog::FixtureRole::checkout) continue;
    const RectMm rect = footprint_of(fixture);
    const Side front = facing_of(fixture.yaw_deg);
    if (kind->generator != "checkout_lane") {
      const RectMm before = strip_beyond(rect, front, 2 * beside_lane_mm);
      places.push_back({before.center(), before.center(), fixture.id, before});
      continue;
    }
    // As assets/fixtures/checkout_lane.cpp has it: a lane deeper than wide is passed on its right
    // (+X) from its back (+Y), a wider one at its front from its right.
    const bool deep = fixture.depth_mm > fixture.width_mm;
    const Side passage = deep ? opposite(left_of(front)) : front;
    const Side shop = deep ? opposite(front) : opposite(left_of(front));
    const RectMm beside = strip_beyond(rect, passage, 2 * beside_lane_mm);
    places.push_back(
        {strip_beyond(beside, shop, 2 * queue_mm).center(), beside.center(), fixture.id, beside});
  }
  return places;
}

Route shopper_route(const Layout& layout, const catalog::Catalog& catalog) {
  Route route;
  const Floor floor = make_floor(layout.shell);
  const Doorway* entrance = entrance_of(floor, layout.shell);
  const Doorway* exit = exit_of(floor, layout.shell);
  if (entrance == nullptr || exit == nullptr) return route;
  std::vector<RectMm> obstacles = floor.columns;
  for (const Fixture& fixture : layout.fixtures)
    obstacles.push_back(footprint_of(fixture));
  const navigation::OccupancyGrid grid =
      navigation::make_occupancy(floor.outline, obstacles, person_width_mm / 2, route_cell_mm);
  double shortest_m = 0;
  for (const PayingPlace& place : paying_places(layout, catalog)) {
    const auto in = navigation::shortest_path(grid, inside(*entrance), place.queue);
    const auto past = navigation::shortest_path(grid, place.queue, place.till);
    const auto out = navigation::shortest_path(grid, place.till, inside(*exit));
    if (!in || !past || !out) continue;
    const double length_m = in->length_m + past->length_m + out->length_m;
    if (route.complete && length_m >= shortest_m) continue;
    route = {{*in, *past, *out}, true};
    shortest_m = length_m;
  }
  return route;
}

}  // namespace marketgen::layout
