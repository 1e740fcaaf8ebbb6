#include "layout/repair_candidates.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace marketgen::layout {

std::optional<RepairCandidate> candidate(const RepairTask& task,
                                         const std::vector<plan::Patch>& patches,
                                         std::string change) {
  RepairCandidate made{task.plan, std::move(change), {}};
  for (const plan::Patch& patch : patches) {
    Result<plan::Patched> patched = plan::patched(made.plan, patch, task.catalog, "repair");
    if (!patched.ok()) return std::nullopt;
    made.plan = std::move(patched->plan);
    std::ranges::move(patched->paths, std::back_inserter(made.paths));
  }
  return made;
}

void add_candidate(std::vector<RepairCandidate>& out,
                   const RepairTask& task,
                   const plan::Patch& patch,
                   std::string change) {
  if (auto made = candidate(task, {patch}, std::move(change))) out.push_back(std::move(*made));
}

// The zone that the fault lies in: ids of fixtures, runs and aisles begin with it.
std::optional<std::size_t> zone_of(const RepairTask& task) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < task.plan.zones.size(); ++i) {
    const std::string& id = task.plan.zones[i].id;
    const std::string& where = task.violation.where;
    const bool within =
        where == id ||
        (where.size() > id.size() && where.starts_with(id) && where[id.size()] == '/') ||
        (where == task.plan.zones[i].type);
    if (within && (!best || id.size() > task.plan.zones[*best].id.size())) best = i;
  }
  return best;
}

// A person, in words, by a flag or with a picture: the value at `path`, or what lies below it.
bool somebody_said(const plan::Plan& plan, const std::string& path) {
  return std::ranges::any_of(plan.provenance, [&](const plan::Provenance& p) {
    return (p.path == path || p.path.starts_with(path + "/")) && p.source >= plan::Source::photo &&
           p.source != plan::Source::repair;
  });
}

}  // namespace marketgen::layout
