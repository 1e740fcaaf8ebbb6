// A robot's way over a floor: how much room it takes as it holds its lift and arms, the shortest
// path where that much is free, and the base that follows it.
//
// The robot counts as the upright cylinder about the axis on which it turns that holds all of it,
// so that it may turn on the spot anywhere on its way. Metres and radians.
#pragma once
#include <span>

#include "base/result.h"
#include "motion/base_follower.h"
#include "navigation/visibility_graph.h"
#include "robots/robot.h"

namespace marketgen::motion {

// Of all of its links' capsules, whatever its base joints say.
struct BaseEnvelope {
  double radius_m = 0;  // about the turning axis
  double height_m = 0;  // over the floor
};
// Errors: motion.bad_limits for a robot without a drive; those of check_state.
Result<BaseEnvelope> base_envelope(const robots::Robot& robot, std::span<const double> state);

struct FloorPlace {
  Vec2 position;
  double heading = 0;  // about Z from X
};
struct DrivePlan {
  navigation::FloorPath path;
  BaseFollower follower;  // at rest at the start
};

// Slower than the limits of the robot's row, so that there is room to steer back to the way.
// Errors: those of base_envelope, motion.bad_configuration for a place that is not finite,
// motion.outside_floor, motion.base_blocked (an end is too near to something), motion.unreachable.
// `past`: those who stand there for now.
Result<DrivePlan> plan_drive(const navigation::VisibilityGraph& graph,
                             const robots::Robot& robot,
                             std::span<const double> state,
                             const FloorPlace& from,
                             const FloorPlace& to,
                             std::span<const MovingDisc> past = {});

}  // namespace marketgen::motion
