#include "intake/zone_sizes.h"

#include <algorithm>
#include <array>

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
constexpr int machine_aisle_mm = 1600;  // between two rows of self-checkouts (layout)
constexpr int lawful_aisle_mm = 1000;   // the least before any front (layout: min_aisle_mm)
constexpr int usual_run_mm = 6000;      // what a run is measured for when nobody says how long
constexpr int longest_run_mm = 12000;   // without a cross aisle (FixtureSpec::run_max_mm)
constexpr int cross_aisle_mm = 3000;    // between runs one behind the other

bool has_staff_side(const catalog::FixtureKind& kind) {
  return kind.generator == "serve_over";
}

// Free floor before a kind's front (layout: ModuleSpec::clear_mm).
int clear_mm(const catalog::FixtureKind& kind) {
  return std::max(lawful_aisle_mm + static_cast<int>(kind.door_swing_mm),
                  static_cast<int>(kind.front_clearance_mm));
}

// How many of a kind the floor is measured for: those that were asked for, also when fewer found
// room before.
int modules_of(const KindWish& wish) {
  if (wish.count || !wish.runs) return std::max(wish.count.value_or(0), wish.least);
  return *wish.runs * std::max(1, usual_run_mm / wish.kind->module_widths_mm.front());
}

double floor_m2(const KindWish& wish, const catalog::ProfileRow& profile) {
  if (wish.kind == nullptr) return 0;
  const double loose = is_walked_round(*wish.kind) ? 1.7 : 1.2;  // aisles at the ends of runs
  const catalog::FixtureKind& kind = *wish.kind;
  const bool two_faces = kind.double_sided && wish.sides != 1;
  const int depth = kind.generator == "gondola" && two_faces
                        ? 2 * profile.gondola_shelf_mm + back_panel_mm
                        : kind.depth_mm;
  const int aisle = std::max(clear_mm(kind), profile.secondary_aisle_mm);
  const int deep = depth + (two_faces || wish.sides == 1 ? aisle : aisle / 2);
  return loose * 1e-6 * modules_of(wish) * kind.module_widths_mm.front() * deep;
}

}  // namespace

const catalog::FixtureKind* kind_on_walls(const catalog::FixtureKind& kind,
                                          const catalog::Catalog& catalog) {
  if (kind.against_wall || kind.generator == "produce_table" || has_staff_side(kind)) return &kind;
  if (kind.temperature == catalog::Storage::frozen)
    return catalog.fixture_kind("glass_door_freezer");
  return catalog.fixture_kind("wall_unit");
}

double counted_floor_m2(const ProgramZone& zone, const catalog::ProfileRow& profile) {
  constexpr double min_own_m2 = 8;  // for the zone's own fixtures, when nobody counts them
  double m2 = floor_m2(zone.main, profile), beside_m2 = 0;
  for (const KindWish& wish : zone.beside)
    beside_m2 += floor_m2(wish, profile);
  return m2 + beside_m2 + (m2 <= 0 && beside_m2 > 0 ? min_own_m2 : 0);
}

bool is_walked_round(const catalog::FixtureKind& kind) {
  constexpr std::array<std::string_view, 4> generators{
      "produce_table", "bin", "pallet", "promo_stack"};
  return std::ranges::find(generators, kind.generator) != generators.end();
}

int counted_length_mm(const ProgramZone& zone, const catalog::ProfileRow& profile, int depth_mm) {
  if (zone.stance != Stance::wall)
    return static_cast<int>(counted_floor_m2(zone, profile) * 1e6 / std::max(1, depth_mm));
  int on_wall = 0, free_standing = 0;
  const auto add = [&](const KindWish& wish) {
    if (wish.kind == nullptr || modules_of(wish) == 0) return;
    const int length = modules_of(wish) * wish.kind->module_widths_mm.front();
    if (has_staff_side(*wish.kind))
      on_wall += length + passage_mm;
    else if (wish.kind->against_wall)
      on_wall += length + wall_margin_mm;
    else
      free_standing += length + lawful_aisle_mm;
  };
  add(zone.main);
  for (const KindWish& wish : zone.beside)
    add(wish);
  return std::max(on_wall, free_standing);
}

int counted_run_mm(const ProgramZone& zone) {
  if (!zone.main.runs || !zone.main.count) return 0;
  const int modules = (*zone.main.count + *zone.main.runs - 1) / *zone.main.runs;
  return modules * zone.main.kind->module_widths_mm.front() + wall_margin_mm;
}

int beside_depth_mm(const ProgramZone& zone, int length_mm) {
  constexpr int island_mm = 2400;  // tables and stacks are walked round (layout: floor_habits)
  int depth = 0;
  for (const KindWish& wish : zone.beside) {
    const int modules = modules_of(wish);
    if (modules == 0) continue;
    const catalog::FixtureKind& kind = *wish.kind;
    const int width = kind.module_widths_mm.front();
    const int islands = std::max(1, (length_mm + lawful_aisle_mm) / (island_mm + lawful_aisle_mm));
    const int in_line = kind.double_sided ? std::max(1, length_mm / width)
                                          : islands * std::max(1, island_mm / width);
    const int lines = (modules + in_line - 1) / in_line;
    depth += lines * kind.depth_mm + (lines + 1) / 2 * clear_mm(kind);
  }
  return depth;
}

std::optional<int> counted_lines(const ProgramZone& zone, int depth_mm) {
  const KindWish& wish = zone.main;
  if (wish.kind == nullptr || (!wish.runs && !wish.count)) return std::nullopt;
  const bool pairs = !wish.kind->double_sided && wish.sides != 1;  // two lines back to back
  const int width = wish.kind->module_widths_mm.front();
  // One behind the other in a deep hall, with cross aisles between them.
  const int behind = std::max(1, (depth_mm + cross_aisle_mm) / (longest_run_mm + cross_aisle_mm));
  const int length = (depth_mm - (behind - 1) * cross_aisle_mm) / behind;
  const int in_line = std::max(1, std::min(length, longest_run_mm) / width);
  const int lines = wish.runs ? *wish.runs * (pairs && wish.sides == 2 ? 2 : 1)
                              : (*wish.count + in_line - 1) / in_line;
  const int blocks = pairs ? (lines + 1) / 2 : lines;
  return (blocks + behind - 1) / behind;
}

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
  int free_standing = 0;  // what stands before the wall, and the aisle between
  for (const KindWish& wish : zone.beside) {
    if (wish.count == 0 || wish.kind->against_wall || has_staff_side(*wish.kind)) continue;
    const int aisle = std::max(kind != nullptr ? clear_mm(*kind) : 0, clear_mm(*wish.kind));
    free_standing = std::max(free_standing, aisle + wish.kind->depth_mm);
  }
  depth += free_standing;
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
    const int rows = (zone.count.value_or(2) + machines_a_row - 1) / machines_a_row;
    if (rows <= 2) return rows * zone.kind->depth_mm + 2 * passage_mm;
    return rows * zone.kind->depth_mm + (rows + 1) / 2 * machine_aisle_mm + passage_mm;
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

namespace {

bool has_no_tills(const StoreProgram& program) {
  return std::ranges::none_of(program.zones, [](const ProgramZone& zone) {
    return zone.type->type == "checkout" || zone.type->type == "self_checkout";
  });
}

}  // namespace

int front_depth_mm(const StoreProgram& program, const catalog::Catalog& catalog, int gap_mm) {
  for (const ProgramZone& zone : program.zones) {
    const bool till = zone.type->type == "checkout" || has_no_tills(program);
    if (till && zone.kind != nullptr && zone.kind->is_desk())
      return std::max(exit_floor_mm, zone.kind->module_widths_mm.front() + passage_mm);
  }
  const catalog::FixtureKind* lane = catalog.fixture_kind("checkout_lane");
  const int length = lane != nullptr ? lane_length_mm(*lane, program) : 3 * plan::min_node_side_mm;
  // The layout puts lanes in the middle of the zone and its gap.
  return std::max(length + packing_floor_mm, 2 * exit_floor_mm + length - gap_mm);
}

}  // namespace marketgen::intake
