#include "layout/kept_layout.h"

#include <algorithm>
#include <map>
#include <vector>

#include "io/json.h"
#include "layout/floor.h"
#include "layout/module_spec.h"
#include "layout/overrides.h"
#include "layout/zone_ground.h"

namespace marketgen::layout {
namespace {

constexpr int beside_door_mm = 1500;  // of a zone's edge: its wall runs reach over half of a gap

using Ids = std::set<std::string>;

// Pieces of floor that each zone has.
std::map<std::string, std::vector<RectMm>> floors_of(const plan::Plan& plan) {
  std::map<std::string, std::vector<RectMm>> floors;
  for (const Ground& ground : zone_grounds(plan, make_floor(plan.shell)))
    floors[plan.zones[ground.zone].id].push_back(ground.rect);
  return floors;
}

bool is_furnished_alike(const plan::Zone& a, const plan::Zone& b) {
  return a.type == b.type && a.temperature == b.temperature &&
         io::write_json_line(a.fixture) == io::write_json_line(b.fixture) &&
         io::write_json_line(a.also) == io::write_json_line(b.also);
}

// Floor where something of the room changed: doorsteps, walls under windows, columns.
std::vector<RectMm> changed_spots(const plan::Shell& shell, const plan::Shell& other) {
  std::vector<RectMm> spots;
  const Floor floor = make_floor(shell);
  const auto is_in = [](const auto& row, const auto& rows) {
    return std::ranges::any_of(
        rows, [&](const auto& r) { return io::write_json_line(r) == io::write_json_line(row); });
  };
  for (const Doorway& door : floor.doorways) {
    if (is_in(shell.openings[door.opening], other.openings)) continue;
    spots.push_back(
        cut_along(strip_inside(floor.bounds, door.wall, approach_depth_mm), door.wall, door.span)
            .grown(approach_side_mm));
  }
  for (const plan::Column& column : shell.columns) {
    if (!is_in(column, other.columns)) spots.push_back(plan::footprint_of(column));
  }
  return spots;
}

bool entrances_differ(const plan::Shell& a, const plan::Shell& b) {
  const auto ways = [](const plan::Shell& shell) {
    std::vector<std::string> rows;
    for (const plan::Opening& opening : shell.openings) {
      if (opening.kind == plan::OpeningKind::entrance || opening.kind == plan::OpeningKind::exit)
        rows.push_back(io::write_json_line(opening));
    }
    return rows;
  };
  return ways(a) != ways(b);
}

bool has_tills(const plan::Zone& zone, const catalog::Catalog& catalog) {
  const catalog::FixtureKind* kind = kinds_of(zone, catalog).main;
  return kind != nullptr && kind->role == catalog::FixtureRole::checkout;
}

// Zones of the fixtures of `pins` that `plan` does not pin to the same value.
void add_zones_of_pins(Ids& ids, const std::vector<plan::Override>& pins, const plan::Plan& plan) {
  for (const plan::Override& pin : pins) {
    const bool stays = std::ranges::any_of(plan.overrides, [&](const plan::Override& o) {
      return o.fixture == pin.fixture && o.field_name == pin.field_name && o.value == pin.value;
    });
    if (stays) continue;
    for (const plan::Zone& zone : plan.zones) {
      if (pin.fixture.starts_with(zone.id + "/")) ids.insert(zone.id);
    }
  }
}

}  // namespace

std::set<std::string> zones_to_furnish(const plan::Plan& before,
                                       const plan::Plan& after,
                                       const catalog::Catalog& catalog) {
  Ids ids;
  const auto old_floors = floors_of(before), floors = floors_of(after);
  const auto floor_in = [](const auto& all, const std::string& id) {
    const auto found = all.find(id);
    return found == all.end() ? std::vector<RectMm>{} : found->second;
  };
  std::vector<RectMm> spots = changed_spots(before.shell, after.shell);
  std::ranges::copy(changed_spots(after.shell, before.shell), std::back_inserter(spots));
  const bool tills = entrances_differ(before.shell, after.shell);
  for (const plan::Zone& zone : after.zones) {
    const plan::Zone* old = plan::find_zone(before, zone.id);
    const std::vector<RectMm> floor = floor_in(floors, zone.id);
    const bool at_spot = std::ranges::any_of(floor, [&](const RectMm& piece) {
      return std::ranges::any_of(spots, [&](const RectMm& spot) {
        return marketgen::overlap(piece.grown(beside_door_mm), spot);
      });
    });
    if (old == nullptr || !is_furnished_alike(*old, zone) ||
        floor != floor_in(old_floors, zone.id) || at_spot || (tills && has_tills(zone, catalog)) ||
        before.profile != after.profile)
      ids.insert(zone.id);
  }
  add_zones_of_pins(ids, before.overrides, after);
  // Accessories go by where the run stands that is moved.
  add_zones_of_pins(ids, pinned_places(after), before);
  std::erase_if(ids, [&](const std::string& id) { return plan::find_zone(after, id) == nullptr; });
  return ids;
}

}  // namespace marketgen::layout
