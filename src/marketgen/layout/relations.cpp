#include "layout/relations.h"

#include "plan/bsp.h"

namespace marketgen {

NamedFloor named_floor(const Layout& layout) {
  NamedFloor floor{shell_rect(layout.shell), layout.shell.openings, {}};
  floor.zones.reserve(layout.zones.size());
  for (const LayoutZone& zone : layout.zones)
    floor.zones.push_back({zone.id, zone.type, bounds_of(zone.polygon_mm)});
  return floor;
}

}  // namespace marketgen
