#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>

#include "layout/neighbours.h"
#include "layout/staff_floor.h"
#include "layout/zone_build.h"

namespace marketgen::layout {
namespace {

constexpr int wall_gap_mm = 20;            // skirting and uneven walls behind a unit
constexpr int max_under_window_mm = 1000;  // units no higher may stand under a window

struct WallJob {
  std::size_t ground;
  Side side;
  Span span;
  bool cold;
};

// Cold cabinets first, because they have the fewest places to go; then walls without the entrance;
// then the longest.
std::vector<WallJob> wall_jobs(const Build& build) {
  std::vector<WallJob> jobs;
  for (std::size_t i = 0; i < build.grounds.size(); ++i) {
    const ZoneBuild& zone = build.zones[build.grounds[i].zone];
    if (zone.kinds.wall == nullptr || zone.stands) continue;
    const bool cold = zone.kinds.wall->temperature != catalog::Storage::ambient;
    for (const Side side : all_sides) {
      for (const Span& wall : build.grounds[i].ground.walls[index_of(side)]) {
        for (const Span& span : without_windows(build, side, wall, zone.kinds.wall->height_mm)) {
          jobs.push_back({i, side, span, cold});
        }
      }
    }
  }
  const Doorway* entrance = entrance_of(build.design.floor, build.design.plan.shell);
  const auto order = [&](const WallJob& job) {
    const bool front = entrance != nullptr && entrance->wall == job.side;
    return std::tuple{!job.cold, front, -job.span.length()};
  };
  std::ranges::stable_sort(jobs, {}, order);
  return jobs;
}

// Service counters stand off the wall, so that staff can work behind them.
bool has_staff_aisle(const GroundBuild& ground,
                     const WallJob& job,
                     const ModuleSpec& spec,
                     int clear_mm) {
  return is_counter(*spec.kind) && across(ground.ground.rect, job.side).length() >=
                                       staff_aisle_mm + spec.depth_mm + clear_mm / 2;
}

// A way in for the staff: at the end that is not in a corner of the room.
Span with_staff_entry(const Build& build, Side side, Span span, int entry_mm) {
  const Span room = along(build.design.floor.bounds, side);
  if (span.to == room.to) return {span.from + entry_mm, span.to};
  return {span.from, span.to - entry_mm};
}

// The band without what is too near to fixtures of goods that are kept apart from the zone's.
std::vector<Span> apart_from_others(const Build& build, const ZoneBuild& zone, const Row& row) {
  std::vector<Span> taken;
  for (const Fixture& fixture : build.site.fixtures()) {
    const plan::Zone* other = plan::find_zone(build.design.plan, fixture.zone);
    if (other == nullptr || !kept_apart(zone.zone->type, other->type, build.design.catalog))
      continue;
    const RectMm near = footprint_of(fixture).grown(apart_mm);
    if (marketgen::overlap(near, row.band)) taken.push_back(along(near, row.front));
  }
  return without(along(row.band, row.front), taken, row.spec->narrowest_mm());
}

// Where one of the runs that are wanted can stand; the whole band when runs are not counted.
std::optional<Span> room_for_run(const Build& build, const ZoneBuild& zone, const Row& row) {
  if (zone.runs_left(row.spec->kind) == std::numeric_limits<int>::max())
    return along(row.band, row.front);
  for (const Span& span : build.site.free_spans(row)) {
    const auto modules = static_cast<int>(fill_widths(*row.spec, span.length()).size());
    if (modules >= zone.min_in_run(row.spec->kind)) return span;
  }
  return std::nullopt;
}

void line_wall(Build& build, ZoneBuild& zone, const WallJob& job) {
  GroundBuild& ground = build.grounds[job.ground];
  const catalog::FixtureKind& kind =
      zone.kinds.wall != nullptr ? *zone.kinds.wall : *zone.kinds.main;
  const ModuleSpec spec = one_sided(module_spec(build.design, *zone.zone, kind));
  const int clear = spec.clear_mm(build.design);
  const bool staffed = has_staff_aisle(ground, job, spec, clear);
  const int offset = staffed ? staff_aisle_mm : wall_gap_mm;
  const Span span =
      staffed ? with_staff_entry(build, job.side, job.span, build.design.min_aisle_mm()) : job.span;
  const RectMm band =
      cut_along(strip_inside(ground.ground.rect, job.side, spec.depth_mm, offset), job.side, span);
  const int most = zone.modules_left(spec.kind);
  if (most <= 0) return;
  const Row whole{zone.run_id(), zone.zone, &spec, opposite(job.side), band, clear, most};
  bool any = false;
  for (const Span& part : apart_from_others(build, zone, whole)) {
    Row row = whole;
    row.run = zone.run_id();
    row.band = cut_along(band, row.front, part);
    row.max_modules = zone.max_in_run(spec.kind);
    const std::optional<Span> room = room_for_run(build, zone, row);
    if (!room || zone.runs_left(spec.kind) == 0) continue;
    row.band = cut_along(row.band, row.front, *room);
    const std::vector<PlacedRun> runs = build.site.place(row, Packing::low);
    if (!runs.empty()) ++zone.next_run;
    zone.count(spec.kind, runs);
    any = any || !runs.empty();
  }
  if (!any) return;
  int& lined = ground.lined_mm[index_of(job.side)];
  lined = std::max(lined, offset + spec.depth_mm);
  if (staffed) {
    build.site.keep_clear(
        cut_along(strip_inside(ground.ground.rect, job.side, offset), job.side, job.span));
  }
}

// The zone has no floor for this before what lines its walls.
bool is_narrow(const Build& build, const GroundBuild& ground, const ModuleSpec& spec) {
  const ZoneBuild& zone = build.zones[ground.zone];
  if (zone.kinds.wall == nullptr) return false;
  const ModuleSpec wall = one_sided(module_spec(build.design, *zone.zone, *zone.kinds.wall));
  const int aisle = std::max(wall.clear_mm(build.design), spec.clear_mm(build.design));
  const auto short_of = [&](int across_mm) {
    return across_mm < wall.depth_mm + aisle + spec.depth_mm;
  };
  for (const Side side : all_sides) {
    if (ground.ground.touches_wall(side) && short_of(across(ground.ground.rect, side).length()))
      return true;
  }
  return false;
}

// The shortest wall that holds the whole group, then the longest ones.
std::vector<WallJob> group_jobs(const Build& build,
                                const GroupBuild& group,
                                const ModuleSpec& spec) {
  std::vector<WallJob> jobs;
  for (std::size_t i = 0; i < build.grounds.size(); ++i) {
    const GroundBuild& ground = build.grounds[i];
    if (ground.zone != group.zone) continue;
    if (group.build.kinds.wall == nullptr && !is_narrow(build, ground, spec)) continue;
    for (const Side side : all_sides) {
      for (const Span& wall : ground.ground.walls[index_of(side)]) {
        for (const Span& span : without_windows(build, side, wall, spec.height_mm))
          jobs.push_back({i, side, span, false});
      }
    }
  }
  const int needed = group.build.modules_left(spec.kind) * spec.widths_mm.front();
  std::ranges::stable_sort(jobs, {}, [&](const WallJob& job) {
    const int length = job.span.length();
    return std::pair{length < needed, length < needed ? -length : length};
  });
  return jobs;
}

}  // namespace

std::vector<Span> without_windows(const Build& build, Side side, Span span, int height_mm) {
  if (height_mm <= max_under_window_mm) return {span};
  std::vector<Span> windows;
  for (const Doorway& door : build.design.floor.doorways) {
    const plan::Opening& opening = build.design.plan.shell.openings[door.opening];
    if (opening.kind == plan::OpeningKind::window && door.wall == side)
      windows.push_back(door.span);
  }
  return without(span, windows);
}

void line_walls(Build& build) {
  for (const WallJob& job : wall_jobs(build))
    line_wall(build, build.zones[build.grounds[job.ground].zone], job);
}

void line_walls_with_groups(Build& build) {
  for (GroupBuild& group : build.groups) {
    const ModuleSpec spec =
        one_sided(module_spec(build.design, *group.build.zone, *group.build.kinds.main));
    for (const WallJob& job : group_jobs(build, group, spec))
      line_wall(build, group.build, job);
  }
}

}  // namespace marketgen::layout
