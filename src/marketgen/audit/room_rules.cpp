// Rules about the room of a finished scene: ways out, light, what is above the fixtures.
#include <fmt/format.h>

#include "audit/scene_rules.h"
#include "plan/egress.h"
#include "plan/plan.h"

namespace marketgen::audit {
namespace {

bool is_against_a_wall(const layout::Fixture& fixture, const PolygonMm& floor) {
  constexpr int gap_mm = 300;
  const PolygonMm corners = polygon_of(layout::footprint_of(fixture).grown(gap_mm));
  for (const PointMm corner : corners)
    if (!contains(floor, corner)) return true;
  return false;
}

}  // namespace

std::vector<layout::Violation> check_EXIT_TRAVEL_LONG(const SceneFacts& facts,
                                                      const SceneRule& rule) {
  if (facts.egress.longest_m <= rule.limit) return {};
  layout::Violation found = violation_of(
      rule,
      "store",
      facts.egress.longest_m,
      fmt::format("it is {:.0f} m from there to the nearest door; at most {:.0f}: add an emergency "
                  "exit in the wall next to it",
                  facts.egress.longest_m,
                  rule.limit));
  found.at_mm = facts.egress.farthest;
  return {std::move(found)};
}

std::vector<layout::Violation> check_DOOR_NARROW(const SceneFacts& facts, const SceneRule& rule) {
  std::vector<layout::Violation> found;
  for (const plan::Opening& opening : facts.scene.layout.shell.openings) {
    if (!plan::leads_outside(opening) || opening.width_mm >= rule.limit) continue;
    found.push_back(violation_of(
        rule,
        opening.id,
        opening.width_mm,
        fmt::format(
            "the door is {} mm wide; a wheelchair needs {:.0f}", opening.width_mm, rule.limit)));
  }
  return found;
}

std::vector<layout::Violation> check_LIGHT_DIM(const SceneFacts& facts, const SceneRule& rule) {
  const int lux = facts.scene.layout.look.light_lux;
  if (lux >= rule.limit) return {};
  return {violation_of(
      rule,
      "store",
      lux,
      fmt::format("{} lx on the floor; sales areas have {:.0f} and more", lux, rule.limit))};
}

std::vector<layout::Violation> check_CEILING_TIGHT(const SceneFacts& facts, const SceneRule& rule) {
  const layout::Layout& layout = facts.scene.layout;
  const PolygonMm floor = plan::floor_of(layout.shell);
  const layout::Fixture* highest = nullptr;
  for (const layout::Fixture& fixture : layout.fixtures) {
    if (fixture.levels == 0 || is_against_a_wall(fixture, floor)) continue;
    if (highest == nullptr || fixture.height_mm > highest->height_mm) highest = &fixture;
  }
  if (highest == nullptr) return {};
  const int left_mm = layout.shell.ceiling_mm - highest->height_mm;
  if (left_mm >= rule.limit) return {};
  layout::Violation found = violation_of(
      rule,
      highest->id,
      left_mm,
      fmt::format(
          "{} mm between its top and the ceiling; sprinklers need {:.0f}", left_mm, rule.limit));
  found.at_mm = PointMm{highest->x_mm, highest->y_mm};
  return {std::move(found)};
}

}  // namespace marketgen::audit
