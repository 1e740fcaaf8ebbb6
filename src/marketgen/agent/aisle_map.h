// What an agent knows of a store before it looks: the map, and where products of a category are.
//
// Of goods the map knows nothing. Store frame, metres.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "agent/policy.h"
#include "assets/fixtures/fixture_model.h"
#include "base/result.h"
#include "geometry/pose.h"
#include "motion/base_follower.h"
#include "motion/collision_world.h"
#include "motion/way_round.h"

namespace marketgen::agent {

// Its frame: middle of the front edge, on the surface; X to the right of who looks at it, Y into
// the shelf, Z up.
struct ShelfBoard {
  Pose store_from_board;
  double width_m = 0, depth_m = 0;
  double clearance_m = 0;                          // to what is over it
  assets::ShelfUse use = assets::ShelfUse::stand;  // what goods do on it
  bool has_door = false;                           // between it and the aisle
};

// Middle of all products of the category that a goal's product belongs to.
struct CategoryHint {
  std::size_t goal = 0;  // number of the task's goal
  Vec2 position;
};

class AisleMap {
 public:
  virtual ~AisleMap() = default;
  // All of the store, whether anything is asked for from them or not.
  virtual const std::vector<ShelfBoard>& boards() const = 0;
  // Whether the robot, as it drives, has room there to turn.
  virtual bool has_room(const robots::BasePlace& place) const = 0;
  // From rest to rest. Errors: motion.base_blocked, motion.unreachable and those of plan_drive.
  virtual Result<motion::BaseFollower> way(const robots::BasePlace& from,
                                           const robots::BasePlace& to) const = 0;
  // On from where people, in the frame of the store, hold the robot up; `waited`: for them
  // in vain. Errors: likewise.
  virtual Result<motion::WayRound> way_round(const robots::BasePlace& from,
                                             const robots::BasePlace& to,
                                             std::span<const motion::MovingDisc> people,
                                             bool waited) const = 0;
  // Its length; empty when there is none.
  virtual std::optional<double> way_m(const robots::BasePlace& from,
                                      const robots::BasePlace& to) const = 0;
  // Fixtures, walls and floor within `within_m`.
  virtual motion::Obstacles fixtures(Vec3 middle, double within_m) const = 0;
};

inline Pose store_from_base(const robots::BasePlace& place) {
  return {{place.x_m, place.y_m, 0}, rotation_about({0, 0, 1}, place.heading)};
}

inline robots::BasePlace base_place(const Pose& store_from_base) {
  return {store_from_base.position.x, store_from_base.position.y, yaw_of(store_from_base.rotation)};
}

}  // namespace marketgen::agent
