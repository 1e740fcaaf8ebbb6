#include "layout/zone_build.h"

#include <limits>

namespace marketgen::layout {

int ZoneBuild::modules_left(const catalog::FixtureKind* kind) const {
  if (kind != kinds.main || !zone->fixture.count) return std::numeric_limits<int>::max();
  return std::max(0, *zone->fixture.count - main_modules);
}

void ZoneBuild::count(const catalog::FixtureKind* kind, const std::vector<PlacedRun>& runs) {
  for (const PlacedRun& run : runs)
    (kind == kinds.main ? main_modules : other_modules) += run.modules;
}

}  // namespace marketgen::layout
