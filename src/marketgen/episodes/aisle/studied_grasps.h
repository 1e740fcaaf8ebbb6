// Grasps of a product as it stands among its likes on a shelf, by the numbers that the grasp study
// gives them.
#pragma once
#include <vector>

#include "catalog/catalog.h"
#include "motion/grasp_candidates.h"

namespace marketgen::episodes {

// The candidates of those numbers, in that order; all of them, best first, for none. Error
// motion.no_grasp with the reason; those of grasp_candidates.
Result<std::vector<motion::GraspCandidate>> studied_grasps(
    const catalog::Product& product,
    const robots::GraspTool& tool,
    const std::vector<catalog::FrictionRow>& frictions,
    const std::vector<int>& numbers);

}  // namespace marketgen::episodes
