// Which module of a policy was first wrong, of each goal that it did not reach: what it decided is
// compared with what was true at that time.
//
// What was put right counts no more: a hand that comes back empty and takes hold at the next try
// was not what kept the goal from being reached. So of a goal's wrong decisions the first counts
// after its last right one of the same part or a later one.
#pragma once
#include <string>
#include <vector>

#include "episodes/episode_result.h"
#include "evaluation/decision_record.h"

namespace marketgen::evaluation {

constexpr double right_place_m = 0.03;  // between a product's middle, as taken, and the true one

// The product is there.
inline bool is_right(const TruthThere& truth) {
  return truth.own_m && *truth.own_m <= right_place_m;
}

// In the order of the result's goals, which are those of the task. `decisions` have their truth.
std::vector<JudgedGoal> judged_goals(const std::vector<DecisionRecord>& decisions,
                                     const episodes::EpisodeResult& result);

}  // namespace marketgen::evaluation
