#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "layout/zone_build.h"

namespace marketgen::layout {
namespace {

constexpr int reach_along_wall_mm = 6000;  // baskets farther off are not found
constexpr int step_mm = 250;
constexpr int wall_gap_mm = 20;

const ZoneBuild* nearest_zone(const Build& build, PointMm point) {
  const ZoneBuild* best = nullptr;
  std::int64_t best_distance = 0;
  for (const GroundBuild& ground : build.grounds) {
    const RectMm& r = ground.ground.rect;
    const std::int64_t dx = std::max({r.x0 - point[0], 0, point[0] - r.x1});
    const std::int64_t dy = std::max({r.y0 - point[1], 0, point[1] - r.y1});
    const std::int64_t distance = dx * dx + dy * dy;
    if (best != nullptr && distance >= best_distance) continue;
    best = &build.zones[ground.zone];
    best_distance = distance;
  }
  return best;
}

// A unit beside the approach with its long side to the wall.
struct Stand {
  RectMm rect;
  Side front;
};

// Trolleys are drawn out of the end of their bay, baskets are taken from the side that faces the
// shop.
std::optional<Stand> place_beside(const Build& build,
                                  const Doorway& door,
                                  const ModuleSpec& spec,
                                  bool low_side_first) {
  const Span approach = along(door.approach, door.wall);
  const int width = spec.widths_mm.front();
  const bool endwise = spec.depth_mm > width;
  const int length = endwise ? spec.depth_mm : width;
  const RectMm strip = strip_inside(
      build.design.floor.bounds, door.wall, endwise ? width : spec.depth_mm, wall_gap_mm);
  for (const bool low : {low_side_first, !low_side_first}) {
    const Side toward_door = lies_along_x(door.wall) ? (low ? Side::east : Side::west)
                                                     : (low ? Side::north : Side::south);
    for (int away = 0; away <= reach_along_wall_mm; away += step_mm) {
      const int from = low ? approach.from - away - length : approach.to + away;
      const Stand stand{cut_along(strip, door.wall, {from, from + length}),
                        endwise ? toward_door : opposite(door.wall)};
      if (!build.site.can_stand(stand.rect)) continue;
      const int clear = build.design.min_aisle_mm();
      if (build.site.is_clear(strip_beyond(stand.rect, stand.front, clear)) &&
          build.site.is_clear(strip_beyond(stand.rect, opposite(door.wall), clear))) {
        return stand;
      }
    }
  }
  return std::nullopt;
}

void place_kind(Build& build, const Doorway& door, std::string_view name, bool low_side_first) {
  const catalog::FixtureKind* kind = build.design.catalog.fixture_kind(name);
  const ZoneBuild* owner = nearest_zone(build, door.threshold);
  if (kind == nullptr || owner == nullptr) return;
  const ModuleSpec spec = module_spec(build.design, *owner->zone, *kind);
  const std::optional<Stand> stand = place_beside(build, door, spec, low_side_first);
  if (!stand) return;
  Fixture unit = make_module(spec, *owner->zone);
  unit.run = owner->zone->id + "/entrance/" + std::string(name);
  unit.id = unit.run + "/module-1";
  unit.x_mm = stand->rect.center()[0];
  unit.y_mm = stand->rect.center()[1];
  unit.yaw_deg = yaw_facing(stand->front);
  unit.width_mm = spec.widths_mm.front();
  unit.run_start = unit.run_end = true;
  build.site.add(std::move(unit), build.design.min_aisle_mm());
}

// Posts that say "in": straight before the entrance, with room to pass on every side.
void place_gate(Build& build, const Doorway& door) {
  const catalog::FixtureKind* kind = build.design.catalog.fixture_kind("gate");
  const ZoneBuild* owner = nearest_zone(build, door.threshold);
  if (kind == nullptr || owner == nullptr) return;
  const ModuleSpec spec = module_spec(build.design, *owner->zone, *kind);
  const int width = spec.widths_mm.front();
  const int from = door.span.middle() - width / 2;
  const RectMm rect = cut_along(strip_beyond(door.approach, opposite(door.wall), spec.depth_mm),
                                door.wall,
                                {from, from + width});
  const int round_mm =
      std::max(build.design.min_aisle_mm(), build.design.profile.secondary_aisle_mm * 4 / 5);
  const RectMm round = rect.grown(round_mm);
  if (!build.site.is_clear(round)) return;
  Fixture gate = make_module(spec, *owner->zone);
  gate.run = owner->zone->id + "/entrance/gate";
  gate.id = gate.run + "/module-1";
  gate.x_mm = rect.center()[0];
  gate.y_mm = rect.center()[1];
  gate.yaw_deg = yaw_facing(door.wall);
  gate.width_mm = width;
  gate.run_start = gate.run_end = true;
  build.site.add(std::move(gate), 0);
  build.site.keep_clear(round);
}

}  // namespace

void place_entrance(Build& build) {
  const Doorway* door = entrance_of(build.design.floor, build.design.plan.shell);
  if (door == nullptr) return;
  const ZoneBuild* owner = nearest_zone(build, door->threshold);
  if (owner != nullptr && owner->stands) return;
  const bool low = build.seed.child("entrance").stream().chance(0.5);
  place_kind(build, *door, "trolley_bay", low);
  place_kind(build, *door, "basket_stack", !low);
  place_gate(build, *door);
}

}  // namespace marketgen::layout
