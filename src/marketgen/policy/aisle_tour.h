// Where to look for a product in a store: places before the shelves, and their order.
//
// Products of one category stand near one another, so the shelves nearest to the category's place
// come first, and of these the ones on the way.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "agent/aisle_map.h"

namespace marketgen::policy {

// Whether the robot can take goods from it at all: it opens no doors, and takes what stands, not
// what lies in heaps or hangs.
inline bool can_be_fetched_from(const agent::ShelfBoard& board) {
  return board.use == assets::ShelfUse::stand && !board.has_door;
}

// Where the robot has room to look straight at something from: boards, or a pack on one. Empty:
// nowhere. `faced`: its front towards -Y.
std::optional<robots::BasePlace> view_place(const agent::AisleMap& map, const Pose& faced);

// From `place` the robot looks straight at the boards of one front.
struct ViewStop {
  robots::BasePlace place;
  Vec2 front;  // middle of the boards' edges
};

// One for each front of boards that it can fetch from and before which it has room.
std::vector<ViewStop> view_stops(const agent::AisleMap& map);

// The stop that is to be looked from next for something near `hint`; `seen`: those that were. Empty
// when none is left within `max_m` of the hint that can be reached.
std::optional<std::size_t> next_stop(const agent::AisleMap& map,
                                     const std::vector<ViewStop>& stops,
                                     const std::vector<bool>& seen,
                                     const robots::BasePlace& from,
                                     Vec2 hint,
                                     double max_m);

}  // namespace marketgen::policy
