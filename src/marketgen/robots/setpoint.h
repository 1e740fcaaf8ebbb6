// Where a drive is told to be: a setpoint that goes after what is wanted of it and keeps the limits
// of its joint on the way, whatever that is. Real controllers either do this (libfranka's
// `limitRate`) or refuse a command that would need more.
#pragma once

#include "robots/robot.h"

namespace marketgen {

// Of one joint, per second and per second squared; rad or m.
struct SetpointLimits {
  double lower = -Joint::unlimited, upper = Joint::unlimited;
  double velocity = Joint::unlimited, acceleration = Joint::unlimited;
};
SetpointLimits setpoint_limits(const Joint& joint);

struct Setpoint {
  double position = 0, velocity = 0;

  // One step of `step_s` towards `wanted`, which is where it should be at the end of the step and
  // how fast it should then go. What keeps the limits is followed exactly; after anything else it
  // comes back to it as quickly as they allow. Where the joint ends it has stopped.
  void follow(const Setpoint& wanted, const SetpointLimits& limits, double step_s);

  // At most `reach` from where the joint is: what is held back does not run ahead.
  void keep_near(double joint_position, double reach);
};

}  // namespace marketgen
