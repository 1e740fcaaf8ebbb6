// Bright spots above: what lamps look like.
#pragma once
#include <vector>

#include "photo/cells.h"
#include "photo/parts.h"

namespace marketgen::photo {

constexpr std::size_t lamp_feature_count = 26;

// Of the spots in the ceiling, and then of those anywhere above the middle: how many, how large,
// how long and how full of light they are; how much brighter than what is around them.
std::vector<double> lamp_features(const Looked& photo,
                                  const Cells& cells,
                                  const std::vector<PartShares>& parts);

}  // namespace marketgen::photo
