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
#include "planners/shown_pictures.h"

namespace marketgen::planners {

// A picture that a question to the model had with it.
struct TracedPicture {
  std::string file;  // in the same folder
  std::string of;    // as the brief names it
  std::string read;  // what was read of it; may be empty

  static constexpr auto fields =
      field_list(field("file", &TracedPicture::file, "in the same folder", required()),
                 field("of", &TracedPicture::of, "which of the pictures that were given"),
                 field("read", &TracedPicture::read, "what was read of it"));
};

// One step: an agent's answer, or the lack of one.
struct TraceStep {
  std::string agent;               // "offline planner", "spatial agent" …
  std::string what;                // what came of it, in a sentence
  std::optional<PlanScore> score;  // of the plan after it
  std::vector<std::string> rules;  // that this plan breaks
  std::string picture;             // file of its layout, in the same folder; may be empty
  std::optional<std::vector<TracedPicture>> shown;  // to the model, with the question

  static constexpr auto fields =
      field_list(field("agent", &TraceStep::agent, "who"),
                 field("what", &TraceStep::what, "what came of it"),
                 field("score", &TraceStep::score, "faults of the plan after it"),
                 field("rules", &TraceStep::rules, "rules that this plan breaks"),
                 field("picture", &TraceStep::picture, "its layout, a file in the same folder"),
                 field("shown", &TraceStep::shown, "pictures that the model was shown"));
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

  // A step without a plan whose question had pictures with it; `read`: of each, or empty.
  void add(std::string agent,
           std::string what,
           const std::vector<ShownPicture>& pictures,
           const std::vector<std::string>& read);

  // agents/trace.json, agents/index.html, agents/step-N.png, agents/shown-N.png.
  std::vector<intake::PlannerFile> files(const intake::PlannerRecord& record) const;
  const std::vector<TraceStep>& steps() const { return steps_; }

 private:
  std::vector<TraceStep> steps_;
  std::string file_of(const ShownPicture& picture);

  std::vector<intake::PlannerFile> pictures_;
  std::vector<std::string>
      shown_;  // which of the given pictures, by the number in their file's name
};

}  // namespace marketgen::planners
