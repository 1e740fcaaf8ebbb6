#include <algorithm>

#include "plan/patch_change.h"

namespace marketgen::plan {
namespace {

template <class Row>
Result<std::size_t> index_named(const std::vector<Row>& rows,
                                std::string_view what,
                                const std::string& id,
                                std::string where) {
  const auto found = std::ranges::find(rows, id, &Row::id);
  if (found != rows.end()) return static_cast<std::size_t>(found - rows.begin());
  std::vector<std::string_view> known;
  for (const Row& row : rows)
    known.push_back(row.id);
  return catalog::unknown_name("plan.unknown_reference", std::move(where), what, id, known);
}

}  // namespace

Result<std::size_t> named_zone(const PlanChange& task,
                               std::string_view field,
                               const std::string& id) {
  return index_named(task.plan.zones, "zone", id, task.at(field));
}

Result<std::size_t> named_opening(const PlanChange& task, const std::string& id) {
  return index_named(task.plan.shell.openings, "opening", id, task.at("opening"));
}

}  // namespace marketgen::plan
