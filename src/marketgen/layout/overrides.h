// Overrides of the plan: single values of single fixtures.
#pragma once
#include <string_view>
#include <vector>

#include "base/result.h"
#include "layout/layout.h"

namespace marketgen::layout {

// A piece of the floor of a zone.
struct ZoneFloor {
  std::string_view zone;
  RectMm rect;
};

// The plan's pinned places: x_mm and y_mm.
std::vector<plan::Override> pinned_places(const plan::Plan& plan);

// Moves runs to where the plan pins the middle of one of their fixtures (x_mm, y_mm), with the run
// that stands back to back with them and their endcaps. For what the zones are for, before
// accessories are placed beside it; fixtures that are not there yet are left to apply_overrides.
// What stands there already stays. Errors: plan.bad_value for a place that is no number, or where
// none of the run is on the floor of its zone.
Result<void> move_runs(std::vector<Fixture>& fixtures,
                       const plan::Plan& plan,
                       const std::vector<ZoneFloor>& floors);

// Levels, height_mm, color, material or kind of the fixtures that the plan names, when everything
// stands; footprints stay as they are. Errors: plan.unknown_reference for a fixture, kind or
// material that does not exist, plan.bad_value for the rest, and for the place of an accessory.
Result<void> apply_overrides(std::vector<Fixture>& fixtures,
                             const plan::Plan& plan,
                             const catalog::Catalog& catalog);

}  // namespace marketgen::layout
