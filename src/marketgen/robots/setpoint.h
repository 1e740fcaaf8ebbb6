// Where a drive is told to be: a setpoint that goes after what is wanted of it and keeps the limits
// of its joint on the way, whatever that is. Real controllers either do this (libfranka's
// `limitRate`) or refuse a command that would need more.
#pragma once
#include <vector>

#include "robots/robot.h"

namespace marketgen::robots {

// Of one joint, per second, per second squared and per second cubed; rad or m.
struct SetpointLimits {
  double lower = -Joint::unlimited, upper = Joint::unlimited;
  double velocity = Joint::unlimited, acceleration = Joint::unlimited, jerk = Joint::unlimited;
};
SetpointLimits setpoint_limits(const Joint& joint);

struct Setpoint {
  double position = 0, velocity = 0;

  // One step of `step_s` towards `wanted`, which is where it should be at the end of the step and
  // how fast it should then go. What keeps the limits is followed exactly; after anything else it
  // comes back to it as quickly as they allow, whatever the jerk. Where the joint ends it has
  // stopped.
  void follow(const Setpoint& wanted, const SetpointLimits& limits, double step_s);

  // At most `reach` from where the joint is: what is held back does not run ahead, and goes on no
  // faster than the joint does.
  void keep_near(const Setpoint& joint, double reach);
};

// A setpoint that keeps its joint's jerk too: the mean over as many steps as it takes to turn full
// acceleration into full braking (a box filter: velocity and acceleration stay within their limits;
// Biagiotti, Melchiorri, Trajectory Planning for Automatic Machines and Robots, 2008, 4.6). Of a
// joint without a jerk it is the plain setpoint.
class SmoothSetpoint {
 public:
  SmoothSetpoint() = default;
  explicit SmoothSetpoint(const Setpoint& start) : now_(start) {}

  // As Setpoint::follow, but for half the filter's time times the change of velocity; always with
  // the same limits and step.
  void follow(const Setpoint& wanted, const SetpointLimits& limits, double step_s);
  void keep_near(const Setpoint& joint, double reach);

  const Setpoint& now() const { return now_; }
  // Of the last step; 0 where it was held back, and where the joint has no limit: it jumps.
  double acceleration() const { return acceleration_; }

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.now_, self.acceleration_, self.recent_);
  }

 private:
  Setpoint now_;
  double acceleration_ = 0;
  std::vector<Setpoint> recent_;  // the plain setpoint, oldest first; empty before the first step
};

}  // namespace marketgen::robots
