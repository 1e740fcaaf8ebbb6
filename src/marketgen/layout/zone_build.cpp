#include "layout/zone_build.h"

#include <limits>

namespace marketgen::layout {

std::optional<int> lines_wanted(const plan::FixtureSpec& spec, const catalog::FixtureKind& kind) {
  if (!spec.runs) return std::nullopt;
  const bool pairs = spec.double_sided.value_or(false) && !kind.double_sided;
  return pairs ? 2 * *spec.runs : *spec.runs;
}

std::string ZoneBuild::take_run_id() {
  std::string id = run_id();
  ++next_run;
  return id;
}

int ZoneBuild::runs_left(const catalog::FixtureKind* kind) const {
  if (kind != kinds.main || kind == nullptr) return std::numeric_limits<int>::max();
  const std::optional<int> lines = lines_wanted(zone->fixture, *kind);
  return lines ? std::max(0, *lines - main_runs) : std::numeric_limits<int>::max();
}

int ZoneBuild::max_in_run(const catalog::FixtureKind* kind) const {
  const int modules = modules_left(kind), runs = runs_left(kind);
  const bool shared = zone->fixture.count && zone->fixture.runs && kind == kinds.main && runs > 0;
  return shared ? (modules + runs - 1) / runs : modules;
}

int ZoneBuild::min_in_run(const catalog::FixtureKind* kind) const {
  const bool shared = zone->fixture.count && zone->fixture.runs && kind == kinds.main;
  return shared ? max_in_run(kind) : 1;
}

int ZoneBuild::modules_left(const catalog::FixtureKind* kind) const {
  if (kind != kinds.main || !zone->fixture.count) return std::numeric_limits<int>::max();
  return std::max(0, *zone->fixture.count - main_modules);
}

void ZoneBuild::count(const catalog::FixtureKind* kind, const std::vector<PlacedRun>& runs) {
  for (const PlacedRun& run : runs) {
    (kind == kinds.main ? main_modules : other_modules) += run.modules;
    main_runs += kind == kinds.main ? 1 : 0;
  }
}

}  // namespace marketgen::layout
