// Materials, colours and light of a plan.
#pragma once
#include "intake/plan_writer.h"

namespace marketgen::intake {

// The style that was asked for, or the one that goes with the profile; what photos show and single
// wishes on top.
plan::Look look_of(const PlanSources& sources);

// The colour that shelves were asked to have.
std::optional<std::string> shelf_color(const Understanding& understanding);

}  // namespace marketgen::intake
