// Reflection and refiner: what rules and wishes find wrong with a plan, and the picture of its
// floor, go to the model; it answers with patches of the closed set (plan/patch.h), which are kept
// only where they help.
#pragma once
#include <string>
#include <vector>

#include "base/fields.h"
#include "llm/language_model.h"
#include "plan/patch.h"
#include "planners/plan_score.h"
#include "planners/spatial_agent.h"
#include "planners/trace.h"

namespace marketgen::planners {

constexpr int max_refiner_rounds = 3;

// What the refiner answers.
struct Refinement {
  std::vector<plan::Patch> patches;
  std::string reason;

  static constexpr auto fields = field_list(
      field("patches", &Refinement::patches, "in this order", required(), at_most_items(20)),
      field("reason", &Refinement::reason, "one sentence", required(), at_most_bytes(600)));
};

// At most three rounds; each is a line of the trace. A round is taken when the plan's score is less
// than before, and rolled back otherwise: the score never grows. Ends when nothing is wrong, when a
// plan comes a second time, when the model fails, and when it has no patches to offer.
JudgedPlan refined(const llm::LanguageModel& model,
                   JudgedPlan plan,
                   const Assignment& assignment,
                   Seed layout_seed,
                   Trace& trace);

}  // namespace marketgen::planners
