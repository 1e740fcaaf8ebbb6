// How much a prompt may ask for. More than that no shop has, and no search should weigh.
#pragma once
#include <cstddef>
#include <vector>

#include "intake/understanding.h"

namespace marketgen::intake {

// Relations that the search weighs; more are kept as wishes but nothing is done for them.
constexpr std::size_t max_weighed_relations = 40;

// What `keep_within_limits` took away from the planner, as it was asked for.
struct BeyondLimits {
  std::vector<plan::Requirement> changed;    // numbers that were brought within their range
  std::vector<plan::Requirement> set_aside;  // wishes that nobody will try to fulfil
};

// Brings every number within what a plan can hold, sets surplus relations aside, and adds a
// conflict for each: "10000 exits" becomes six.
BeyondLimits keep_within_limits(Understanding& found);

// The wishes as they were asked for, which is how the finished store is judged.
std::vector<plan::Requirement> as_asked(std::vector<plan::Requirement> wishes,
                                        const BeyondLimits& beyond);

}  // namespace marketgen::intake
