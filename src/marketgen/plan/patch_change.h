// How each operation of patches.inc changes a plan: one change() each.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "plan/patch.h"

namespace marketgen::plan {

struct PlanChange {
  Plan& plan;
  const catalog::Catalog& catalog;
  std::string where;               // "shelves.json:/patches/0/set_ratio"
  std::vector<std::string> paths;  // what was changed, as JSON pointers into the plan

  std::string at(std::string_view field) const { return where + "/" + std::string(field); }
};

#define PLAN_PATCH(name, Type, what) Result<void> change(PlanChange& task, const Type& patch);
#include "plan/patches.inc"
#undef PLAN_PATCH

// The index of what a field of the patch names. Error: plan.unknown_reference with the nearest
// name.
Result<std::size_t> named_zone(const PlanChange& task,
                               std::string_view field,
                               const std::string& id);
Result<std::size_t> named_opening(const PlanChange& task, const std::string& id);

}  // namespace marketgen::plan
