#include <algorithm>
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
  const catalog::FixtureKind* kind = task.build.design.catalog.fixture_kind("endcap");
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
  for (Row& row : rows) {
    row.max_modules = task.zone.modules_left(row.spec->kind);
    row.run = task.zone.zone->id + "/run-" + std::to_string(task.zone.next_run);
    row.band = cut_along(row.band, row.front, span);
    const std::vector<PlacedRun> placed = task.build.site.place(row, Packing::middle);
    if (placed.empty()) continue;
    ++task.zone.next_run;
    task.zone.count(row.spec->kind, placed);
    if (!first) first = placed.front();
  }
  return first;
}

void build_group(const FloorTask& task, const FloorComb& comb, int low, Span group) {
  const Side front = front_end(task, comb);
  const EndcapPlan endcaps = endcaps_of(task, comb.block);
  const std::vector<Row> rows = rows_of(task, comb, low, run_span(task, comb, group));
  const int high = low + comb.block.depth_mm();
  for (const Span& span : common_spans(task.build.site, rows)) {
    const std::optional<PlacedRun> run = build_rows(task, rows, span);
    if (!run) continue;
    const RectMm block = lies_along_x(comb.front) ? RectMm{run->rect.x0, low, run->rect.x1, high}
                                                  : RectMm{low, run->rect.y0, high, run->rect.y1};
    if (comb.block.between_mm > 0) task.build.site.keep_clear(block);
    if (endcaps.front) add_endcap(task, comb, *run, block, front, "endcap-front");
    if (endcaps.back) add_endcap(task, comb, *run, block, opposite(front), "endcap-back");
  }
}

void fill_ground(const FloorTask& task) {
  const ModuleSpec spec = module_spec(task.build.design, *task.zone.zone, *task.zone.kinds.main);
  const std::optional<FloorComb> comb = choose_comb(task, spec);
  if (!comb) return;
  for (const int low : comb->lows) {
    for (const Span& group : comb->groups) {
      if (task.zone.modules_left(spec.kind) > 0) build_group(task, *comb, low, group);
    }
  }
}

bool is_shelving(const ZoneBuild& zone) {
  return zone.kinds.main != nullptr && zone.kinds.main->role == catalog::FixtureRole::shelving;
}

FloorTask make_task(Build& build, GroundBuild& ground, int aisle_mm) {
  ZoneBuild& zone = build.zones[ground.zone];
  const int clear = module_spec(build.design, *zone.zone, *zone.kinds.main).clear_mm(build.design);
  return {build, ground, zone, std::max(aisle_mm, clear), std::max(aisle_mm, clear), clear, true};
}

// Ground that can hold nothing beside its wall runs: neighbours need not leave it half of an aisle.
bool is_full(Build& build, GroundBuild& ground) {
  if (!is_shelving(build.zones[ground.zone])) return true;
  FloorTask task =
      make_task(build, ground, wanted_aisle_mm(build.design, *build.zones[ground.zone].zone));
  task.share_gaps = false;
  const ModuleSpec spec =
      one_sided(module_spec(build.design, *task.zone.zone, *task.zone.kinds.main));
  const RectMm room = room_inside(task);
  const int least = std::min(spec.depth_mm, spec.narrowest_mm());
  return room.empty() || std::min(room.width(), room.depth()) < least;
}

}  // namespace

void fill_floor(Build& build) {
  for (GroundBuild& ground : build.grounds)
    ground.finished = build.zones[ground.zone].stands || is_full(build, ground);
  for (GroundBuild& ground : build.grounds) {
    if (ground.finished) continue;
    const plan::Zone& zone = *build.zones[ground.zone].zone;
    fill_ground(make_task(build, ground, wanted_aisle_mm(build.design, zone)));
    ground.finished = true;
  }
}

void fill_empty_zones(Build& build) {
  for (GroundBuild& ground : build.grounds) {
    ZoneBuild& zone = build.zones[ground.zone];
    if (!is_shelving(zone) || zone.stands || zone.main_modules + zone.other_modules > 0) continue;
    fill_ground(make_task(build, ground, build.design.min_aisle_mm()));
  }
}

}  // namespace marketgen::layout
