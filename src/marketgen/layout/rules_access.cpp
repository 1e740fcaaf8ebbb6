// Rules about who gets where: wheelchairs, shoppers with baskets, robots.
#include <algorithm>
#include <map>

#include "layout/rule_facts.h"

namespace marketgen::layout {
namespace {

constexpr double min_floor_m2 = 0.25;  // less is a corner behind a fixture

bool front_reached(const Reach& reach, const Fixture& fixture, int width_mm) {
  for (int side = 0; side < fixture.sides; ++side) {
    if (!reach.reaches(standing_place(fixture, side, width_mm))) return false;
  }
  return true;
}

// The middle of the largest part of the floor that cannot be got to.
PointMm somewhere_in(const Reach& reach, int label) {
  for (std::size_t cell = 0; cell < reach.components.label.size(); ++cell) {
    if (reach.components.label[cell] != label) continue;
    return reach.grid.center(static_cast<int>(cell % static_cast<std::size_t>(reach.grid.columns)),
                             static_cast<int>(cell / static_cast<std::size_t>(reach.grid.columns)));
  }
  return reach.grid.bounds.center();
}

}  // namespace

Findings wheelchair_route(const RuleFacts& facts) {
  Findings found;
  const int width = facts.profile().wheelchair_mm;
  for (const Doorway& door : facts.design.floor.doorways) {
    const plan::Opening& opening = facts.shell().openings[door.opening];
    const bool way =
        opening.kind == plan::OpeningKind::entrance || opening.kind == plan::OpeningKind::exit;
    if (!way || facts.wheelchair.reaches(door.approach)) continue;
    found.push_back({opening.id,
                     0,
                     static_cast<double>(width),
                     "no way for a wheelchair leads to " + opening.id,
                     door.approach.center()});
  }
  std::map<std::string, std::pair<int, std::size_t>>
      blocked;  // by run: how many modules, and the first
  for (std::size_t i = 0; i < facts.layout.fixtures.size(); ++i) {
    const Fixture& fixture = facts.layout.fixtures[i];
    if (!facts.is_shelving(i) || front_reached(facts.wheelchair, fixture, width)) continue;
    ++blocked.try_emplace(fixture.run, 0, i).first->second.first;
  }
  for (const auto& [run, what] : blocked) {
    found.push_back({facts.layout.fixtures[what.second].id,
                     static_cast<double>(what.first),
                     0,
                     "a wheelchair does not get to the front of " + std::to_string(what.first) +
                         " modules of " + run,
                     facts.footprints[what.second].center()});
  }
  return found;
}

Findings zone_unreachable(const RuleFacts& facts) {
  std::map<std::string, bool> reached;  // zones that have fixtures
  for (std::size_t i = 0; i < facts.layout.fixtures.size(); ++i) {
    const Fixture& fixture = facts.layout.fixtures[i];
    if (!facts.is_shelving(i) && !facts.is_checkout(i)) continue;
    bool& any = reached[fixture.zone];
    for (int side = 0; side < fixture.sides && !any; ++side) {
      any = facts.person.reaches(standing_place(fixture, side, person_width_mm));
    }
  }
  Findings found;
  for (const auto& [zone, any] : reached) {
    if (any) continue;
    const LayoutZone* place = find_zone(facts.layout, zone);
    found.push_back(
        {zone,
         0,
         1,
         "no way leads from the entrance to zone " + zone,
         place == nullptr ? std::optional<PointMm>{} : bounds_of(place->polygon_mm).center()});
  }
  return found;
}

Findings floor_shut_off(const RuleFacts& facts) {
  const Reach& reach = facts.wheelchair;
  const double cell_m2 = 1e-6 * reach.grid.cell_mm * reach.grid.cell_mm;
  double shut_m2 = 0;
  int largest = 0, largest_cells = 0;
  for (int label = 1; label < static_cast<int>(reach.components.cells.size()); ++label) {
    const int cells = reach.components.cells[static_cast<std::size_t>(label)];
    if (label == reach.from_entrance) continue;
    shut_m2 += cells * cell_m2;
    if (cells <= largest_cells) continue;
    largest = label;
    largest_cells = cells;
  }
  if (shut_m2 <= min_floor_m2) return {};
  return {{"floor",
           shut_m2,
           min_floor_m2,
           "free floor is shut off from the entrance",
           somewhere_in(reach, largest)}};
}

}  // namespace marketgen::layout
