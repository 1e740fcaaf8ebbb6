// Which products a task asks for, however it says so.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "agent/policy.h"
#include "perception/goal_reader.h"

namespace marketgen::policy {

// Code of the error of words that fit nothing: what is asked for cannot be found.
constexpr std::string_view not_understood = "perception.not_understood";

// The SKU that the goal is told by; else what the reader makes of its words, the likeliest first.
// Errors: episode.impossible, words and no reader; those of the reader.
Result<std::vector<std::string>> goal_skus(const agent::TaskGoal& goal,
                                           const perception::GoalReader* reader);

}  // namespace marketgen::policy
