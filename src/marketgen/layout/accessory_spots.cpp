#include "layout/accessory_spots.h"

#include <algorithm>
#include <array>

#include "layout/aisles.h"
#include "layout/entrance.h"
#include "layout/faces.h"

namespace marketgen::layout {
namespace {

constexpr int off_wall_mm = 20;      // skirting and uneven walls behind a unit
constexpr int wall_behind_mm = 100;  // a run with no floor so near behind it stands along a wall
constexpr int over_gap_mm = 50;      // from a run's top to what hangs over it
constexpr int below_ceiling_mm = 100;
constexpr int highest_foot_mm = 2000;  // of Fixture::fields, base_mm

Spot spot_of(const SpotSearch& search, const RectMm& rect, Side front) {
  return {rect, front, search.spec.height_mm};
}

std::vector<Face> runs_of_zone(const SpotSearch& search) {
  std::vector<Face> runs = faces_of(search.build.site.fixtures(), search.build.design.catalog);
  std::erase_if(runs, [&](const Face& face) {
    return face.zone != search.zone.zone->id || face.role != catalog::FixtureRole::shelving ||
           face.endcap;
  });
  return runs;
}

bool stands_along_wall(const SpotSearch& search, const Face& face) {
  return !on_floor(search.build.design.floor,
                   strip_beyond(face.rect, opposite(face.front), wall_behind_mm));
}

// Both ends of every stretch that is free: beside what stands there already.
void add_wall_spots(std::vector<SpotGroup>& groups,
                    const SpotSearch& search,
                    const Ground& ground,
                    Side side) {
  const ModuleSpec& spec = search.spec;
  const RectMm strip = strip_inside(ground.rect, side, spec.depth_mm, off_wall_mm);
  const int width = spec.widths_mm.front();
  for (const Span& wall : ground.walls[index_of(side)]) {
    for (const Span& seen : without_windows(search.build, side, wall, spec.height_mm)) {
      const RectMm band = cut_along(strip, side, seen);
      const Row row{"", search.zone.zone, &spec, opposite(side), band, clear_before_mm(search), 1};
      for (const Span& free : search.build.site.free_spans(row)) {
        if (free.length() < width) continue;
        for (const int from : {free.from, free.to - width})
          groups.push_back(
              {spot_of(search, cut_along(strip, side, {from, from + width}), opposite(side))});
      }
    }
  }
}

std::vector<SpotGroup> spots_wall(const SpotSearch& search) {
  std::vector<SpotGroup> groups;
  for (const GroundBuild& ground : search.build.grounds) {
    if (&search.build.zones[ground.zone] != &search.zone) continue;
    for (const Side side : all_sides)
      add_wall_spots(groups, search, ground.ground, side);
  }
  return groups;
}

// The widest that is made and no wider than the run is deep.
std::vector<SpotGroup> spots_run_end(const SpotSearch& search) {
  std::vector<SpotGroup> groups;
  for (const Face& face : runs_of_zone(search)) {
    if (stands_along_wall(search, face)) continue;
    const Span deep = across(face.rect, face.front);
    int width = 0;
    for (const int made : search.spec.widths_mm) {
      if (made <= deep.length()) width = std::max(width, made);
    }
    if (width == 0) continue;
    const int low = deep.middle() - width / 2;
    for (const Side end : {left_of(face.front), opposite(left_of(face.front))}) {
      const RectMm beyond = strip_beyond(face.rect, end, search.spec.depth_mm);
      groups.push_back({spot_of(search, cut_along(beyond, end, {low, low + width}), end)});
    }
  }
  search.seed.stream().shuffle(std::span(groups));
  return groups;
}

// The width lies across the longer side of the room.
RectMm centred(const SpotSearch& search, PointMm at, Side front) {
  const int width = search.spec.widths_mm.front(), depth = search.spec.depth_mm;
  const int x = lies_along_x(front) ? width : depth, y = lies_along_x(front) ? depth : width;
  return {at[0] - x / 2, at[1] - y / 2, at[0] - x / 2 + x, at[1] - y / 2 + y};
}

std::vector<SpotGroup> spots_open_floor(const SpotSearch& search) {
  constexpr int beyond_zone_mm = 1500;  // its half of the aisles round it
  const Design& design = search.build.design;
  std::optional<EmptyDisc> best;
  for (const GroundBuild& ground : search.build.grounds) {
    if (&search.build.zones[ground.zone] != &search.zone) continue;
    const auto disc = search.empty.largest_in(ground.ground.rect.grown(beyond_zone_mm));
    if (disc && (!best || disc->radius_mm > best->radius_mm)) best = disc;
  }
  if (!best) return {};
  const Side front =
      design.floor.bounds.width() >= design.floor.bounds.depth() ? Side::south : Side::east;
  const RectMm rect = centred(search, best->center, front);
  if (!search.build.site.is_clear(rect.grown(min_untight_aisle_mm(design)))) return {};
  return {{spot_of(search, rect, front)}};
}

// Over the middle of each run, longest first, where it hangs free of run and ceiling.
std::vector<SpotGroup> spots_over_run(const SpotSearch& search) {
  std::vector<Face> runs = runs_of_zone(search);
  std::ranges::stable_sort(runs, [](const Face& a, const Face& b) {
    return along(a.rect, a.front).length() > along(b.rect, b.front).length();
  });
  std::vector<SpotGroup> groups;
  const int width = search.spec.widths_mm.front();
  for (const Face& face : runs) {
    const Span length = along(face.rect, face.front);
    if (!stands_along_wall(search, face) || length.length() < width) continue;
    if (across(face.rect, face.front).length() < search.spec.depth_mm) continue;
    int top = 0;  // of the run
    for (const Fixture& module : search.build.site.fixtures())
      top = module.run == face.run ? std::max(top, module.height_mm) : top;
    const IntRange& heights = search.spec.kind->height_range_mm;
    const int height = std::clamp(top + over_gap_mm + width, search.spec.height_mm, heights[1]);
    if (height - width < top || height - width > highest_foot_mm ||
        height > search.build.design.plan.shell.ceiling_mm - below_ceiling_mm)
      continue;
    const int from = length.middle() - width / 2;
    const RectMm behind = strip_inside(face.rect, opposite(face.front), search.spec.depth_mm);
    groups.push_back({{cut_along(behind, face.front, {from, from + width}),
                       face.front,
                       height,
                       height - width}});
  }
  return groups;
}

std::vector<SpotGroup> beside(const SpotSearch& search, const Doorway* door) {
  if (door == nullptr || door->approach.empty()) return {};
  Stream draw = search.seed.stream();
  const std::optional<Stand> stand =
      stand_beside(search.build, *door, search.spec, reach_along_wall_mm, draw.chance(0.5));
  if (!stand) return {};
  return {{spot_of(search, stand->rect, stand->front)}};
}

std::vector<SpotGroup> spots_entrance(const SpotSearch& search) {
  return beside(search, entrance_of(search.build.design.floor, search.build.design.plan.shell));
}

std::vector<SpotGroup> spots_exit(const SpotSearch& search) {
  return beside(search, exit_of(search.build.design.floor, search.build.design.plan.shell));
}

// At the edges of the floor that must be free before the door: as near to the door as they can be.
std::vector<SpotGroup> spots_way_out(const SpotSearch& search) {
  constexpr std::array<int, 4> from_wall_mm{100, 500, 900, 1300};
  const Doorway& door = *search.door;
  const Span way = along(door.approach, door.wall);
  const int width = search.spec.widths_mm.front();
  std::vector<SpotGroup> groups;
  for (const int off : from_wall_mm) {
    const RectMm line =
        strip_inside(search.build.design.floor.bounds, door.wall, search.spec.depth_mm, off);
    SpotGroup pair;
    for (const int from : {way.from - width, way.to})
      pair.push_back(
          spot_of(search, cut_along(line, door.wall, {from, from + width}), opposite(door.wall)));
    groups.push_back(std::move(pair));
  }
  return groups;
}

}  // namespace

int clear_before_mm(const SpotSearch& search) {
  if (search.spec.kind->role == catalog::FixtureRole::shelving)
    return search.spec.clear_mm(search.build.design);
  return std::max(search.build.design.min_aisle_mm() + search.spec.door_swing_mm(),
                  static_cast<int>(search.spec.kind->front_clearance_mm));
}

std::vector<SpotGroup> find_spots(const SpotSearch& search, AccessoryPlace place) {
  switch (place) {
#define ACCESSORY_PLACE(name, where) \
  case AccessoryPlace::name:         \
    return spots_##name(search);
#include "layout/accessory_places.inc"
#undef ACCESSORY_PLACE
  }
  return {};
}

}  // namespace marketgen::layout
