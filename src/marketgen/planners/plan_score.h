// How good a plan is, measured on what it becomes: repaired, laid out, stocked and judged like
// every store.
#pragma once
#include <array>
#include <compare>
#include <string>
#include <vector>

#include "audit/audit.h"
#include "base/fields.h"
#include "base/result.h"
#include "base/seed.h"
#include "catalog/catalog.h"
#include "layout/layout.h"
#include "plan/plan.h"
#include "plan/requirement.h"

namespace marketgen::planners {

// Counts of faults, compared from the first to the last: a hard rule weighs more than any number of
// wishes, a wish more than any number of soft rules.
struct PlanScore {
  int hard_rules = 0;     // broken
  int missed_wishes = 0;  // of those that must hold
  int soft_rules = 0;     // broken
  int missed_preferences = 0;

  friend auto operator<=>(const PlanScore&, const PlanScore&) = default;  // less is better

  static constexpr auto fields =
      field_list(field("hard_rules", &PlanScore::hard_rules, "hard rules broken"),
                 field("missed_wishes", &PlanScore::missed_wishes, "wishes not met"),
                 field("soft_rules", &PlanScore::soft_rules, "soft rules broken"),
                 field("missed_preferences",
                       &PlanScore::missed_preferences,
                       "wishes not met that were only preferred"));
};

struct JudgedPlan {
  plan::Plan plan;  // repaired
  layout::Layout layout;
  std::vector<layout::Violation> rules;  // of layout and scene
  std::vector<audit::RequirementResult> requirements;
  PlanScore score;
};

// Errors: layout.impossible; those of build_scene and audit_store.
Result<JudgedPlan> judge_plan(const plan::Plan& plan,
                              const std::vector<plan::Requirement>& requirements,
                              const catalog::Catalog& catalog,
                              Seed layout_seed);

// "1 hard rule, 2 wishes, 3 soft rules, 0 preferences"
std::string words_of(const PlanScore& score);

}  // namespace marketgen::planners
