#include "layout/floor_comb.h"

#include <algorithm>
#include <array>
#include <limits>

#include "layout/staff_floor.h"

namespace marketgen::layout {
namespace {

constexpr double min_squeeze = 0.85;  // aisles give up to 15 % where that wins another run
constexpr double planned_gap_share =
    0.7;  // a plan's own gap is an aisle from this share of the habit on
constexpr double tighter_factor = 1.2;      // narrower aisles must hold this much more
constexpr double wrong_axis_factor = 1.25;  // runs along the checkout line must hold this much more
constexpr double widest_factor = 1.35;      // of the habit: wider aisles between runs look empty

// How kinds stand when no wall is behind them.
struct FloorHabit {
  std::string_view generator;
  int island_mm;  // longest group; 0 = the zone's run_max_mm
};
// Market-hall practice: tables and bins are walked round, freezers and shelves stand in long lines.
constexpr std::array<FloorHabit, 4> floor_habits{
    {{"produce_table", 5200}, {"bin", 2400}, {"pallet", 2700}, {"promo_stack", 2700}}};

int longest_group_mm(const ModuleSpec& spec, const plan::Zone& zone) {
  for (const FloorHabit& habit : floor_habits) {
    if (habit.generator == spec.kind->generator) {
      return std::max(habit.island_mm, spec.narrowest_mm());
    }
  }
  return std::max(zone.fixture.run_max_mm, spec.narrowest_mm());
}

bool neighbour_unfinished(const FloorTask& task, Side side) {
  const RectMm ahead = strip_beyond(task.ground.ground.rect, side, task.aisle_mm);
  return std::ranges::any_of(task.build.grounds, [&](const GroundBuild& other) {
    return &other != &task.ground && !other.finished &&
           marketgen::overlap(other.ground.rect, ahead);
  });
}

// The aisle at the ground's side: a gap of the plan that is nearly wide enough is taken as it is.
int aisle_at(const FloorTask& task, Side side) {
  const int gap = task.ground.ground.gap_mm[index_of(side)];
  const int planned = std::max(task.clear_mm, static_cast<int>(task.aisle_mm * planned_gap_share));
  return gap >= planned ? std::min(gap, task.aisle_mm) : task.aisle_mm;
}

// How far runs must stay from a side of the ground that has no wall run. `core` is the ground
// without its wall runs' aisles.
int inset_of(const FloorTask& task, const RectMm& core, Side side) {
  const int aisle = aisle_at(task, side);
  int inset = std::max(0, aisle - task.build.site.free_beyond(core, side, aisle));
  const int gap = task.ground.ground.gap_mm[index_of(side)];
  if (task.share_gaps && gap < aisle && neighbour_unfinished(task, side)) {
    inset = std::max(inset, (aisle - gap + 1) / 2);
  }
  return inset;
}

// Spreads `count` pieces of `size` over the span: what is left goes to the gaps, ends included.
std::vector<int> spread(Span span, int count, int size, int gap) {
  const int slack = span.length() - count * size - (count - 1) * gap;
  std::vector<int> lows;
  for (int i = 0; i < count; ++i) {
    lows.push_back(span.from + slack * (i + 1) / (count + 1) + i * (size + gap));
  }
  return lows;
}

std::vector<int> packed(Span span, int count, int size, int gap, Packing align) {
  const int used = count * size + (count - 1) * gap;
  std::vector<int> lows;
  for (int i = 0; i < count; ++i) {
    lows.push_back((align == Packing::low ? span.from : span.to - used) + i * (size + gap));
  }
  return lows;
}

// Groups along a run, with cross aisles between them.
std::vector<Span> groups_along(Span span, int longest_mm, int cross_mm) {
  const int count =
      std::max(1, (span.length() + cross_mm + longest_mm + cross_mm - 1) / (longest_mm + cross_mm));
  const int length = (span.length() - (count - 1) * cross_mm) / count;
  if (length <= 0) return {};
  std::vector<Span> groups;
  for (int i = 0; i < count; ++i) {
    const int from = span.from + i * (length + cross_mm);
    groups.push_back({from, from + length});
  }
  return groups;
}

RectMm band_of(const FloorComb& comb, int low, Span group, int offset) {
  const int from = low + offset, to = from + comb.block.spec.depth_mm;
  return lies_along_x(comb.front) ? RectMm{group.from, from, group.to, to}
                                  : RectMm{from, group.from, to, group.to};
}

double front_metres(const FloorTask& task, const FloorComb& comb) {
  double metres = 0;
  for (const int low : comb.lows) {
    for (const Span& group : comb.groups) {
      const std::vector<Row> rows = rows_of(task, comb, low, run_span(task, comb, group));
      for (const Span& span : common_spans(task.build.site, rows)) {
        for (const int width : fill_widths(comb.block.spec, span.length())) {
          metres += 1e-3 * width * comb.block.faces();
        }
      }
    }
  }
  return metres;
}

// Blocks side by side at the wanted aisle, or one more at up to 15 % less.
int block_count(const FloorTask& task, int room_mm, int depth_mm) {
  const int count = (room_mm + task.aisle_mm) / (depth_mm + task.aisle_mm);
  if (count == 0 || task.zone.zone->fixture.aisle_mm) return count;
  const int squeezed = (room_mm - (count + 1) * depth_mm) / count;
  const int least = std::max(task.clear_mm, static_cast<int>(task.habit_mm * min_squeeze));
  return squeezed >= least ? count + 1 : count;
}

std::optional<FloorComb> best_comb_along(const FloorTask& task,
                                         const FloorBlock& block,
                                         const RectMm& room,
                                         bool along_y) {
  FloorComb comb{block, along_y ? Side::east : Side::south, {}, {}, 0};
  const Span wide = along_y ? Span{room.x0, room.x1} : Span{room.y0, room.y1};
  const Span deep = along_y ? Span{room.y0, room.y1} : Span{room.x0, room.x1};
  const int count = block_count(task, wide.length(), block.depth_mm());
  if (count <= 0 || deep.length() < block.spec.narrowest_mm()) return std::nullopt;
  const int gap = std::min(
      task.aisle_mm, count > 1 ? (wide.length() - count * block.depth_mm()) / (count - 1) : 0);
  comb.groups = groups_along(deep,
                             longest_group_mm(block.spec, *task.zone.zone),
                             task.build.design.profile.cross_aisle_mm);
  std::optional<FloorComb> best;
  // Spread evenly looks best; packed to one side can miss a column.
  for (const std::vector<int>& lows : {spread(wide, count, block.depth_mm(), gap),
                                       packed(wide, count, block.depth_mm(), gap, Packing::low),
                                       packed(wide, count, block.depth_mm(), gap, Packing::high)}) {
    comb.lows = lows;
    comb.score = front_metres(task, comb);
    if (comb.score > 0 && (!best || comb.score > best->score)) best = comb;
  }
  return best;
}

// Runs stand across the checkout line, so that tills look down the aisles.
bool prefers_along_y(const FloorTask& task) {
  const Doorway* exit = exit_of(task.build.design.floor, task.build.design.plan.shell);
  return exit == nullptr || lies_along_x(exit->wall);
}

std::optional<FloorComb> best_comb(const FloorTask& task,
                                   const FloorBlock& block,
                                   const RectMm& room) {
  const plan::RunAxis wish = task.zone.zone->fixture.axis;
  const bool preferred =
      wish == plan::RunAxis::automatic ? prefers_along_y(task) : wish == plan::RunAxis::y;
  std::optional<FloorComb> main = best_comb_along(task, block, room, preferred);
  if (main && wish != plan::RunAxis::automatic) return main;
  std::optional<FloorComb> other = best_comb_along(task, block, room, !preferred);
  if (!main || (other && other->score > main->score * wrong_axis_factor)) return other;
  return main;
}

// A single row facing the side with the most floor before it, for ground too narrow for two faces.
std::optional<FloorComb> best_single(const FloorTask& task,
                                     const ModuleSpec& spec,
                                     const RectMm& room) {
  std::optional<FloorComb> best;
  for (const Side front : all_sides) {
    FloorComb comb{{one_sided(spec), false, 0}, front, {}, {}, 0};
    const Span wide = across(room, front), deep = along(room, front);
    if (wide.length() < comb.block.spec.depth_mm) continue;
    const bool low = front == Side::east || front == Side::north;
    comb.lows = {low ? wide.from : wide.to - comb.block.spec.depth_mm};
    comb.groups = groups_along(
        deep, longest_group_mm(spec, *task.zone.zone), task.build.design.profile.cross_aisle_mm);
    comb.score = front_metres(task, comb);
    if (comb.score > 0 && (!best || comb.score > best->score)) best = comb;
  }
  return best;
}

FloorBlock block_of(const ModuleSpec& spec) {
  return {spec, spec.sides == 1, is_counter(*spec.kind) ? staff_aisle_mm : 0};
}

// The best way to stand, with shoppers on both sides of every block.
std::optional<FloorComb> double_faced(const FloorTask& task, const ModuleSpec& spec) {
  const RectMm room = room_inside(task);
  return room.empty() ? std::nullopt : best_comb(task, block_of(spec), room);
}

// ---- Runs that are counted ----

int modules_in(const ModuleSpec& spec, const Span& span) {
  return static_cast<int>(fill_widths(spec, span.length()).size());
}

// Lines that the comb's groups can hold, each with the modules that a wanted run needs.
int lines_in(const FloorTask& task, const FloorComb& comb) {
  const int least = task.zone.min_in_run(comb.block.spec.kind);
  int lines = 0;
  for (const int low : comb.lows) {
    for (const Span& group : comb.groups) {
      const std::vector<Row> rows = rows_of(task, comb, low, run_span(task, comb, group));
      const std::optional<Span> span = longest_span(common_spans(task.build.site, rows));
      if (span && modules_in(comb.block.spec, *span) >= least)
        lines += static_cast<int>(rows.size());
    }
  }
  return lines;
}

// In the middle of the span, the aisles as wide as habit has them at most.
std::vector<int> centred(Span span, int count, int size, int gap) {
  const int used = count * size + (count - 1) * gap;
  return packed({span.from + (span.length() - used) / 2, span.to}, count, size, gap, Packing::low);
}

std::optional<FloorComb> best_runs_along(const FloorTask& task,
                                         const FloorBlock& block,
                                         const RectMm& room,
                                         bool along_y) {
  FloorComb comb{block, along_y ? Side::east : Side::south, {}, {}, 0};
  const Span wide = along_y ? Span{room.x0, room.x1} : Span{room.y0, room.y1};
  const Span deep = along_y ? Span{room.y0, room.y1} : Span{room.x0, room.x1};
  const int in_block = block.pair ? 2 : 1, size = block.depth_mm();
  const int blocks = (task.zone.runs_left(block.spec.kind) + in_block - 1) / in_block;
  const int beside = std::min(blocks, (wide.length() + task.aisle_mm) / (size + task.aisle_mm));
  if (beside <= 0) return std::nullopt;
  const int behind = (blocks + beside - 1) / beside;  // one behind the other
  const int cross = task.build.design.profile.cross_aisle_mm;
  const int length = std::min(longest_group_mm(block.spec, *task.zone.zone),
                              (deep.length() - (behind - 1) * cross) / behind);
  if (length < block.spec.narrowest_mm()) return std::nullopt;
  const int first = deep.from + (deep.length() - behind * length - (behind - 1) * cross) / 2;
  for (int i = 0; i < behind; ++i) {
    const int from = first + i * (length + cross);
    comb.groups.push_back({from, from + length});
  }
  const int count = (blocks + behind - 1) / behind;
  const int loosest = count > 1 ? (wide.length() - count * size) / (count - 1) : 0;
  const bool said = task.zone.zone->fixture.aisle_mm.has_value();
  const int widest = said ? task.aisle_mm : static_cast<int>(task.aisle_mm * widest_factor);
  std::optional<FloorComb> best;
  for (const std::vector<int>& lows :
       {centred(wide, count, size, std::min(loosest, widest)),
        packed(wide, count, size, std::min(loosest, task.aisle_mm), Packing::low),
        packed(wide, count, size, std::min(loosest, task.aisle_mm), Packing::high)}) {
    comb.lows = lows;
    comb.score = lines_in(task, comb);
    if (comb.score > 0 && (!best || comb.score > best->score)) best = comb;
  }
  return best;
}

// ---- Fixtures that are counted, at the edge of a floor that others use too ----

struct Corner {
  FloorComb comb;
  int modules = 0;  // of those wanted
  double cost = 0;  // floor that it takes from what it is cut from, and its way from the door
};

int modules_of(const FloorTask& task, const FloorComb& comb) {
  int modules = 0;
  for (const int low : comb.lows) {
    for (const Span& group : comb.groups) {
      const std::vector<Row> rows = rows_of(task, comb, low, group);
      for (const Span& span : common_spans(task.build.site, rows))
        modules += modules_in(comb.block.spec, span) * static_cast<int>(rows.size());
    }
  }
  return modules;
}

// Blocks of the comb from one edge of the room inwards, as few as hold what is wanted.
Corner corner_at(const FloorTask& task, FloorComb comb, const RectMm& room, Packing edge) {
  constexpr double mm_per_metre_away = 50;  // a metre nearer to the door is worth this much floor
  const Side front = comb.front;
  const Span wide = across(room, front);
  const int size = comb.block.depth_mm();
  const int wanted = task.zone.modules_left(comb.block.spec.kind);
  comb.groups = groups_along(
      along(room, front), longest_group_mm(comb.block.spec, *task.zone.zone), task.clear_mm);
  Corner corner{comb, 0, 0};
  for (int count = 1; count * (size + task.aisle_mm) - task.aisle_mm <= wide.length(); ++count) {
    comb.lows = packed(wide, count, size, task.aisle_mm, edge);
    const int modules = std::min(wanted, modules_of(task, comb));
    if (modules > corner.modules) corner = {comb, modules, 0};
    if (modules == wanted) break;
  }
  if (corner.modules == 0) return corner;
  const auto lines = static_cast<int>(corner.comb.lows.size());
  corner.cost = lines * (size + task.aisle_mm);
  const Doorway* door = entrance_of(task.build.design.floor, task.build.design.plan.shell);
  if (door == nullptr) return corner;
  const int middle = (corner.comb.lows.front() + corner.comb.lows.back() + size) / 2;
  const PointMm center = room.center();
  const PointMm at = lies_along_x(front) ? PointMm{center[0], middle} : PointMm{middle, center[1]};
  corner.cost +=
      mm_per_metre_away * 1e-3 * distance_mm(point_rect(at), point_rect(door->threshold));
  return corner;
}

std::vector<FloorBlock> blocks_of(const ModuleSpec& spec) {
  if (spec.sides == 2) return {{spec, false, 0}};
  return {{spec, false, 0}, block_of(spec)};
}

}  // namespace

std::optional<Span> longest_span(const std::vector<Span>& spans) {
  const auto longest = std::ranges::max_element(spans, {}, &Span::length);
  return longest == spans.end() ? std::nullopt : std::optional(*longest);
}

RectMm room_inside(const FloorTask& task) {
  RectMm core = task.ground.ground.rect;
  for (const Side side : all_sides) {
    const int lined = task.ground.lined_mm[index_of(side)];
    if (lined > 0) core = moved_side(core, side, lined + task.aisle_mm);
  }
  if (core.empty()) return core;
  RectMm room = core;
  for (const Side side : all_sides) {
    if (task.ground.lined_mm[index_of(side)] == 0)
      room = moved_side(room, side, inset_of(task, core, side));
  }
  return room;
}

Side front_end(const FloorTask& task, const FloorComb& comb) {
  const std::array<Side, 2> ends = lies_along_x(comb.front) ? std::array{Side::west, Side::east}
                                                            : std::array{Side::south, Side::north};
  const Doorway* exit = exit_of(task.build.design.floor, task.build.design.plan.shell);
  if (exit == nullptr) return ends[0];
  if (exit->wall == ends[0] || exit->wall == ends[1]) return exit->wall;
  const PointMm middle = task.ground.ground.rect.center();
  const std::size_t axis = lies_along_x(comb.front) ? 0 : 1;
  return exit->threshold[axis] < middle[axis] ? ends[0] : ends[1];
}

const catalog::FixtureKind* endcap_kind(const FloorTask& task) {
  const Design& design = task.build.design;
  const catalog::FixtureKind* kind = design.catalog.fixture_kind("endcap");
  return kind == nullptr ? nullptr : &design.makes.of(*kind, task.zone.zone->type);
}

EndcapPlan endcaps_of(const FloorTask& task, const FloorBlock& block) {
  const plan::Endcaps wish = task.zone.zone->fixture.endcaps;
  const catalog::FixtureKind* kind = endcap_kind(task);
  if (kind == nullptr || block.faces() < 2 || block.between_mm > 0 ||
      block.spec.kind->generator != "gondola")
    return {};
  return {wish == plan::Endcaps::front || wish == plan::Endcaps::both,
          wish == plan::Endcaps::back || wish == plan::Endcaps::both,
          kind->depth_mm};
}

Span run_span(const FloorTask& task, const FloorComb& comb, Span group) {
  const EndcapPlan endcaps = endcaps_of(task, comb.block);
  const Side front = front_end(task, comb);
  const bool front_is_low = front == Side::south || front == Side::west;
  const int at_front = endcaps.front ? endcaps.depth_mm : 0;
  const int at_back = endcaps.back ? endcaps.depth_mm : 0;
  return {group.from + (front_is_low ? at_front : at_back),
          group.to - (front_is_low ? at_back : at_front)};
}

std::vector<Row> rows_of(const FloorTask& task, const FloorComb& comb, int low, Span group) {
  const FloorBlock& block = comb.block;
  const bool faces_high = comb.front == Side::east || comb.front == Side::north;
  const int second = block.spec.depth_mm + block.between_mm;
  Row row{{},
          task.zone.zone,
          &block.spec,
          comb.front,
          {},
          task.clear_mm,
          std::numeric_limits<int>::max()};
  row.band = band_of(comb, low, group, block.pair && faces_high ? second : 0);
  std::vector<Row> rows{row};
  if (!block.pair) return rows;
  row.front = opposite(comb.front);
  row.band = band_of(comb, low, group, faces_high ? 0 : second);
  rows.push_back(row);
  return rows;
}

std::vector<Span> common_spans(const Site& site, const std::vector<Row>& rows) {
  std::vector<Span> common = site.free_spans(rows.front());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    std::vector<Span> both;
    for (const Span& a : common) {
      for (const Span& b : site.free_spans(rows[i])) {
        const Span span = intersection(a, b);
        if (span.length() >= rows[i].spec->narrowest_mm()) both.push_back(span);
      }
    }
    common = both;
  }
  return common;
}

// Aisles as wide as habit has them; a little narrower where that holds clearly more; as narrow as
// allowed, and at last from one side only, where there would be nothing otherwise.
std::optional<FloorComb> choose_comb(FloorTask task, const ModuleSpec& spec) {
  std::optional<FloorComb> comb = double_faced(task, spec);
  if (!task.zone.zone->fixture.aisle_mm) {
    task.aisle_mm = std::max(task.clear_mm, static_cast<int>(task.habit_mm * min_squeeze));
    const std::optional<FloorComb> tighter = double_faced(task, spec);
    if (tighter && (!comb || tighter->score > comb->score * tighter_factor)) comb = tighter;
  }
  if (comb) return comb;
  task.aisle_mm = task.clear_mm;
  comb = double_faced(task, spec);
  for (const int aisle : {task.habit_mm, task.clear_mm}) {
    if (comb || task.zone.main_modules + task.zone.other_modules > 0) return comb;
    task.aisle_mm = aisle;
    const RectMm room = room_inside(task);
    if (!room.empty()) comb = best_single(task, spec, room);
  }
  return comb;
}

std::optional<FloorComb> choose_runs(FloorTask task, const ModuleSpec& spec) {
  const plan::FixtureSpec& wish = task.zone.zone->fixture;
  const bool apart = wish.double_sided.has_value() && !*wish.double_sided;
  const FloorBlock block = apart ? FloorBlock{spec, false, 0} : block_of(spec);
  const int wanted = task.zone.runs_left(spec.kind);
  const bool preferred =
      wish.axis == plan::RunAxis::automatic ? prefers_along_y(task) : wish.axis == plan::RunAxis::y;
  std::optional<FloorComb> best;
  for (const int aisle : {task.habit_mm, task.clear_mm}) {
    task.aisle_mm = aisle;
    const RectMm room = room_inside(task);
    for (const bool along_y : {preferred, !preferred}) {
      if (room.empty() || (best && best->score >= wanted)) continue;
      const std::optional<FloorComb> comb = best_runs_along(task, block, room, along_y);
      if (comb && (!best || comb->score > best->score)) best = comb;
    }
  }
  return best;
}

std::optional<FloorComb> choose_corner(const FloorTask& task, const ModuleSpec& spec) {
  const RectMm room = room_inside(task);
  if (room.empty()) return std::nullopt;
  Corner best;
  for (const FloorBlock& block : blocks_of(spec)) {
    for (const Side front : all_sides) {
      const bool repeated = block.faces() == 2 && (front == Side::north || front == Side::west);
      if (repeated) continue;
      for (const Packing edge : {Packing::low, Packing::high}) {
        const Corner corner = corner_at(task, {block, front, {}, {}, 0}, room, edge);
        const bool better = corner.modules > best.modules ||
                            (corner.modules == best.modules && corner.cost < best.cost);
        if (corner.modules > 0 && better) best = corner;
      }
    }
  }
  return best.modules > 0 ? std::optional(best.comb) : std::nullopt;
}

}  // namespace marketgen::layout
