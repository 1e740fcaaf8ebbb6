#include <map>

#include "plan/validation.h"

namespace marketgen::plan {
namespace {

// Ids seen so far and where each was first used.
using FirstUse = std::map<std::string, std::string, std::less<>>;

Result<void> take_id(const PlanCheck& check,
                     FirstUse& used,
                     const std::string& id,
                     std::string pointer) {
  const auto [first, fresh] = used.try_emplace(id, pointer);
  if (fresh) return {};
  return Error{"plan.duplicate_id",
               check.at(pointer + "/id"),
               "the id \"" + id + "\" is already used at " + first->second + "; ids are unique"};
}

}  // namespace

Result<void> check_ids(const PlanCheck& check) {
  FirstUse nodes;
  for (std::size_t i = 0; i < check.plan.nodes.size(); ++i) {
    MARKETGEN_CHECK(take_id(check, nodes, check.plan.nodes[i].id, element_pointer("nodes", i)));
  }
  FirstUse places;
  for (std::size_t i = 0; i < check.plan.zones.size(); ++i) {
    MARKETGEN_CHECK(take_id(check, places, check.plan.zones[i].id, element_pointer("zones", i)));
  }
  const std::vector<Opening>& openings = check.plan.shell.openings;
  for (std::size_t i = 0; i < openings.size(); ++i) {
    MARKETGEN_CHECK(take_id(check, places, openings[i].id, element_pointer("shell/openings", i)));
  }
  return {};
}

}  // namespace marketgen::plan
