#include "layout/floor_guard.h"

#include <algorithm>

#include "layout/aisles.h"
#include "layout/side.h"

namespace marketgen::layout {
namespace {

constexpr int detour_mm = 1500;  // a way round that is longer is no way round
constexpr int attached_mm = 60;  // nearer to an aisle's edge is at its edge

// What stands at the edge of an aisle or in it leaves it wide enough on one side at least, and
// between it and what it does not touch.
bool leaves_wide(const Aisle& aisle, const RectMm& rect, int min_mm) {
  const RectMm floor = bounds_of(aisle.polygon_mm);
  if (!marketgen::overlap(floor, rect)) return true;
  const Side beside = runs_along_x(aisle) ? Side::south : Side::west;
  const Span wide = across(floor, beside), taken = across(rect, beside);
  const int doors_mm = std::max(0, wide.length() - aisle.width_mm);
  const int low = taken.from - wide.from, high = wide.to - taken.to;
  const auto passes = [&](int gap) { return gap >= min_mm + doors_mm; };
  const bool open = wide.length() >= open_floor_mm;  // nothing borders it on one side
  const auto closed = [&](int gap) { return open || gap <= attached_mm; };
  return (passes(low) && (passes(high) || closed(high))) || (passes(high) && closed(low));
}

// Some cell of the place that is got to is so after `item` stands there.
bool still_reached(const Reach& reach, const RectMm& place, const RectMm& item, int clearance_mm) {
  const navigation::OccupancyGrid& grid = reach.grid;
  const auto cell_of = [&](int at, int from, int cells) {
    return std::clamp((at - from) / grid.cell_mm, 0, cells - 1);
  };
  const int last_row = cell_of(place.y1, grid.bounds.y0, grid.rows);
  const int last_column = cell_of(place.x1, grid.bounds.x0, grid.columns);
  for (int row = cell_of(place.y0, grid.bounds.y0, grid.rows); row <= last_row; ++row) {
    for (int column = cell_of(place.x0, grid.bounds.x0, grid.columns); column <= last_column;
         ++column) {
      const bool free = grid.free(column, row) && reach.reached(grid.index(column, row));
      if (free && distance_mm(item, point_rect(grid.center(column, row))) >= clearance_mm)
        return true;
    }
  }
  return false;
}

}  // namespace

FloorGuard::FloorGuard(const Design& design, const std::vector<Fixture>& fixtures)
    : min_untight_aisle_mm_(min_untight_aisle_mm(design)), aisles_(find_aisles(design, fixtures)) {
  for (const int width_mm : {design.profile.wheelchair_mm, robot_width_mm}) {
    Walker walker{width_mm, reach_of(design.floor, design.plan.shell, fixtures, width_mm), {}};
    for (const Fixture& fixture : fixtures) {
      for (int side = 0; side < fixture.sides; ++side) {
        const RectMm place = standing_place(fixture, side, width_mm);
        if (walker.reach.reaches(place)) walker.fronts.push_back(place);
      }
    }
    walkers_.push_back(std::move(walker));
  }
}

bool FloorGuard::leaves_aisles(const RectMm& rect) const {
  return std::ranges::all_of(
      aisles_, [&](const Aisle& aisle) { return leaves_wide(aisle, rect, min_untight_aisle_mm_); });
}

bool FloorGuard::allows(const Fixture& item) const {
  const RectMm rect = footprint_of(item);
  if (!leaves_aisles(rect)) return false;
  return std::ranges::all_of(walkers_, [&](const Walker& walker) {
    const int clearance_mm = walker.width_mm / 2;
    const RectMm near = rect.grown(clearance_mm);
    const auto reached = [&](const RectMm& place) {
      return still_reached(walker.reach, place, rect, clearance_mm);
    };
    return reached(standing_place(item, 0, walker.width_mm)) &&
           std::ranges::all_of(walker.fronts,
                               [&](const RectMm& place) {
                                 return !marketgen::overlap(place, near) || reached(place);
                               }) &&
           navigation::stays_joined(walker.reach.grid, rect, clearance_mm, detour_mm);
  });
}

void FloorGuard::add(const Fixture& item) {
  for (Walker& walker : walkers_) {
    walker.reach.grid = navigation::with_obstacle(
        std::move(walker.reach.grid), footprint_of(item), walker.width_mm / 2);
    walker.fronts.push_back(standing_place(item, 0, walker.width_mm));
  }
}

}  // namespace marketgen::layout
