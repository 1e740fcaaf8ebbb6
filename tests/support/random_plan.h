// Plans of random rooms, divided at random into zones of random types. Unlike PlanSampler's, they
// differ in their geometry: 8 to 60 m, columns, cut-off and slanted corners.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/seed.h"
#include "plan/bsp.h"
#include "plan/plan.h"
#include "support/committed_catalog.h"

namespace marketgen {

class RandomPlan {
 public:
  explicit RandomPlan(std::uint64_t seed) : draw_(Seed(seed).child("random_plan").stream()) {}

  plan::Plan make() {
    // 8 to 60 m, small shops more often.
    plan_.shell.width_mm = 8000 + static_cast<int>(520 * draw_.uniform() * draw_.uniform()) * 100;
    plan_.shell.depth_mm = 8000 + static_cast<int>(520 * draw_.uniform() * draw_.uniform()) * 100;
    const std::vector<catalog::ProfileRow>& profiles = committed_catalog().profiles;
    plan_.profile = profiles[pick(profiles.size())].id;
    add_doors();
    if (draw_.chance(0.3)) add_columns();
    if (draw_.chance(0.25)) cut_a_corner();
    divide("root", plan::shell_rect(plan_.shell), 0);
    // A door may have been in the corner that was cut off.
    if (!plan::validate_plan(plan_, "random plan", committed_catalog()).ok())
      plan_.shell.outline_mm.reset();
    return plan_;
  }

 private:
  std::size_t pick(std::size_t count) {
    return static_cast<std::size_t>(draw_.integer(0, static_cast<int>(count) - 1));
  }

  void add_doors() {
    const auto wall = static_cast<plan::Wall>(draw_.integer(0, 3));
    plan_.shell.openings = {
        {"in", plan::OpeningKind::entrance, wall, draw_.uniform(0.2, 0.4), 1800},
        {"out", plan::OpeningKind::exit, wall, draw_.uniform(0.6, 0.8), 1800}};
    if (draw_.chance(0.5)) {
      plan_.shell.openings.push_back({"dock",
                                      plan::OpeningKind::service,
                                      static_cast<plan::Wall>((static_cast<int>(wall) + 1) % 4),
                                      draw_.uniform(0.3, 0.7),
                                      1800});
    }
  }

  void add_columns() {
    for (int x = 6000; x + 3000 < plan_.shell.width_mm; x += 9000) {
      for (int y = 6000; y + 3000 < plan_.shell.depth_mm; y += 9000)
        plan_.shell.columns.push_back({x, y, 400});
    }
  }

  void cut_a_corner() {
    const int w = plan_.shell.width_mm, d = plan_.shell.depth_mm;
    const int x = w * 7 / 10, y = d * 7 / 10;
    plan_.shell.outline_mm = PolygonMm{{0, 0}, {w, 0}, {w, y}, {x, y}, {x, d}, {0, d}};
    if (draw_.chance(0.5))
      plan_.shell.outline_mm = PolygonMm{{0, 0}, {w, 0}, {w, y}, {x, d}, {0, d}};
  }

  void add_leaf(const std::string& id) {
    const std::vector<catalog::ZoneTypeRow>& types = committed_catalog().zone_types;
    plan::Zone zone;
    zone.type = plan_.zones.empty() ? "checkout" : types[pick(types.size())].type;
    zone.id = "zone-" + std::to_string(plan_.zones.size());
    const catalog::ZoneTypeRow* type = committed_catalog().zone_type(zone.type);
    if (!type->fixture.empty()) zone.fixture.kind = type->fixture;
    if (draw_.chance(0.5)) zone.fixture.endcaps = plan::Endcaps::both;
    if (draw_.chance(0.2)) zone.fixture.axis = static_cast<plan::RunAxis>(draw_.integer(0, 2));
    if (draw_.chance(0.2)) zone.fixture.run_max_mm = draw_.integer(3000, 9000);
    plan::Node leaf;
    leaf.id = id;
    leaf.zone = zone.id;
    plan_.nodes.push_back(leaf);
    plan_.zones.push_back(zone);
  }

  void divide(const std::string& id, const RectMm& rect, int depth) {
    const bool small = rect.area_m2() < 30 || std::min(rect.width(), rect.depth()) < 4500;
    if (small || depth >= 4 || draw_.chance(0.1 * depth)) return add_leaf(id);
    plan::Node node;
    node.id = id;
    node.split = rect.width() > rect.depth() ? plan::Axis::x : plan::Axis::y;
    node.ratio = draw_.uniform(0.3, 0.7);
    node.gap_mm = draw_.integer(0, 14) * 200;
    node.children = {id + "a", id + "b"};
    plan_.nodes.push_back(node);
    const std::array<RectMm, 2> parts = plan::split_rect(rect, node);
    divide(node.children[0], parts[0], depth + 1);
    divide(node.children[1], parts[1], depth + 1);
  }

  Stream draw_;
  plan::Plan plan_;
};

}  // namespace marketgen
