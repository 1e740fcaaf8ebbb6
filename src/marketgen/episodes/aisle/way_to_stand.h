// How a robot in an aisle gets to where the episode's witness takes its product: what learners who
// drive are shown and paid for. The truth.
#pragma once
#include "base/result.h"
#include "geometry/vector.h"
#include "robots/wheel_drive.h"

namespace marketgen::episodes {

class AisleWorld;

// Directions are those of the robot's base: x ahead, y to the left. SI units.
struct WayToStand {
  Vec3 corner;              // from the middle between its wheels to where the way turns, or ends
  double way_m = 0;         // length of the shortest way among the fixtures
  robots::BasePlace stand;  // where the base is to be, in the frame of the base
  double speed_m_s = 0, turn_rad_s = 0;
};

// Where the robot stands nearer to something than ways lead, the way is a straight line. Error
// episode.impossible: the episode has no witness.
Result<WayToStand> way_to_stand(const AisleWorld& world);

}  // namespace marketgen::episodes
