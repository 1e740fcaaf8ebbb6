// Rules about where single fixtures stand.
#include <algorithm>
#include <set>

#include "layout/rule_facts.h"

namespace marketgen::layout {
namespace {

constexpr int arrival_mm = 3000;       // floor for arriving, from the entrance's line
constexpr int eye_mm = 1500;           // what is lower can be looked over
constexpr int touching_mm = 10;        // a door's swing may graze what touches the cabinet
constexpr int run_tolerance_mm = 700;  // half a module more than wished is no fault

bool is_double_sided(const RuleFacts& facts, const Face& face) {
  const auto fixture = std::ranges::find(facts.layout.fixtures, face.run, &Fixture::run);
  return fixture != facts.layout.fixtures.end() && fixture->sides == 2;
}

}  // namespace

Findings fixture_outside(const RuleFacts& facts) {
  Findings found;
  for (std::size_t i = 0; i < facts.footprints.size(); ++i) {
    const RectMm& rect = facts.footprints[i];
    if (on_floor(facts.design.floor, rect)) continue;
    found.push_back({facts.layout.fixtures[i].id,
                     1,
                     0,
                     "fixture " + facts.layout.fixtures[i].id + " reaches outside the shop",
                     rect.center()});
  }
  return found;
}

Findings fixture_overlap(const RuleFacts& facts) {
  // Sorted by their west edges, only neighbours in x can overlap.
  std::vector<std::size_t> order(facts.footprints.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return facts.footprints[i].x0; });
  Findings found;
  // What hangs over a fixture does not stand in it.
  const auto hangs_over = [&](std::size_t i, std::size_t below) {
    const catalog::FixtureKind* kind = facts.kinds[i];
    return kind != nullptr && kind->mount != catalog::FixtureMount::floor &&
           facts.layout.fixtures[i].base_mm >= facts.layout.fixtures[below].height_mm;
  };
  const auto report = [&](std::size_t i, const RectMm& other, const std::string& name) {
    const auto common = marketgen::intersection(facts.footprints[i], other);
    if (!common) return;
    const std::string& id = facts.layout.fixtures[i].id;
    found.push_back({id,
                     static_cast<double>(std::min(common->width(), common->depth())),
                     0,
                     "fixture " + id + " stands in " + name,
                     common->center()});
  };
  for (std::size_t a = 0; a < order.size(); ++a) {
    for (std::size_t b = a + 1; b < order.size(); ++b) {
      if (facts.footprints[order[b]].x0 >= facts.footprints[order[a]].x1) break;
      if (hangs_over(order[a], order[b]) || hangs_over(order[b], order[a])) continue;
      report(order[a], facts.footprints[order[b]], facts.layout.fixtures[order[b]].id);
    }
    for (const RectMm& column : facts.design.floor.columns)
      report(order[a], column, "a column");
  }
  return found;
}

Findings exit_blocked(const RuleFacts& facts) {
  Findings found;
  for (const Doorway& door : facts.design.floor.doorways) {
    if (door.approach.empty()) continue;
    const std::string& id = facts.shell().openings[door.opening].id;
    for (std::size_t i = 0; i < facts.footprints.size(); ++i) {
      const auto common = marketgen::intersection(facts.footprints[i], door.approach);
      if (!common) continue;
      found.push_back({facts.layout.fixtures[i].id,
                       static_cast<double>(common->area_mm2()) * 1e-6,
                       0,
                       "fixture " + facts.layout.fixtures[i].id + " stands in the way of " + id,
                       common->center()});
    }
    for (const RectMm& column : facts.design.floor.columns) {
      const auto common = marketgen::intersection(column, door.approach);
      if (!common) continue;
      found.push_back({id,
                       static_cast<double>(common->area_mm2()) * 1e-6,
                       0,
                       "a column stands in the way of " + id,
                       common->center()});
    }
  }
  return found;
}

Findings door_swing_blocked(const RuleFacts& facts) {
  Findings found;
  for (std::size_t i = 0; i < facts.footprints.size(); ++i) {
    const Fixture& fixture = facts.layout.fixtures[i];
    const int swing =
        facts.kinds[i] == nullptr ? 0 : static_cast<int>(facts.kinds[i]->door_swing_mm);
    if (swing <= 0) continue;
    const Side front = facing_of(fixture.yaw_deg);
    const RectMm needed = strip_beyond(facts.footprints[i], front, swing);
    int room = on_floor(facts.design.floor, needed) ? swing : 0;
    const auto narrow = [&](const RectMm& other) {
      if (marketgen::overlap(other, needed))
        room = std::min(room, std::max(0, distance_beyond(facts.footprints[i], front, other)));
    };
    for (std::size_t k = 0; k < facts.footprints.size(); ++k) {
      if (k != i) narrow(facts.footprints[k]);
    }
    for (const RectMm& column : facts.design.floor.columns)
      narrow(column);
    if (room >= swing - touching_mm) continue;
    found.push_back({fixture.id,
                     static_cast<double>(room),
                     static_cast<double>(swing),
                     "the doors of " + fixture.id + " open " + in_mm(room) + " of " + in_mm(swing),
                     needed.center()});
  }
  return found;
}

Findings run_too_long(const RuleFacts& facts) {
  Findings found;
  std::set<std::string> seen;
  for (const Face& face : facts.faces) {
    const plan::Zone* zone = plan::find_zone(facts.design.plan, face.zone);
    if (zone == nullptr || !is_double_sided(facts, face) || !seen.insert(face.run).second) continue;
    const int length = along(face.rect, face.front).length();
    const int limit = zone->fixture.run_max_mm;
    if (length <= limit + run_tolerance_mm) continue;
    found.push_back({face.run,
                     static_cast<double>(length),
                     static_cast<double>(limit),
                     "run " + face.run + " is " + in_mm(length) + " long without a cross aisle",
                     face.rect.center()});
  }
  return found;
}

Findings sight_line(const RuleFacts& facts) {
  Findings found;
  const Doorway* door = entrance_of(facts.design.floor, facts.shell());
  if (door == nullptr) return found;
  const RectMm view = cut_along(
      strip_inside(facts.design.floor.bounds, door->wall, arrival_mm), door->wall, door->span);
  for (std::size_t i = 0; i < facts.footprints.size(); ++i) {
    const Fixture& fixture = facts.layout.fixtures[i];
    if (fixture.height_mm <= eye_mm || !marketgen::overlap(facts.footprints[i], view)) continue;
    found.push_back({fixture.id,
                     static_cast<double>(fixture.height_mm),
                     eye_mm,
                     "fixture " + fixture.id + ", " + in_mm(fixture.height_mm) +
                         " high, hides the shop from the entrance",
                     facts.footprints[i].center()});
  }
  return found;
}

}  // namespace marketgen::layout
