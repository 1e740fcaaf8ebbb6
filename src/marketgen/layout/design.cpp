#include "layout/design.h"

namespace marketgen {

Design make_design(const Plan& plan, const Catalog& catalog) {
  const ProfileRow* profile = catalog.profile(plan.profile);
  return {plan, catalog, profile != nullptr ? *profile : ProfileRow{}, make_floor(plan.shell)};
}

bool is_cold(const Zone& zone, const Catalog& catalog) {
  const ZoneTypeRow* type = catalog.zone_type(zone.type);
  return zone.temperature != Storage::ambient ||
         (type != nullptr && type->temperature != Storage::ambient);
}

int wanted_aisle_mm(const Design& design, const Zone& zone) {
  if (zone.fixture.aisle_mm) return std::max(*zone.fixture.aisle_mm, design.min_aisle_mm());
  const int habit = is_cold(zone, design.catalog) ? design.profile.cold_aisle_mm
                                                  : design.profile.secondary_aisle_mm;
  return std::max(habit, design.min_aisle_mm());
}

}  // namespace marketgen
