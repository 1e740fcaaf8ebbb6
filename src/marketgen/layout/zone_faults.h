// What is wrong with a plan's zones before anything stands on them.
//
// Some rules look at nothing but the floor of each zone: ZONE_TOO_SMALL, COLD_SCATTERED,
// PRODUCE_FAR, RELATION_BROKEN, RELATION_MISSED. They are measured on a plan in microseconds where
// a layout takes milliseconds, so that a repair lays out only what can mend them.
#pragma once
#include <compare>
#include <string_view>
#include <vector>

#include "catalog/catalog.h"
#include "layout/layout.h"
#include "plan/plan.h"

namespace marketgen::layout {

// How many rules are broken; fewer hard ones weigh more than any number of soft ones.
struct FaultCount {
  int hard = 0, soft = 0;
  friend auto operator<=>(const FaultCount&, const FaultCount&) = default;
};
FaultCount count_faults(const std::vector<Violation>& violations);

// Whether the rule of that code is one of them.
bool is_about_zones(std::string_view code);

// As many as a layout of the plan has of these rules. Precondition: valid plan.
FaultCount zone_faults(const plan::Plan& plan, const catalog::Catalog& catalog);

}  // namespace marketgen::layout
