// The quickest motion from rest to rest along one coordinate under limits of velocity, acceleration
// and jerk: at most seven pieces of constant jerk (the "double S" of Biagiotti and Melchiorri,
// Trajectory Planning for Automatic Machines and Robots, 2008, section 3.4). Ruckig finds the same
// times, to the last digit but one, in 40 times the time (docs/architecture.md, "Why our own").
#pragma once

namespace marketgen::motion {

struct MotionLimits {
  double velocity = 1, acceleration = 1, jerk = 1;  // units/s, units/s^2, units/s^3; > 0
};

struct MotionState {
  double position = 0, velocity = 0, acceleration = 0;
};

// Precondition: distance >= 0 and limits > 0, all finite.
class SCurve {
 public:
  SCurve() = default;
  SCurve(double distance, const MotionLimits& limits);

  double duration_s() const { return 2 * (2 * jerk_s_ + steady_s_) + cruise_s_; }
  MotionState at(double time_s) const;  // before 0 and after the end: at rest there

 private:
  MotionState starting(double time_s) const;  // in the first half and the cruise

  double distance_ = 0, jerk_ = 1;
  // Time with rising jerk (as long as with falling), with steady acceleration, at full speed.
  double jerk_s_ = 0, steady_s_ = 0, cruise_s_ = 0;
};

}  // namespace marketgen::motion
