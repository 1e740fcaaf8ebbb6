#include "layout/relations.h"

#include "plan/bsp.h"

namespace marketgen::layout {

plan::NamedFloor named_floor(const Layout& layout) {
  plan::NamedFloor floor{plan::shell_rect(layout.shell), layout.shell.openings, {}};
  floor.zones.reserve(layout.zones.size());
  for (const LayoutZone& zone : layout.zones)
    floor.zones.push_back({zone.id, zone.type, bounds_of(zone.polygon_mm)});
  return floor;
}

}  // namespace marketgen::layout
