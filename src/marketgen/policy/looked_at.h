// Pictures of a look for a decision's trace: half as wide and high, with boxes round masks and
// round what was found.
#pragma once
#include <vector>

#include "agent/decision.h"
#include "perception/target_choice.h"

namespace marketgen::policy {

// What is taken to be a goal's, lying so.
struct FoundShape {
  int goal = 0;
  const perception::ProductLook* look = nullptr;
  Pose base_from_product;
};

std::vector<agent::LookedAt> looked_at(const std::vector<perception::ViewCloud>& views,
                                       const std::vector<perception::MaskedView>& masked,
                                       const std::vector<FoundShape>& found);

}  // namespace marketgen::policy
