// Who said what: a provenance entry for every value of a plan that words, flags or pictures
// decided.
#pragma once
#include <vector>

#include "intake/plan_writer.h"

namespace marketgen::intake {

// `plan` has its zones, openings, relations and look already.
std::vector<plan::Provenance> provenance_of(const plan::Plan& plan, const PlanSources& sources);

}  // namespace marketgen::intake
