// Stage::open: the robot of In-Aisle Item Collection stands before a glass door and is to pull it
// open. The doors are those that DoorBook opens and shuts, places and arms those by which
// plan_pull_door() pulls them, so that there is a way to do it. Store frame, SI units; a door's
// position is in rad.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "episodes/aisle/door_book.h"
#include "episodes/episode_origin.h"
#include "skills/door_moves.h"

namespace marketgen::episodes {

class AisleWorld;

// A gripper that an action shuts presses so hard.
constexpr double opening_grip_n = skills::bar_grip_n;

// So far is the door to be opened, a little farther than the 48 degrees from which on the oracle's
// other hand finds room behind the leaf, to push it on to where it stays (plan_open_door()).
constexpr double opened_rad = 50 * std::numbers::pi / 180;

// Of one store that was opened for goals behind hinged doors. Any number of threads may ask.
class DoorStages {
 public:
  explicit DoorStages(const std::shared_ptr<const AisleStore>& store);

  // One of its doors, drawn; the robot 1 cm and 1 degree off at most from where it is opened from.
  // Its goal is a product behind that door. Errors: episode.impossible, no door of the store is
  // opened, or no place is free; those of DoorBook::before.
  Result<EpisodeSpec> draw(const EpisodeOrigin& origin, Seed seed);

  // Every degree of freedom, the open hand on its way to the bar, 6 cm before it or less where the
  // arm has no room for that. Errors: those of witness_of and plan_pull_door; episode.impossible,
  // its witness opens no door of this store.
  Result<std::vector<double>> hand_before_bar(const EpisodeSpec& spec);

 private:
  struct Ready {
    std::string arm;            // that pulls
    std::vector<double> state;  // every degree of freedom
    FloorPlaceRow stand;
  };
  Result<Ready> ready(std::uint32_t joint);  // planned once; so are errors
  Result<Ready> planned(std::uint32_t joint) const;
  // None when the door is not opened, or no place is free before it.
  Result<std::optional<EpisodeSpec>> before(std::uint32_t joint, EpisodeSpec spec, Stream& draw);

  std::shared_ptr<const AisleStore> store_;
  DoorBook book_;
  std::map<std::uint32_t, std::uint32_t> goods_;  // by door: a product behind it within reach
  std::mutex mutex_;
  std::map<std::uint32_t, Result<Ready>> known_;  // by door
};

// The door of an episode's witness, a row of Scene::joints. Errors: those of witness_of;
// episode.impossible, the witness has none, or none of this store.
Result<std::uint32_t> witnessed_door(const AisleStore& store, const EpisodeSpec& spec);

// How that door stands to the hand which is to open it: what learners are shown and paid for.
// Directions are those of the robot's base: x ahead, y to the left.
struct DoorSeen {
  std::string arm;
  double side = 0;        // 1 where the hinge is on the left of who looks at the door, else -1
  Vec3 tool;              // the hand's tip
  Vec3 to_bar;            // from there to the middle of the bar
  double behind_rad = 0;  // by how much the hand is turned less than the leaf, about the hinge
  double into_rad = 0;    // where a straight push on the leaf points, from x to the left
  double position_rad = 0, speed_rad_s = 0;
  double asked_rad = 0;  // opened_rad
  bool held = false;     // both fingers of a hand are on it
  bool clean = false;    // nothing has happened that no clean episode has, but for the open door
};
// Errors: those of witnessed_door.
Result<DoorSeen> door_seen(const AisleWorld& world);

}  // namespace marketgen::episodes
