// Queues what opens or shuts a door on the executor of a robot that stands where it was planned.
#pragma once
#include "skills/body_executor.h"
#include "skills/door_ways.h"

namespace marketgen::skills {

// The bar is gripped with so much: the pads' friction on it bears nearly twice the pull of a
// gasket.
constexpr double bar_grip_n = 45;

// With a plan of plan_open_door(): the lift to its height, one hand pulls the door open, the other
// pushes it on to where it stays; both go home. With one of plan_shut_door() a hand presses it
// shut. Errors: motion.bad_limits.
Result<void> queue_door(BodyExecutor& body, const robots::Robot& robot, const DoorPlan& plan);

}  // namespace marketgen::skills
