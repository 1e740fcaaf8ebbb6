// What the agents of a plan did: files for the store's folder `agents/`, so that a person can
// follow each step.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "catalog/catalog.h"
#include "intake/brief.h"
#include "planners/plan_score.h"

namespace marketgen::planners {

// One step: an agent's answer, or the lack of one.
struct TraceStep {
  std::string agent;               // "offline planner", "spatial agent" …
  std::string what;                // what came of it, in a sentence
  std::optional<PlanScore> score;  // of the plan after it
  std::vector<std::string> rules;  // that this plan breaks
  std::string picture;             // file of its layout, in the same folder; may be empty

  static constexpr auto fields =
      field_list(field("agent", &TraceStep::agent, "who"),
                 field("what", &TraceStep::what, "what came of it"),
                 field("score", &TraceStep::score, "faults of the plan after it"),
                 field("rules", &TraceStep::rules, "rules that this plan breaks"),
                 field("picture", &TraceStep::picture, "its layout, a file in the same folder"));
};

class Trace {
 public:
  // A step without a plan.
  void add(std::string agent, std::string what);
  // A step that made a plan; its layout is drawn. Errors: those of encode_png.
  Result<void> add(std::string agent,
                   std::string what,
                   const JudgedPlan& judged,
                   const catalog::Catalog& catalog);

  // agents/trace.json, agents/index.html, agents/step-N.png.
  std::vector<intake::PlannerFile> files(const intake::PlannerRecord& record) const;
  const std::vector<TraceStep>& steps() const { return steps_; }

 private:
  std::vector<TraceStep> steps_;
  std::vector<intake::PlannerFile> pictures_;
};

}  // namespace marketgen::planners
