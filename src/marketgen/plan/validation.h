// The parts of validate_plan, one concept a file. Each returns the first fault it finds.
#pragma once
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"
#include "plan/plan.h"

namespace marketgen::plan {

constexpr std::size_t max_crowded_pairs = 100'000;  // of placed products that stand in one another

// What every part looks at.
struct PlanCheck {
  const Plan& plan;
  const catalog::Catalog& catalog;
  const std::string& source;

  // "riverside.json:/zones/2/fixture/kind"
  std::string at(std::string_view pointer) const { return source + ":" + std::string(pointer); }
};

// "/zones/2" or "/zones/2/fixture/kind"
std::string element_pointer(std::string_view list, std::size_t index, std::string_view rest = {});

// Ids of nodes are unique, and so are those of zones and openings together: relations name both.
Result<void> check_ids(const PlanCheck& check);
// Outline and columns.
Result<void> check_shell(const PlanCheck& check);
Result<void> check_openings(const PlanCheck& check);
// One binary tree that holds each zone once, not too deep and not too wide.
Result<void> check_tree(const PlanCheck& check);
// Every node's rectangle has room. Precondition: check_tree passed.
Result<void> check_room(const PlanCheck& check);
// Names that must be in the catalogue: profile, materials, zone types, fixture kinds, categories.
Result<void> check_names(const PlanCheck& check);
// Values of a zone against one another and against its fixture kind's row. Precondition:
// check_names passed.
Result<void> check_zone_values(const PlanCheck& check);
// What stands at the doors.
Result<void> check_equipment(const PlanCheck& check);
// Relations, overrides, placements and planogram.
Result<void> check_references(const PlanCheck& check);

// The error unless `text` is #rrggbb.
Result<void> check_color(std::string_view text, std::string where);

// The error unless `name` is in the range of rows, compared by `id_of(row)`.
template <class Rows, class IdOf>
Result<void> check_name(
    const Rows& rows, IdOf id_of, std::string_view what, std::string_view name, std::string where) {
  std::vector<std::string_view> known;
  for (const auto& row : rows) {
    if (row.*id_of == name) return {};
    known.push_back(row.*id_of);
  }
  return catalog::unknown_name("catalog.unknown_kind", std::move(where), what, name, known);
}

}  // namespace marketgen::plan
