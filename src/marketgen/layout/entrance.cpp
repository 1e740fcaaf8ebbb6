#include "layout/entrance.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace marketgen::layout {
namespace {

constexpr int further_along_wall_mm = 24000;  // the second bay and more, in a row with the first
constexpr int step_mm = 250;
constexpr int wall_gap_mm = 20;

// The ids of the units of one kind: the first has the kind's own run, further ones are numbered.
std::string run_of_unit(const ZoneBuild& owner, std::string_view kind, int number) {
  const std::string run = owner.zone->id + "/entrance/" + std::string(kind);
  return number == 1 ? run : run + "-" + std::to_string(number);
}

// A unit that stands by itself, with its middle in that of `rect`.
Fixture lone_unit(const ModuleSpec& spec, const ZoneBuild& owner, const RectMm& rect, int number) {
  Fixture unit = make_module(spec, *owner.zone);
  unit.run = run_of_unit(owner, spec.kind->kind, number);
  unit.id = unit.run + "/module-1";
  unit.x_mm = rect.center()[0];
  unit.y_mm = rect.center()[1];
  unit.width_mm = spec.widths_mm.front();
  unit.run_start = unit.run_end = true;
  return unit;
}

// One more of a kind at one of the doors.
struct Post {
  const Doorway& door;
  const catalog::FixtureKind& kind;
  int number;  // of its kind in the store, from 1
};

void place_beside_door(Build& build, const Post& post, bool low_side_first) {
  const ZoneBuild* owner = nearest_zone(build, post.door.threshold);
  if (owner == nullptr) return;
  const ModuleSpec spec = module_spec(build.design, *owner->zone, post.kind);
  const int reach = post.number == 1 ? reach_along_wall_mm : further_along_wall_mm;
  const std::optional<Stand> stand = stand_beside(build, post.door, spec, reach, low_side_first);
  if (!stand) return;
  Fixture unit = lone_unit(spec, *owner, stand->rect, post.number);
  unit.yaw_deg = yaw_facing(stand->front);
  build.site.add(std::move(unit), build.design.min_aisle_mm());
}

// Where gates stand: off the middle of the door and beyond its approach, and the floor kept free
// round them.
struct GateRoom {
  int round_mm = 0, aside_mm = 0, away_mm = 0;
};

// Posts that say "in": straight before the door, side by side, with room to pass on every side.
void place_gates(Build& build, const Post& first, int count, const GateRoom& room) {
  const Doorway& door = first.door;
  const ZoneBuild* owner = nearest_zone(build, door.threshold);
  if (owner == nullptr) return;
  const ModuleSpec spec = module_spec(build.design, *owner->zone, first.kind);
  const int width = spec.widths_mm.front();
  const int from = door.span.middle() - count * width / 2 + room.aside_mm;
  const RectMm before = strip_beyond(door.approach, opposite(door.wall), room.away_mm);
  const RectMm line = cut_along(
      strip_beyond(room.away_mm > 0 ? before : door.approach, opposite(door.wall), spec.depth_mm),
      door.wall,
      {from, from + count * width});
  const RectMm round = line.grown(room.round_mm);
  if (!build.site.is_clear(round)) return;
  for (int i = 0; i < count; ++i) {
    const RectMm rect = cut_along(line, door.wall, {from + i * width, from + (i + 1) * width});
    Fixture gate = lone_unit(spec, *owner, rect, first.number + i);
    gate.yaw_deg = yaw_facing(door.wall);
    build.site.add(std::move(gate), 0);
  }
  build.site.keep_clear(round);
}

// How many of a kind stand at each door, in the order of the doors.
using AtDoors = std::vector<std::pair<const Doorway*, int>>;

std::vector<const Doorway*> doors_named(const Design& design, const std::string& name) {
  std::vector<const Doorway*> doors;
  for (const Doorway& door : design.floor.doorways) {
    const plan::Opening& opening = design.plan.shell.openings[door.opening];
    const bool named = opening.id == name || name_of(opening.kind) == name;
    if (named && !door.approach.empty()) doors.push_back(&door);
  }
  return doors;
}

bool is_named(const Design& design, std::string_view kind) {
  return design.plan.equipment &&
         std::ranges::find(*design.plan.equipment, kind, &plan::EquipmentSpec::kind) !=
             design.plan.equipment->end();
}

// As the plan wishes; as usual, one at the first entrance, where it does not name the kind.
AtDoors doors_of(const Design& design, std::string_view kind, bool usual) {
  AtDoors at;
  bool named = false;
  for (const plan::EquipmentSpec& spec :
       design.plan.equipment.value_or(std::vector<plan::EquipmentSpec>{})) {
    if (spec.kind != kind) continue;
    named = true;
    std::vector<const Doorway*> doors = doors_named(design, spec.at.value_or("entrance"));
    const Doorway* fallback = entrance_of(design.floor, design.plan.shell);
    if (doors.empty() && fallback != nullptr) doors.push_back(fallback);
    for (std::size_t i = 0; i < doors.size(); ++i) {
      const auto all = static_cast<int>(doors.size()), before = static_cast<int>(i);
      const int here = (spec.count + all - 1 - before) / all;
      if (here > 0) at.emplace_back(doors[i], here);
    }
  }
  const Doorway* door = entrance_of(design.floor, design.plan.shell);
  if (!named && usual && door != nullptr) at.emplace_back(door, 1);
  return at;
}

// As much room round a gate as trolleys want, straight before the door; one that was asked for does
// with a lawful aisle, and stands a little aside or away.
std::vector<GateRoom> gate_rooms(const Design& design) {
  const int lawful = design.min_aisle_mm();
  const int habit = std::max(lawful, design.profile.secondary_aisle_mm * 4 / 5);
  std::vector<GateRoom> rooms{{habit, 0, 0}};
  if (!design.plan.equipment) return rooms;
  for (const int away : {0, 400, 800}) {
    for (const int aside : {0, -500, 500, -1000, 1000})
      rooms.push_back({lawful, aside, away});
  }
  return rooms;
}

void place_all_gates(Build& build, const catalog::FixtureKind& kind, const AtDoors& at) {
  int number = 1;
  for (const auto& [door, count] : at) {
    const std::size_t before = build.site.fixtures().size();
    for (const GateRoom& room : gate_rooms(build.design)) {
      if (build.site.fixtures().size() == before)
        place_gates(build, {*door, kind, number}, count, room);
    }
    number += count;
  }
}

void place_all_beside(Build& build,
                      const catalog::FixtureKind& kind,
                      const AtDoors& at,
                      bool low_side_first) {
  int number = 1;
  for (const auto& [door, count] : at) {
    for (int i = 0; i < count; ++i)
      place_beside_door(build, {*door, kind, number++}, low_side_first);
  }
}

// Whether any of them stands then.
bool place_all(Build& build,
               const catalog::FixtureKind& kind,
               const AtDoors& at,
               bool low_side_first) {
  const std::size_t before = build.site.fixtures().size();
  if (kind.generator == "gate")
    place_all_gates(build, kind, at);
  else
    place_all_beside(build, kind, at, low_side_first);
  return build.site.fixtures().size() > before;
}

// What stands at the entrance of a shop whose plan says nothing about it, and whether on the side
// that trolleys have.
struct UsualEquipment {
  std::string_view kind;
  bool beside_trolleys;
};
constexpr std::array<UsualEquipment, 3> usual_equipment{
    {{"trolley_bay", true}, {"basket_stack", false}, {"gate", false}}};

}  // namespace

const ZoneBuild* nearest_zone(const Build& build, PointMm point) {
  const ZoneBuild* best = nullptr;
  std::int64_t best_distance = 0;
  for (const GroundBuild& ground : build.grounds) {
    const RectMm& r = ground.ground.rect;
    const std::int64_t dx = std::max({r.x0 - point[0], 0, point[0] - r.x1});
    const std::int64_t dy = std::max({r.y0 - point[1], 0, point[1] - r.y1});
    const std::int64_t distance = dx * dx + dy * dy;
    if (best != nullptr && distance >= best_distance) continue;
    best = &build.zones[ground.zone];
    best_distance = distance;
  }
  return best;
}

std::optional<Stand> stand_beside(const Build& build,
                                  const Doorway& door,
                                  const ModuleSpec& spec,
                                  int reach_mm,
                                  bool low_side_first) {
  const Span approach = along(door.approach, door.wall);
  const int width = spec.widths_mm.front();
  const bool endwise = spec.depth_mm > width;
  const int length = endwise ? spec.depth_mm : width;
  const RectMm strip = strip_inside(
      build.design.floor.bounds, door.wall, endwise ? width : spec.depth_mm, wall_gap_mm);
  for (const bool low : {low_side_first, !low_side_first}) {
    const Side toward_door = lies_along_x(door.wall) ? (low ? Side::east : Side::west)
                                                     : (low ? Side::north : Side::south);
    for (int away = 0; away <= reach_mm; away += step_mm) {
      const int from = low ? approach.from - away - length : approach.to + away;
      const Stand stand{cut_along(strip, door.wall, {from, from + length}),
                        endwise ? toward_door : opposite(door.wall)};
      if (!build.site.can_stand(stand.rect)) continue;
      const int clear = build.design.min_aisle_mm();
      if (build.site.is_clear(strip_beyond(stand.rect, stand.front, clear)) &&
          build.site.is_clear(strip_beyond(stand.rect, opposite(door.wall), clear))) {
        return stand;
      }
    }
  }
  return std::nullopt;
}

void place_entrance(Build& build) {
  const Design& design = build.design;
  const bool low = build.seed.child("entrance").stream().chance(0.5);
  const auto place = [&](std::string_view name, bool usual, bool low_side_first) {
    const catalog::FixtureKind* kind = design.catalog.fixture_kind(name);
    if (kind == nullptr) return;
    AtDoors at = doors_of(design, name, usual);
    std::erase_if(at, [&](const auto& door) {  // what is there already stays (layout/kept_layout.h)
      const ZoneBuild* owner = nearest_zone(build, door.first->threshold);
      return owner != nullptr && owner->stands;
    });
    const catalog::FixtureKind& make = is_named(design, name) ? *kind : design.makes.of(*kind);
    if (!place_all(build, make, at, low_side_first) && &make != kind)
      place_all(build, *kind, at, low_side_first);  // the make has no room
  };
  for (const UsualEquipment& usual : usual_equipment)
    place(usual.kind, true, usual.beside_trolleys == low);
  if (!design.plan.equipment) return;
  std::vector<std::string_view> placed;
  for (const plan::EquipmentSpec& spec : *design.plan.equipment) {
    const bool done = std::ranges::find(usual_equipment, spec.kind, &UsualEquipment::kind) !=
                          usual_equipment.end() ||
                      std::ranges::find(placed, spec.kind) != placed.end();
    if (done) continue;
    placed.push_back(spec.kind);
    place(spec.kind, false, low);
  }
}

}  // namespace marketgen::layout
