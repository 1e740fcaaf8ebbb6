// Where the basket stands on the counter, by what pictures show of its walls.
#pragma once
#include <optional>
#include <vector>

#include "agent/workplace.h"
#include "perception/view_cloud.h"

namespace marketgen::perception {

// base_from_basket, upright on the counter, near where `place` says: within `off_m` to each side
// and `off_rad` about the vertical, or a little more. Nothing where too little of it is seen.
std::optional<Pose> seen_basket(const std::vector<ViewCloud>& views,
                                const agent::Workplace& place,
                                double off_m,
                                double off_rad);

}  // namespace marketgen::perception
