// Room that no picture shows to be free: behind and under what is seen other goods may lie.
#pragma once
#include <vector>

#include "perception/grasp_source.h"
#include "robots/grasp_tool.h"

namespace marketgen::perception {

// How much of the solids' length along the tool, all together, is where no picture sees as far,
// metres: of fingers that stand so, what they would have to find out by feel. 0 without pictures.
double hidden_length_m(const std::vector<robots::ToolSolid>& solids,
                       const Pose& base_from_tip,
                       const SeenIn& seen_in);

}  // namespace marketgen::perception
