#include "layout/staff_floor.h"

#include "layout/side.h"

namespace marketgen::layout {
namespace {

constexpr std::string_view staff_zone = "backroom";  // of data/zone_types.json

}  // namespace

bool is_counter(const catalog::FixtureKind& kind) {
  return kind.generator == "serve_over";
}

int staff_depth_mm(const catalog::FixtureKind& kind) {
  if (is_counter(kind)) return staff_aisle_mm;
  return kind.is_desk() ? desk_staff_mm : 0;
}

std::vector<StaffFloor> staff_floor(const Layout& layout, const catalog::Catalog& catalog) {
  std::vector<StaffFloor> floors;
  for (const Fixture& fixture : layout.fixtures) {
    const catalog::FixtureKind* kind = catalog.fixture_kind(fixture.kind);
    const int depth_mm = kind == nullptr ? 0 : staff_depth_mm(*kind);
    if (depth_mm == 0) continue;
    const Side back = opposite(facing_of(fixture.yaw_deg));
    const RectMm behind = strip_beyond(footprint_of(fixture), back, depth_mm);
    floors.push_back({fixture.id, polygon_of(behind)});
  }
  for (const LayoutZone& zone : layout.zones) {
    if (zone.type == staff_zone) floors.push_back({zone.id, zone.polygon_mm});
  }
  return floors;
}

}  // namespace marketgen::layout
