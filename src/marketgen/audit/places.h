// Where the things that people name are: zones, openings, walls and the checkouts as rectangles,
// and the relations among them.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/rectangle.h"
#include "plan/plan.h"
#include "scene/scene.h"

namespace marketgen {

// Bounding rectangles of everything called `name`: zone ids and types, opening ids and kinds, walls
// (as strips), "checkout", "center". Empty when the store has no such thing.
std::vector<RectMm> places_named(const Scene& scene, std::string_view name);

struct RelationCheck {
  bool holds = false;
  double measured_m = 0;  // distance or offset that decided
};
// Definitions (docs/metrics.md): near: gap <= 20 % of the store's diagonal (at least 3 m); far: gap
// >= 35 %; along and at: within 1.5 m of the wall and at least half as long as the zone; left_of,
// right_of: as seen by someone who comes in; behind: deeper into the store; between: nearer to both
// than they are to each other; not_adjacent: gap > 0.5 m with no shared side.
RelationCheck check_relation(const Scene& scene,
                             RelationKind kind,
                             std::string_view a,
                             std::string_view b,
                             std::string_view c);

}  // namespace marketgen
