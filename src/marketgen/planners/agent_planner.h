// Planning by agents on a language model, after section 3.2 of the MarketGen paper: one that
// looks at photos, one for the floor, one for each zone, one that mends.
//
//   photo reader     photos -> what they look like, beside what the bank of renderings reads
//   spatial agent    words, pictures -> size, openings, BSP tree, zones, relations
//   semantic agent   each zone, in parallel -> its fixtures and goods
//   refiner          what rules and wishes find wrong, and the picture -> patches, in rounds
//
// No model is asked for coordinates. What the agents say becomes a market-plan/1, is repaired, laid
// out, stocked and judged as every other plan; it is taken only when it is no worse than the
// offline planner's, under rules first and wishes then (plan_score.h). Whatever fails, the offline
// planner finishes the job, and the record says so.
#pragma once
#include "base/seed.h"
#include "intake/brief.h"
#include "intake/offline_planner.h"
#include "llm/language_model.h"
#include "planners/budget.h"

namespace marketgen::planners {

class AgentPlanner : public intake::Planner {
 public:
  // `layout_seed`: of the store, so that plans are judged by the layouts that they will have.
  AgentPlanner(intake::OfflinePlanner offline,
               llm::LanguageModel model,
               Limits limits,
               Seed layout_seed);

  // Concessions are the offline planner's alone: a plan of the agents that breaks a hard rule is
  // never handed out. Fails only where the offline planner fails. Deterministic when the model is
  // (--replay).
  Result<intake::Planned> plan(const intake::Brief& brief,
                               const catalog::Catalog& catalog,
                               Seed seed,
                               const intake::Concessions& concessions) const override;

 private:
  intake::OfflinePlanner offline_;
  llm::LanguageModel model_;
  Limits limits_;
  Seed layout_seed_;
};

}  // namespace marketgen::planners
