// The goal region of Checkout Unloading: the unloading area on the counter.
#pragma once
#include <vector>

#include "episodes/checkout_station.h"
#include "episodes/goal_judge.h"

namespace marketgen {

constexpr double most_tilt_deg = 15;

// Points over the area and not under it; station frame.
HoldsPoint over_area(const AreaRow& area);

// `is_void` when the basket was tilted too far.
EpisodeOutcome judge_checkout(const AreaRow& area,
                              const std::vector<EpisodeGoal>& goals,
                              const std::vector<ItemState>& items,
                              double most_basket_tilt_deg);

}  // namespace marketgen
