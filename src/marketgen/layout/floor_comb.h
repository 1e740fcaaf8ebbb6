// How free-standing runs and islands can stand on a zone's floor, and the choice among the ways.
#pragma once
#include <optional>
#include <vector>

#include "layout/zone_build.h"

namespace marketgen::layout {

// A way of standing: one row, or two back to back with `between_mm` of floor for staff.
struct FloorBlock {
  ModuleSpec spec;
  bool pair = false;
  int between_mm = 0;
  int depth_mm() const { return pair ? 2 * spec.depth_mm + between_mm : spec.depth_mm; }
  int faces() const { return pair || spec.sides == 2 ? 2 : 1; }
};

// Parallel blocks, and the groups along each of them.
struct FloorComb {
  FloorBlock block;
  Side front = Side::east;   // of the (first) row of each block
  std::vector<int> lows;     // where each block begins, across the runs
  std::vector<Span> groups;  // along the runs
  double score = 0;          // metres of shelf front
};

struct FloorTask {
  Build& build;
  GroundBuild& ground;
  ZoneBuild& zone;
  int aisle_mm;               // before fronts
  int habit_mm;               // what the zone's aisles should be
  int clear_mm;               // demanded before fronts
  bool share_gaps;            // leave half of the aisle to a neighbour that is not built yet
  bool stands_apart = false;  // others of the zone keep an aisle on all sides of it
};

// The endcaps a block's runs get, and the floor each takes.
struct EndcapPlan {
  bool front = false, back = false;
  int depth_mm = 0;
};

// The store's make of endcap; null where the catalogue has none.
const catalog::FixtureKind* endcap_kind(const FloorTask& task);
EndcapPlan endcaps_of(const FloorTask& task, const FloorBlock& block);

// The end of the runs that is nearer to the tills.
Side front_end(const FloorTask& task, const FloorComb& comb);
// A group along a run without the floor its endcaps need.
Span run_span(const FloorTask& task, const FloorComb& comb, Span group);
// The rows of one block's group; the second row of a pair turns its back to the first.
std::vector<Row> rows_of(const FloorTask& task, const FloorComb& comb, int low, Span group);
// Where all rows of a block can stand: rows back to back begin and end together.
std::vector<Span> common_spans(const Site& site, const std::vector<Row>& rows);

std::optional<Span> longest_span(const std::vector<Span>& spans);

// The floor that is left for free-standing fixtures when wall runs and neighbours have their
// aisles.
RectMm room_inside(const FloorTask& task);

// The way that shows the most shelf front; nothing when none holds a module.
std::optional<FloorComb> choose_comb(FloorTask task, const ModuleSpec& spec);
// The way that holds the most of the runs that are still wanted (ZoneBuild::runs_left), spread
// over the floor.
std::optional<FloorComb> choose_runs(FloorTask task, const ModuleSpec& spec);
// The way that holds the fixtures that are still wanted on the least floor, at its edge; the one
// that holds most of them when none holds all.
std::optional<FloorComb> choose_corner(const FloorTask& task, const ModuleSpec& spec);

}  // namespace marketgen::layout
