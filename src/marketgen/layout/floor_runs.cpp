#include <algorithm>
#include <array>
#include <optional>

#include "layout/floor_comb.h"

namespace marketgen::layout {
namespace {

void add_endcap(const FloorTask& task,
                const FloorComb& comb,
                const PlacedRun& run,
                const RectMm& block,
                Side end,
                std::string_view name) {
  const catalog::FixtureKind* kind = endcap_kind(task);
  if (kind == nullptr) return;
  const ModuleSpec spec = module_spec(task.build.design, *task.zone.zone, *kind);
  const int run_depth = comb.block.depth_mm();
  int width = 0;
  for (const int offered : spec.widths_mm) {
    if (offered <= run_depth) width = std::max(width, offered);
  }
  if (width == 0) return;
  const RectMm beyond = strip_beyond(block, end, spec.depth_mm);
  const int low = along(block, end).from + (run_depth - width) / 2;
  const RectMm rect = cut_along(beyond, end, {low, low + width});
  if (!task.build.site.can_stand(rect)) return;
  if (!task.build.site.is_clear(strip_beyond(rect, end, task.clear_mm))) return;
  Fixture endcap = make_module(spec, *task.zone.zone);
  endcap.id = run.run + "/" + std::string(name);
  endcap.run = endcap.id;
  endcap.endcap_of = run.run;
  endcap.x_mm = rect.center()[0];
  endcap.y_mm = rect.center()[1];
  endcap.yaw_deg = yaw_facing(end);
  endcap.width_mm = width;
  endcap.sides = 1;
  endcap.run_start = endcap.run_end = true;
  endcap.height_mm = std::min(endcap.height_mm, comb.block.spec.height_mm);
  task.build.site.add(std::move(endcap), task.clear_mm);
}

// The rows of one block between `span.from` and `span.to`; returns the first row's run.
std::optional<PlacedRun> build_rows(const FloorTask& task, std::vector<Row> rows, Span span) {
  std::optional<PlacedRun> first;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Row& row = rows[i];
    row.max_modules = task.zone.max_in_run(row.spec->kind);
    if (task.stands_apart) {  // back to back: as many on one side as on the other
      const auto sides = static_cast<int>(rows.size() - i);
      row.max_modules = std::min(row.max_modules, (row.max_modules + sides - 1) / sides);
    }
    if (task.zone.runs_left(row.spec->kind) == 0) continue;
    row.run = task.zone.run_id();
    row.band = cut_along(row.band, row.front, span);
    const std::vector<PlacedRun> placed = task.build.site.place(row, Packing::middle);
    if (placed.empty()) continue;
    ++task.zone.next_run;
    task.zone.count(row.spec->kind, placed);
    if (!first) first = placed.front();
  }
  return first;
}

// All that is free; of counted runs one a group, where it is longest.
std::vector<Span> spans_to_fill(const FloorTask& task, const std::vector<Row>& rows) {
  std::vector<Span> spans = common_spans(task.build.site, rows);
  if (!task.zone.zone->fixture.runs) return spans;
  const std::optional<Span> longest = longest_span(spans);
  return longest ? std::vector{*longest} : std::vector<Span>{};
}

void build_group(const FloorTask& task, const FloorComb& comb, int low, Span group) {
  const Side front = front_end(task, comb);
  const EndcapPlan endcaps = endcaps_of(task, comb.block);
  const std::vector<Row> rows = rows_of(task, comb, low, run_span(task, comb, group));
  const int high = low + comb.block.depth_mm();
  for (const Span& span : spans_to_fill(task, rows)) {
    const std::optional<PlacedRun> run = build_rows(task, rows, span);
    if (!run) continue;
    const RectMm block = lies_along_x(comb.front) ? RectMm{run->rect.x0, low, run->rect.x1, high}
                                                  : RectMm{low, run->rect.y0, high, run->rect.y1};
    if (comb.block.between_mm > 0) task.build.site.keep_clear(block);
    if (task.stands_apart)
      task.build.site.keep_clear(block.grown(task.build.design.min_aisle_mm()));
    if (endcaps.front) add_endcap(task, comb, *run, block, front, "endcap-front");
    if (endcaps.back) add_endcap(task, comb, *run, block, opposite(front), "endcap-back");
  }
}

void build_comb(const FloorTask& task, const std::optional<FloorComb>& comb) {
  if (!comb) return;
  const catalog::FixtureKind* kind = comb->block.spec.kind;
  for (const int low : comb->lows) {
    for (const Span& group : comb->groups) {
      if (task.zone.modules_left(kind) > 0 && task.zone.runs_left(kind) > 0)
        build_group(task, *comb, low, group);
    }
  }
}

ModuleSpec main_spec(const FloorTask& task) {
  return module_spec(task.build.design, *task.zone.zone, *task.zone.kinds.main);
}

void fill_ground(const FloorTask& task) {
  const ModuleSpec spec = main_spec(task);
  const bool counted = task.zone.zone->fixture.runs.has_value();
  build_comb(task, counted ? choose_runs(task, spec) : choose_comb(task, spec));
}

bool is_shelving(const ZoneBuild& zone) {
  return zone.kinds.main != nullptr && zone.kinds.main->role == catalog::FixtureRole::shelving;
}

FloorTask make_task(Build& build, GroundBuild& ground, ZoneBuild& zone, int aisle_mm) {
  const int clear = module_spec(build.design, *zone.zone, *zone.kinds.main).clear_mm(build.design);
  return {build, ground, zone, std::max(aisle_mm, clear), std::max(aisle_mm, clear), clear, true};
}

// Ground that can hold nothing beside its wall runs: neighbours need not leave it half of an aisle.
bool is_full(Build& build, GroundBuild& ground) {
  ZoneBuild& zone = build.zones[ground.zone];
  if (!is_shelving(zone) || zone.modules_left(zone.kinds.main) == 0 ||
      zone.runs_left(zone.kinds.main) == 0)
    return true;
  FloorTask task = make_task(build, ground, zone, wanted_aisle_mm(build.design, *zone.zone));
  task.share_gaps = false;
  const ModuleSpec spec =
      one_sided(module_spec(build.design, *task.zone.zone, *task.zone.kinds.main));
  const RectMm room = room_inside(task);
  const int least = std::min(spec.depth_mm, spec.narrowest_mm());
  return room.empty() || std::min(room.width(), room.depth()) < least;
}

}  // namespace

void stand_groups(Build& build) {
  for (GroupBuild& group : build.groups) {
    for (GroundBuild& ground : build.grounds) {
      const catalog::FixtureKind* kind = group.build.kinds.main;
      if (ground.zone != group.zone || group.build.modules_left(kind) == 0) continue;
      const int aisle = wanted_aisle_mm(build.design, *group.build.zone);
      FloorTask task = make_task(build, ground, group.build, aisle);
      task.stands_apart = true;
      const ModuleSpec spec = main_spec(task);
      const bool counted = group.build.zone->fixture.runs.has_value();
      build_comb(task, counted ? choose_runs(task, spec) : choose_corner(task, spec));
      task.aisle_mm = task.clear_mm;  // narrower, where that is what it takes
      if (!counted && group.build.modules_left(kind) > 0)
        build_comb(task, choose_corner(task, spec));
    }
  }
}

void fill_floor(Build& build) {
  for (GroundBuild& ground : build.grounds)
    ground.finished = build.zones[ground.zone].stands || is_full(build, ground);
  for (GroundBuild& ground : build.grounds) {
    if (ground.finished) continue;
    ZoneBuild& zone = build.zones[ground.zone];
    fill_ground(make_task(build, ground, zone, wanted_aisle_mm(build.design, *zone.zone)));
    ground.finished = true;
  }
}

namespace {

// Parts of a ground along its longer side, the largest first: what stands beside one end of it, as
// trolleys at the door, does not shut the rest.
std::vector<GroundBuild> parts_of(const GroundBuild& ground) {
  constexpr std::array<std::array<double, 2>, 5> shares{
      {{0, 1}, {0, 0.67}, {0.33, 1}, {0, 0.5}, {0.5, 1}}};
  const RectMm& whole = ground.ground.rect;
  const Side side = whole.width() >= whole.depth() ? Side::south : Side::west;
  const Span length = along(whole, side);
  std::vector<GroundBuild> parts;
  for (const auto& [from, to] : shares) {
    GroundBuild& part = parts.emplace_back(ground);
    const auto at = [&](double share) {
      return length.from + static_cast<int>(share * length.length());
    };
    part.ground.rect = cut_along(whole, side, {at(from), at(to)});
  }
  return parts;
}

}  // namespace

void fill_empty_zones(Build& build) {
  for (const GroundBuild& ground : build.grounds) {
    ZoneBuild& zone = build.zones[ground.zone];
    if (!is_shelving(zone) || zone.stands) continue;
    for (GroundBuild& part : parts_of(ground)) {
      if (zone.main_modules + zone.other_modules > 0) break;
      FloorTask task = make_task(build, part, zone, build.design.min_aisle_mm());
      task.share_gaps = false;
      build_comb(task, choose_comb(task, main_spec(task)));
    }
  }
}

}  // namespace marketgen::layout
