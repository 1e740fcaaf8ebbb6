// What an error means for the goal that a policy was after.
#pragma once
#include <string_view>

#include "base/result.h"

namespace marketgen::skills {

// Whether a planner found nothing, which leaves the goal to another try; any other error (a row
// that is not there, physics that failed) is that of the policy.
bool is_of_planning(const Error& error);

// The name of a failure code, by the error of a planner. Whatever is not said to be a matter of
// grasps or of reach is a matter of ways.
std::string_view failure_of_plan(const Error& error);

}  // namespace marketgen::skills
