#include "layout/design.h"

namespace marketgen::layout {

Design make_design(const plan::Plan& plan, const catalog::Catalog& catalog) {
  const catalog::ProfileRow* profile = catalog.profile(plan.profile);
  return {
      plan, catalog, profile != nullptr ? *profile : catalog::ProfileRow{}, make_floor(plan.shell)};
}

bool is_cold(const plan::Zone& zone, const catalog::Catalog& catalog) {
  const catalog::ZoneTypeRow* type = catalog.zone_type(zone.type);
  return zone.temperature != catalog::Storage::ambient ||
         (type != nullptr && type->temperature != catalog::Storage::ambient);
}

int wanted_aisle_mm(const Design& design, const plan::Zone& zone) {
  if (zone.fixture.aisle_mm) return std::max(*zone.fixture.aisle_mm, design.min_aisle_mm());
  const int habit = is_cold(zone, design.catalog) ? design.profile.cold_aisle_mm
                                                  : design.profile.secondary_aisle_mm;
  return std::max(habit, design.min_aisle_mm());
}

}  // namespace marketgen::layout
