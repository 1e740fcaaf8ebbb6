#include "intake/zone_sizes.h"

#include <algorithm>

#include "plan/bsp.h"

namespace marketgen::intake {
namespace {

constexpr int back_panel_mm = 60;   // between the two sides of a gondola
constexpr int wall_margin_mm = 60;  // skirting behind a wall unit
constexpr int staff_floor_mm =
    1000;                            // behind a counter: one person works, another passes (Neufert)
constexpr int passage_mm = 1000;     // beside a lane: ADA 904.3 asks for 36 in
constexpr int lane_margin_mm = 100;  // so that rounding never costs a lane
constexpr int packing_floor_mm = 1300;  // behind the tills: a packed trolley turns round
constexpr int exit_floor_mm = 2050;     // kept free inside a door (layout: approach_depth_mm)
constexpr double small_store_m2 = 450;  // below, lanes are short

bool has_staff_side(const catalog::FixtureKind& kind) {
  return kind.generator == "serve_over";
}

// The kind that lines the walls of a zone whose own fixtures stand free.
const catalog::FixtureKind* kind_on_walls(const catalog::FixtureKind& kind,
                                          const catalog::Catalog& catalog) {
  if (kind.against_wall || kind.generator == "produce_table" || has_staff_side(kind)) return &kind;
  if (kind.temperature == catalog::Storage::frozen)
    return catalog.fixture_kind("glass_door_freezer");
  return catalog.fixture_kind("wall_unit");
}

}  // namespace

int line_depth_mm(const ProgramZone& zone, const catalog::ProfileRow& profile) {
  if (zone.kind == nullptr) return plan::min_node_side_mm;
  const catalog::FixtureKind& kind = *zone.kind;
  if (kind.generator == "gondola") return 2 * profile.gondola_shelf_mm + back_panel_mm;
  if (kind.double_sided) return kind.depth_mm;
  return 2 * kind.depth_mm + (has_staff_side(kind) ? staff_floor_mm : 0);
}

int wall_depth_mm(const ProgramZone& zone, const catalog::Catalog& catalog) {
  if (zone.kind == nullptr) return 3 * plan::min_node_side_mm;  // a room without fixtures: storage
  const catalog::FixtureKind* kind = kind_on_walls(*zone.kind, catalog);
  int depth = (kind != nullptr ? kind->depth_mm : zone.kind->depth_mm) + wall_margin_mm;
  if (has_staff_side(*zone.kind)) depth += staff_floor_mm + staff_floor_mm / 2;
  return std::max(depth, plan::min_node_side_mm + wall_margin_mm);
}

int hall_depth_mm(const ProgramZone& zone,
                  const catalog::ProfileRow& profile,
                  const catalog::Catalog& catalog) {
  const int on_wall = wall_depth_mm(zone, catalog);
  return on_wall + profile.secondary_aisle_mm + line_depth_mm(zone, profile);
}

int till_width_mm(const ProgramZone& zone, int front_depth_mm) {
  if (zone.kind == nullptr) return 3 * plan::min_node_side_mm;
  const int width = zone.kind->module_widths_mm.front();
  if (zone.kind->generator == "checkout_lane") {
    return zone.count.value_or(1) * (width + passage_mm) + passage_mm + lane_margin_mm;
  }
  if (zone.kind->generator == "self_checkout") {  // rows run from the exit inwards
    const int machines_a_row = std::max(1, (front_depth_mm - passage_mm / 2) / width);
    const int rows = zone.count.value_or(2) > machines_a_row ? 2 : 1;
    return rows * zone.kind->depth_mm + 2 * passage_mm;
  }
  if (!zone.kind->is_desk()) return width + passage_mm;
  return desk_room_mm(*zone.kind) + static_cast<int>(zone.kind->front_clearance_mm);
}

int desk_room_mm(const catalog::FixtureKind& kind) {
  return staff_floor_mm + kind.depth_mm;
}

int lane_length_mm(const catalog::FixtureKind& lane, const StoreProgram& program) {
  return program.area_m2() < small_store_m2 ? lane.depth_range_mm[0] : lane.depth_mm;
}

int front_depth_mm(const StoreProgram& program, const catalog::Catalog& catalog, int gap_mm) {
  for (const ProgramZone& zone : program.zones) {
    if (zone.type->type == "checkout" && zone.kind != nullptr && zone.kind->is_desk())
      return std::max(exit_floor_mm, zone.kind->module_widths_mm.front() + passage_mm);
  }
  const catalog::FixtureKind* lane = catalog.fixture_kind("checkout_lane");
  const int length = lane != nullptr ? lane_length_mm(*lane, program) : 3 * plan::min_node_side_mm;
  // The layout puts lanes in the middle of the zone and its gap.
  return std::max(length + packing_floor_mm, 2 * exit_floor_mm + length - gap_mm);
}

}  // namespace marketgen::intake
