#include "planners/plan_score.h"

#include <fmt/format.h>

#include "scene/scene.h"

namespace marketgen::planners {
namespace {

PlanScore score_of(const JudgedPlan& judged, const std::vector<plan::Requirement>& requirements) {
  PlanScore score;
  for (const layout::Violation& rule : judged.rules)
    ++(rule.severity == layout::Severity::hard ? score.hard_rules : score.soft_rules);
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    if (judged.requirements[i].met) continue;
    const bool must = requirements[i].strength == plan::Strength::must;
    ++(must ? score.missed_wishes : score.missed_preferences);
  }
  return score;
}

std::string counted(int count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace

Result<JudgedPlan> judge_plan(const plan::Plan& plan,
                              const std::vector<plan::Requirement>& requirements,
                              const catalog::Catalog& catalog,
                              Seed layout_seed) {
  JudgedPlan judged;
  MARKETGEN_TRY(layout::Repaired repaired, layout::repair_plan(plan, catalog, layout_seed));
  judged.plan = std::move(repaired.plan);
  if (repaired.layout) {
    judged.layout = std::move(*repaired.layout);
  } else {
    MARKETGEN_TRY(judged.layout, layout::make_layout(judged.plan, catalog, layout_seed));
  }
  MARKETGEN_TRY(
      const scene::Scene scene,
      scene::build_scene(judged.layout, judged.plan, catalog, layout_seed.child("planners")));
  MARKETGEN_TRY(audit::Audit audit, audit::audit_store(scene, catalog, requirements));
  judged.rules = std::move(audit.rules);
  judged.requirements = std::move(audit.requirements);
  judged.score = score_of(judged, requirements);
  return judged;
}

std::string words_of(const PlanScore& score) {
  return fmt::format("{}, {}, {}, {}",
                     counted(score.hard_rules, "hard rule", "hard rules"),
                     counted(score.missed_wishes, "wish", "wishes"),
                     counted(score.soft_rules, "soft rule", "soft rules"),
                     counted(score.missed_preferences, "preference", "preferences"));
}

}  // namespace marketgen::planners
