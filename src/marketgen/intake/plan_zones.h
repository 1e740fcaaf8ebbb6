// The zones of a plan: fixtures and stock as the wishes, the profile and the floor have them.
#pragma once
#include <vector>

#include "intake/plan_writer.h"

namespace marketgen::intake {

constexpr double untidy_jitter = 0.5;  // from here on, items stand in wrong places too
constexpr double untidy_misplaced = 0.03;

// In the order of the program's zones.
std::vector<plan::Zone> zones_of(const PlanSources& sources);

}  // namespace marketgen::intake
