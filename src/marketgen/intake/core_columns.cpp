#include "intake/core_columns.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "intake/strips.h"
#include "intake/zone_sizes.h"
#include "plan/bsp.h"

namespace marketgen::intake {
namespace {

constexpr int wall_shelf_mm = 610;     // a wall unit with its skirting
constexpr int stacked_cell_mm = 4200;  // worth a cross aisle
constexpr double widest_aisle = 1.35;  // of the habitual width: wider looks empty
constexpr int fit_margin_mm = 12;      // so that rounding never costs a run

// Zones one behind the other, and how many runs stand side by side.
struct CoreColumn {
  std::vector<int> zones;
  int runs = 1;
  int max_runs = 99;
  bool measured = false;  // for what is counted in it
  int beside_mm = 0;      // of what stands there besides, its aisle included
  bool counted = false;   // the words count them: they may stand one behind the other
  int asked_mm = 0;       // its width, where the words say how large the zone is
  int line_mm = 0;
  double target_m2 = 0;

  int width(int aisle) const {
    if (asked_mm > 0) return asked_mm;
    return runs * line_mm + (runs - 1) * aisle + beside_mm + fit_margin_mm;
  }
};

// A zone whose floor was asked for in numbers is as wide as that makes it, and has as many runs as
// stand there. One that would be narrower than a run shares a column instead.
void ask_for_width(CoreColumn& column,
                   const ProgramZone& zone,
                   const StoreProgram& program,
                   int depth_mm) {
  if (!zone.wanted_m2 || zone.wanted_how == plan::Comparison::at_most) return;
  const auto width = static_cast<int>(*zone.wanted_m2 * 1e6 / std::max(1, depth_mm));
  const int aisle = program.aisle_mm.value_or(program.profile->secondary_aisle_mm);
  if (width < column.line_mm + fit_margin_mm) return;
  column.asked_mm = width;
  const int fit = std::max(1, (width - column.beside_mm + aisle) / (column.line_mm + aisle));
  column.runs = column.max_runs = std::min(fit, column.max_runs);
}

CoreColumn column_of(int zone, const StoreProgram& program, int depth_mm) {
  const ProgramZone& row = program.zones[static_cast<std::size_t>(zone)];
  CoreColumn column;
  column.zones = {zone};
  column.line_mm = line_depth_mm(row, *program.profile);
  column.target_m2 = row.target_m2;
  // An island freezer is two rows back to back.
  const bool island = row.kind != nullptr && row.kind->generator == "island_freezer";
  if (row.rows) column.runs = column.max_runs = island ? (*row.rows + 1) / 2 : *row.rows;
  const auto lines = counted_lines(row, depth_mm);
  if (lines) column.max_runs = *lines;
  const double share = program.counted_share;
  if (lines && share > 0) column.runs = std::max(1, static_cast<int>(std::lround(share * *lines)));
  column.counted = row.main.runs.has_value();
  column.beside_mm = static_cast<int>(share * beside_depth_mm(row, depth_mm));
  ask_for_width(column, row, program, depth_mm);
  column.measured = column.asked_mm > 0 || column.beside_mm > 0 || (lines && share > 0);
  return column;
}

CoreColumn merged(const CoreColumn& a, const CoreColumn& b) {
  CoreColumn column = a;
  column.zones.insert(column.zones.end(), b.zones.begin(), b.zones.end());
  column.runs = std::max(a.runs, b.runs);
  column.max_runs = std::min(a.max_runs, b.max_runs);
  column.line_mm = std::max(a.line_mm, b.line_mm);
  column.beside_mm = std::max(a.beside_mm, b.beside_mm);
  column.asked_mm = 0;  // the two share its depth as they were asked to
  column.measured = a.measured || b.measured;
  column.target_m2 += b.target_m2;
  return column;
}

int width_of(const std::vector<CoreColumn>& columns, int aisle) {
  int width = (static_cast<int>(columns.size()) - 1) * aisle;
  for (const CoreColumn& column : columns)
    width += column.width(aisle);
  return width;
}

int runs_of(const std::vector<CoreColumn>& columns) {
  return std::accumulate(columns.begin(), columns.end(), 0, [](int sum, const CoreColumn& column) {
    return sum + column.runs;
  });
}

// Puts the two neighbours with the least floor one behind the other.
void merge_smallest(std::vector<CoreColumn>& columns) {
  const auto loss = [&](std::size_t i) {  // what is counted has no room in half of a column
    const bool measured = columns[i].measured || columns[i + 1].measured;
    return std::pair{measured, columns[i].target_m2 + columns[i + 1].target_m2};
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i + 1 < columns.size(); ++i) {
    if (loss(i) < loss(best)) best = i;
  }
  columns[best] = merged(columns[best], columns[best + 1]);
  columns.erase(columns.begin() + static_cast<std::ptrdiff_t>(best) + 1);
}

// Puts the counted runs of the widest column one behind the other. False when none may.
bool put_behind(std::vector<CoreColumn>& columns,
                const StoreProgram& program,
                const CoreRoom& room) {
  CoreColumn* widest = nullptr;
  for (CoreColumn& column : columns) {
    const int wanted = column.max_runs, behind = (wanted + column.runs - 1) / column.runs + 1;
    const int least = behind * min_cell_mm + (behind - 1) * program.profile->cross_aisle_mm;
    const bool may = column.counted && column.runs > 1 && least <= room.depth_mm;
    if (may && (widest == nullptr || column.runs > widest->runs)) widest = &column;
  }
  if (widest == nullptr) return false;
  const int behind = (widest->max_runs + widest->runs - 1) / widest->runs + 1;
  // Four runs, three behind one another, are still two abreast: then one, four behind one another.
  widest->runs = std::min(widest->runs - 1, (widest->max_runs + behind - 1) / behind);
  return true;
}

std::vector<CoreColumn> stacked_columns(std::vector<CoreColumn> columns, int depth_mm) {
  if (depth_mm < 2 * stacked_cell_mm) return columns;
  std::vector<CoreColumn> pairs;
  for (std::size_t i = 0; i < columns.size();) {
    const bool pair = i + 1 < columns.size() && !columns[i].measured && !columns[i + 1].measured;
    pairs.push_back(pair ? merged(columns[i], columns[i + 1]) : columns[i]);
    i += pair ? 2 : 1;
  }
  return pairs;
}

// Adds runs where the target is least met, while they fit.
void grow(std::vector<CoreColumn>& columns, int width_mm, int aisle, int max_runs) {
  while (runs_of(columns) < max_runs) {
    CoreColumn* neediest = nullptr;
    for (CoreColumn& column : columns) {
      const bool fits = width_of(columns, aisle) + column.line_mm + aisle <= width_mm;
      if (!fits || column.runs >= column.max_runs) continue;
      const auto need = [](const CoreColumn& c) { return c.target_m2 / (c.runs * c.line_mm); };
      if (neediest == nullptr || need(column) > need(*neediest)) neediest = &column;
    }
    if (neediest == nullptr) return;
    ++neediest->runs;
  }
}

// The aisle that uses up the width, within reason. Shelves on the room's walls have one before them
// too.
int fitted_aisle(const std::vector<CoreColumn>& columns,
                 const CoreRoom& room,
                 const StoreProgram& program) {
  const int walls = (room.wall_west ? 1 : 0) + (room.wall_east ? 1 : 0);
  const int gaps = runs_of(columns) - 1 + walls;
  if (gaps <= 0 || program.aisle_mm) return room.run_aisle_mm;
  int fixtures = walls * wall_shelf_mm;
  for (const CoreColumn& column : columns)
    fixtures += column.runs * column.line_mm + column.beside_mm + fit_margin_mm;
  const int fitted = (room.width_mm - fixtures) / gaps;
  const int least = std::min(room.run_aisle_mm, program.profile->minimum_aisle_mm + 100);
  const int most = static_cast<int>(room.run_aisle_mm * widest_aisle);
  return std::clamp(fitted, least, most);
}

// Widths of all columns. What is left over, or lacking, is shared among those whose width nobody
// asked for.
std::vector<int> with_spare(const std::vector<CoreColumn>& columns, int aisle, int spare_mm) {
  const auto open = [](const CoreColumn& column) { return column.asked_mm == 0; };
  auto left = static_cast<int>(std::ranges::count_if(columns, open));
  const bool all = left == 0;
  if (all) left = static_cast<int>(columns.size());
  const int share = spare_mm / left, rest = spare_mm % left;
  std::vector<int> sizes;
  for (const CoreColumn& column : columns) {
    int size = column.width(aisle);
    if (all || open(column)) size += share + (--left == 0 ? rest : 0);
    sizes.push_back(size);
  }
  return sizes;
}

Slice slice_of(const CoreColumn& column, const StoreProgram& program, int depth_mm) {
  if (column.zones.size() == 1) return zone_slice(column.zones[0]);
  const bool roomy = depth_mm >= 2 * stacked_cell_mm;
  const int gap = roomy ? program.profile->cross_aisle_mm : program.profile->secondary_aisle_mm;
  return make_strip(
             column.zones, program, {plan::Axis::y, depth_mm, column.width(0), gap, min_cell_mm})
      .slice;
}

}  // namespace

Core make_core(const std::vector<int>& zones,
               const StoreProgram& program,
               const CoreRoom& room,
               bool stacked) {
  std::vector<CoreColumn> columns;
  for (const int zone : zones)
    columns.push_back(column_of(zone, program, room.depth_mm));
  if (stacked) columns = stacked_columns(std::move(columns), room.depth_mm);
  const auto on_wall = [](bool wall, int aisle) { return wall ? wall_shelf_mm + aisle : 0; };
  const int width = room.width_mm - on_wall(room.wall_west, room.run_aisle_mm) -
                    on_wall(room.wall_east, room.run_aisle_mm);
  while (width_of(columns, room.run_aisle_mm) > width && put_behind(columns, program, room)) {
  }
  while (columns.size() > 1 && width_of(columns, room.run_aisle_mm) > width) {
    merge_smallest(columns);
  }
  // n aisles lie between n + 1 lines; the lines on the two sides of the core are not its own.
  const int max_runs = program.aisles ? std::max(1, *program.aisles - 1) : 99;
  const int narrow = program.aisles ? program.profile->minimum_aisle_mm + 200 : room.run_aisle_mm;
  grow(columns, width, narrow, max_runs);

  Core core;
  core.run_aisle_mm = fitted_aisle(columns, room, program);
  const int at_west = on_wall(room.wall_west, core.run_aisle_mm);
  const int at_east = on_wall(room.wall_east, core.run_aisle_mm);
  core.runs = runs_of(columns);
  core.slice = cut_slice(plan::Axis::x);
  const int used = at_west + width_of(columns, core.run_aisle_mm) + at_east;
  core.crowding += std::max(0, used - room.width_mm) * 1e-3;
  int spare = room.width_mm - used;  // negative when too narrow: rectangles still add up
  // Aisles that were asked to be so wide are, but for one that takes what is left over.
  const bool exact = program.aisle_mm && program.aisle_how == plan::Comparison::equal;
  const int in_one_aisle =
      exact && columns.size() > 1
          ? std::clamp(spare, 0, std::max(0, plan::max_gap_mm - core.run_aisle_mm))
          : 0;
  spare -= in_one_aisle;
  std::vector<int> sizes = with_spare(columns, core.run_aisle_mm, spare);
  sizes.front() += at_west;
  sizes.back() += at_east;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (std::size_t k = 1; k < columns[i].zones.size(); ++k) {
      const int cell = room.depth_mm / static_cast<int>(columns[i].zones.size());
      core.crowding += std::max(0, min_cell_mm - cell) * 1e-3;
    }
    const bool widest = i + 1 == columns.size();
    const int gap = core.run_aisle_mm + (widest ? in_one_aisle : 0);
    core.slice.add(slice_of(columns[i], program, room.depth_mm), sizes[i], gap);
  }
  core.slice = simplified(std::move(core.slice));
  return core;
}

}  // namespace marketgen::intake
