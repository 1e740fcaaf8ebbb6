// Overrides of the plan: single values of single fixtures, applied when everything stands.
#pragma once
#include <vector>

#include "base/result.h"
#include "layout/layout.h"

namespace marketgen::layout {

// Levels, height_mm, color, material or kind of the fixtures that the plan names; footprints stay
// as they are. Errors: plan.unknown_reference for a fixture, kind or material that does not exist,
// plan.bad_value for the rest.
Result<void> apply_overrides(std::vector<Fixture>& fixtures,
                             const plan::Plan& plan,
                             const catalog::Catalog& catalog);

}  // namespace marketgen::layout
