// What else lies in a basket, and may be in the way of what is asked for.
//
// Base frame of the arm, metres.
#pragma once
#include <optional>
#include <vector>

#include "agent/workplace.h"
#include "perception/pose_source.h"
#include "policy/checkout_sight.h"
#include "policy/sought_goals.h"

namespace marketgen::policy {

// A product of the catalogue that explains what is seen, lying so.
struct RecognisedProduct {
  const perception::ProductLook* look = nullptr;
  perception::FittedPose pose;
};

// By what it is recognised. Both must outlive it.
struct Recognition {
  const std::vector<const perception::ProductLook*>& catalogue;
  const perception::PoseSource& poses;
};

// Goods in the basket that are not asked for: the `max_others` nearest to `near`, or the highest.
// What no product explains well is left out.
std::vector<RecognisedProduct> others_in_basket(const Sight& sight,
                                                const SoughtGoals& goals,
                                                const agent::Workplace& place,
                                                const Recognition& recognition,
                                                const std::optional<Vec3>& near,
                                                std::size_t max_others);

}  // namespace marketgen::policy
