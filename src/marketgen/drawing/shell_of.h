// From what was found on a drawing to the shell of a plan.
#pragma once
#include "drawing/floor_plan.h"
#include "drawing/recognise.h"

namespace marketgen::drawing {

// Turns the floor so that most of its walls run along x and y, straightens walls that nearly do,
// and puts its south-west corner at the origin. Error: drawing.no_scale for shops that are too
// small or too large, drawing.bad_outline.
Result<FloorPlan> shell_of(const Found& found,
                           const Tolerance& tolerance,
                           const std::string& where);

}  // namespace marketgen::drawing
