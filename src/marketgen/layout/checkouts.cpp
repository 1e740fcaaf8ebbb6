#include <algorithm>
#include <cmath>

#include "layout/staff_floor.h"
#include "layout/zone_build.h"

namespace marketgen::layout {
namespace {

constexpr int passage_mm =
    1000;  // beside a lane: ADA 904.3 asks for 36 in, a trolley with a child for 1 m
constexpr int self_checkout_floor_mm = 1600;  // between two rows of machines: queue and passage
constexpr double store_m2_per_machine = 120;  // one self-checkout for so much shop

// A checkout zone seen from the exit: `out` is the side that shoppers leave by.
struct TillFloor {
  RectMm rect;
  Side out;
  int before_wall_mm;  // from the exit's wall to the rectangle
  int beyond_mm;       // free floor on the shop's side of the rectangle
};

TillFloor till_floor(const Build& build, const Ground& ground) {
  const Doorway* exit = exit_of(build.design.floor, build.design.plan.shell);
  const Side out = exit != nullptr ? exit->wall : Side::south;
  const int outside =
      distance_beyond(ground.rect, out, strip_beyond(build.design.floor.bounds, out, 1));
  return {ground.rect, out, outside, ground.gap_mm[index_of(opposite(out))]};
}

// Stretches along the line of tills that are not straight before a way in.
std::vector<Span> till_spans(const Build& build, const TillFloor& floor) {
  std::vector<Span> taken;
  for (const Doorway& door : build.design.floor.doorways) {
    const plan::Opening& opening = build.design.plan.shell.openings[door.opening];
    const bool way_in = opening.kind == plan::OpeningKind::entrance && !door.approach.empty();
    const bool also_out = &door == exit_of(build.design.floor, build.design.plan.shell);
    if (way_in && !also_out && door.wall == floor.out)
      taken.push_back(along(door.approach, door.wall));
  }
  return without(along(floor.rect, floor.out), taken);
}

int lane_wish(const Build& build, const plan::Zone& zone) {
  if (zone.fixture.count) return *zone.fixture.count;
  const double store_m2 = area_m2(build.design.floor.outline);
  return std::max(
      1, static_cast<int>(build.design.profile.checkouts_per_100_m2 * store_m2 / 100 + 0.5));
}

// The module as it stands in the line: long side towards the exit.
struct Lane {
  Fixture module;
  int across_mm, along_mm;
};

Lane make_lane(const Design& design,
               const plan::Zone& zone,
               const catalog::FixtureKind& kind,
               Side out) {
  const ModuleSpec spec = module_spec(design, zone, kind);
  Lane lane{make_module(spec, zone), 0, 0};
  lane.module.width_mm = spec.widths_mm.front();
  const bool lengthwise = lane.module.width_mm > lane.module.depth_mm;
  // The belt begins at the shop's end: assets/fixtures/checkout_lane.cpp says which end of the
  // module that is.
  lane.module.yaw_deg = yaw_facing(lengthwise ? opposite(left_of(out)) : out);
  lane.across_mm = lengthwise ? lane.module.depth_mm : lane.module.width_mm;
  lane.along_mm = lengthwise ? lane.module.width_mm : lane.module.depth_mm;
  lane.module.run_start = lane.module.run_end = true;
  return lane;
}

// How many lanes with their passages a stretch holds.
int lanes_in(Span span, int lane_mm) {
  return std::max(0, (span.length() - passage_mm) / (lane_mm + passage_mm));
}

// The stretch that holds most lanes, the one nearest to the exit if several do.
Span best_span(const std::vector<Span>& spans, int lane_mm, int wish, int exit_at) {
  Span best = spans.front();
  const auto merit = [&](Span span) {
    const int away = std::max({span.from - exit_at, 0, exit_at - span.to});
    return std::pair{std::min(wish, lanes_in(span, lane_mm)), -away};
  };
  for (const Span& span : spans) {
    if (merit(span) > merit(best)) best = span;
  }
  return best;
}

// Floor from the exit's wall to the first fixtures of the shop, as far as the tills may use it.
int till_depth(const TillFloor& floor, int clear_mm) {
  return floor.before_wall_mm + across(floor.rect, floor.out).length() +
         std::min(floor.beyond_mm, clear_mm);
}

// Where the floor is short, lanes of the shortest make leave more room before and after them.
void fit_length(Lane& lane, const catalog::FixtureKind& kind, int depth_mm, int clear_mm) {
  if (lane.module.depth_mm < lane.module.width_mm) return;
  const int least = std::min(kind.depth_range_mm[0], lane.module.depth_mm);
  lane.module.depth_mm = std::clamp(depth_mm - 2 * clear_mm, least, lane.module.depth_mm);
  lane.along_mm = lane.module.depth_mm;
}

// From the ground's edge to the lanes: half of what they leave free, but beyond the doors'
// approach.
int lane_offset(const TillFloor& floor, int depth_mm, int lane_mm, int clear_mm) {
  const int room = depth_mm - lane_mm;
  const int approach = std::min(approach_depth_mm, room - clear_mm / 2);
  const int after = std::max(std::min(room / 2, clear_mm), approach);
  return std::max(0, after - floor.before_wall_mm);
}

// Whether lanes of the kind leave what CHECKOUT_TIGHT wants before and after them, and how many
// find room.
struct LaneRoom {
  bool deep_enough = false;
  int lanes = 0;
};

LaneRoom room_for_lanes(const Build& build,
                        const GroundBuild& ground,
                        const catalog::FixtureKind& kind) {
  constexpr double tight_share = 0.6;
  const TillFloor floor = till_floor(build, ground.ground);
  const int clear = build.design.profile.checkout_clear_mm;
  const plan::Zone& zone = *build.zones[ground.zone].zone;
  Lane lane = make_lane(build.design, zone, kind, floor.out);
  const int depth = till_depth(floor, clear);
  if (!zone.fixture.depth_mm) fit_length(lane, kind, depth, clear);
  LaneRoom room{depth >= lane.along_mm + static_cast<int>(2 * tight_share * clear), 0};
  for (const Span& span : till_spans(build, floor))
    room.lanes = std::max(room.lanes, lanes_in(span, lane.across_mm));
  return room;
}

// The store's make of tills, unless fewer of them find room than of the kind that it stands for.
void settle_lanes(Build& build, const GroundBuild& ground) {
  ZoneBuild& zone = build.zones[ground.zone];
  const catalog::FixtureKind* kind = kinds_of(*zone.zone, build.design.catalog).main;
  if (zone.kinds.main == kind) return;
  const int wish = lane_wish(build, *zone.zone);
  const LaneRoom made = room_for_lanes(build, ground, *zone.kinds.main),
                 usual = room_for_lanes(build, ground, *kind);
  const bool fits = made.deep_enough || !usual.deep_enough;
  if (!fits || std::min(wish, made.lanes) < std::min(wish, usual.lanes)) zone.kinds.main = kind;
}

void place_lanes(Build& build, GroundBuild& ground) {
  ZoneBuild& zone = build.zones[ground.zone];
  const TillFloor floor = till_floor(build, ground.ground);
  const std::vector<Span> spans = till_spans(build, floor);
  if (spans.empty()) return;
  const int clear = build.design.profile.checkout_clear_mm;
  Lane lane = make_lane(build.design, *zone.zone, *zone.kinds.main, floor.out);
  if (!zone.zone->fixture.depth_mm) {
    fit_length(lane, *zone.kinds.main, till_depth(floor, clear), clear);
  }
  const Doorway* exit = exit_of(build.design.floor, build.design.plan.shell);
  const int exit_at = exit != nullptr ? exit->span.middle() : along(floor.rect, floor.out).middle();
  const int wish = lane_wish(build, *zone.zone) - zone.main_modules;
  const Span span = best_span(spans, lane.across_mm, wish, exit_at);
  const int count = std::min(wish, lanes_in(span, lane.across_mm));
  if (count <= 0) return;
  const int pitch = lane.across_mm + passage_mm;
  const int used = count * pitch + passage_mm;
  const int start = std::clamp(exit_at - used / 2, span.from, span.to - used) + passage_mm;
  const int offset = lane_offset(floor, till_depth(floor, clear), lane.along_mm, clear);
  const RectMm line = strip_inside(floor.rect, floor.out, lane.along_mm, offset);
  const std::string run = zone.take_run_id();
  for (int i = 0; i < count; ++i) {
    const RectMm rect =
        cut_along(line, floor.out, {start + i * pitch, start + i * pitch + lane.across_mm});
    if (!build.site.can_stand(rect)) continue;
    Fixture module = lane.module;
    module.run = run;
    module.id = run + "/module-" + std::to_string(i + 1);
    module.x_mm = rect.center()[0];
    module.y_mm = rect.center()[1];
    build.site.add(std::move(module), 0);
    ++zone.main_modules;
  }
  const RectMm queue = cut_along(line, floor.out, {start - passage_mm, start - passage_mm + used});
  build.site.keep_clear(queue);
  build.site.keep_clear(
      strip_beyond(queue, floor.out, std::min(clear, offset + floor.before_wall_mm)));
  build.site.keep_clear(strip_beyond(queue, opposite(floor.out), clear));
}

int machine_wish(const Build& build, const plan::Zone& zone) {
  if (zone.fixture.count) return *zone.fixture.count;
  const double store_m2 = area_m2(build.design.floor.outline);
  return std::clamp(static_cast<int>(store_m2 / store_m2_per_machine + 0.5), 2, 12);
}

// Two rows that face each other across the way out, or one where the floor is narrow; more, two and
// two, where that is what the wish takes and the floor has.
int machine_rows(int wide_mm, int depth_mm, int in_row, int wish) {
  const auto needed = [&](int rows) {
    return rows * depth_mm + (rows + 1) / 2 * self_checkout_floor_mm;
  };
  int rows = wide_mm >= needed(2) ? 2 : 1;
  while (rows >= 2 && rows * in_row < wish && wide_mm >= needed(rows + 1))
    ++rows;
  return rows;
}

// How many machines a row along that edge really holds: the floor before a door stays free.
int machines_in_row(const Build& build,
                    const ZoneBuild& zone,
                    const RectMm& rect,
                    const ModuleSpec& spec,
                    Side back) {
  const Row row{"",
                zone.zone,
                &spec,
                opposite(back),
                strip_inside(rect, back, spec.depth_mm),
                build.design.min_aisle_mm(),
                0};
  int machines = 0;
  for (const Span& span : build.site.free_spans(row))
    machines += static_cast<int>(fill_widths(spec, span.length()).size());
  return machines;
}

int machine_room(const Build& build, const GroundBuild& ground, const catalog::FixtureKind& kind) {
  const ZoneBuild& zone = build.zones[ground.zone];
  const TillFloor floor = till_floor(build, ground.ground);
  const ModuleSpec spec = module_spec(build.design, *zone.zone, kind);
  const Side back = lies_along_x(floor.out) ? Side::west : Side::south;
  const int in_row = machines_in_row(build, zone, floor.rect, spec, back);
  const int wish = machine_wish(build, *zone.zone);
  const int wide = across(floor.rect, back).length();
  return in_row * machine_rows(wide, spec.depth_mm, in_row, zone.zone->fixture.count ? wish : 0);
}

void settle_machines(Build& build, const GroundBuild& ground) {
  ZoneBuild& zone = build.zones[ground.zone];
  const catalog::FixtureKind* kind = kinds_of(*zone.zone, build.design.catalog).main;
  if (zone.kinds.main == kind) return;
  const int wish = machine_wish(build, *zone.zone);
  if (std::min(wish, machine_room(build, ground, *zone.kinds.main)) <
      std::min(wish, machine_room(build, ground, *kind)))
    zone.kinds.main = kind;
}

// From the edge behind the first row to the back or front of row `i` of more than two.
int machine_offset(int i, int depth_mm) {
  return i * depth_mm + (i + 1) / 2 * self_checkout_floor_mm;
}

void place_machines(Build& build, GroundBuild& ground) {
  ZoneBuild& zone = build.zones[ground.zone];
  const TillFloor floor = till_floor(build, ground.ground);
  const ModuleSpec spec = module_spec(build.design, *zone.zone, *zone.kinds.main);
  const std::array<Side, 2> backs = lies_along_x(floor.out) ? std::array{Side::west, Side::east}
                                                            : std::array{Side::south, Side::north};
  const int wide = across(floor.rect, backs[0]).length();
  const int wish = machine_wish(build, *zone.zone) - zone.main_modules;
  const int in_row = machines_in_row(build, zone, floor.rect, spec, backs[0]);
  const int asked =
      zone.zone->fixture.count ? wish : 0;  // a usual number is no reason for more rows
  const int rows = machine_rows(wide, spec.depth_mm, in_row, asked);
  // Two rows share the floor between them and stand no farther apart than they need to.
  const int spare =
      rows == 2 ? std::max(0, wide - 2 * spec.depth_mm - 2 * self_checkout_floor_mm) / 2 : 0;
  for (int i = 0; i < rows; ++i) {
    const int left = machine_wish(build, *zone.zone) - zone.main_modules;
    const int most =
        rows > 2 ? (left + rows - 1 - i) / (rows - i) : (rows == 2 ? (wish + 1 - i) / 2 : wish);
    const Side back = backs[static_cast<std::size_t>(i % 2)];
    const RectMm band =
        rows > 2
            ? strip_inside(floor.rect, backs[0], spec.depth_mm, machine_offset(i, spec.depth_mm))
            : strip_inside(floor.rect, back, spec.depth_mm, spare);
    const Row row{
        zone.run_id(), zone.zone, &spec, opposite(back), band, build.design.min_aisle_mm(), most};
    const std::vector<PlacedRun> runs = build.site.place(row, Packing::middle);
    if (!runs.empty()) ++zone.next_run;
    zone.count(spec.kind, runs);
  }
}

// A desk or counter with its back to a wall if the zone has one, to the zone's edge otherwise.
void place_desks(Build& build, GroundBuild& ground) {
  ZoneBuild& zone = build.zones[ground.zone];
  const ModuleSpec spec = module_spec(build.design, *zone.zone, *zone.kinds.main);
  const int wish = zone.zone->fixture.count.value_or(1) - zone.main_modules;
  std::vector<Side> backs(all_sides.begin(), all_sides.end());
  std::ranges::stable_partition(backs, [&](Side side) { return ground.ground.touches_wall(side); });
  for (const Side back : backs) {
    if (wish - zone.main_modules <= 0) return;
    const int behind_mm = spec.kind->is_desk() ? desk_staff_mm : 20;
    const RectMm band = strip_inside(ground.ground.rect, back, spec.depth_mm, behind_mm);
    const Row row{zone.run_id(),
                  zone.zone,
                  &spec,
                  opposite(back),
                  band,
                  build.design.min_aisle_mm(),
                  wish - zone.main_modules};
    const std::vector<PlacedRun> runs = build.site.place(row, Packing::middle);
    if (!runs.empty()) ++zone.next_run;
    zone.count(spec.kind, runs);
  }
}

}  // namespace

void place_checkouts(Build& build) {
  for (GroundBuild& ground : build.grounds) {
    const catalog::FixtureKind* main = build.zones[ground.zone].kinds.main;
    if (main == nullptr || main->role == catalog::FixtureRole::shelving) continue;
    if (build.zones[ground.zone].stands) continue;
    if (main->generator == "checkout_lane") {
      settle_lanes(build, ground);
      place_lanes(build, ground);
    } else if (main->generator == "self_checkout") {
      settle_machines(build, ground);
      place_machines(build, ground);
    } else {
      place_desks(build, ground);
    }
  }
}

}  // namespace marketgen::layout
