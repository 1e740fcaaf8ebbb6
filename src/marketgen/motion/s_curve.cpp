#include "motion/s_curve.h"

#include <algorithm>
#include <cmath>

namespace marketgen::motion {

SCurve::SCurve(double distance, const MotionLimits& limits)
    : distance_(distance), jerk_(limits.jerk) {
  if (distance <= 0) return;
  const double v = limits.velocity, a = limits.acceleration, j = limits.jerk;
  const bool full_acceleration = v * j >= a * a;  // on the way to full speed
  jerk_s_ = full_acceleration ? a / j : std::sqrt(v / j);
  steady_s_ = full_acceleration ? v / a - jerk_s_ : 0;
  const double to_full_speed_and_back = v * (2 * jerk_s_ + steady_s_);
  if (distance >= to_full_speed_and_back) {
    cruise_s_ = (distance - to_full_speed_and_back) / v;
  } else if (full_acceleration && distance >= 2 * a * a * a / (j * j)) {
    // distance = a (jerk_s + steady_s) (2 jerk_s + steady_s), solved for steady_s.
    steady_s_ = (std::sqrt(jerk_s_ * jerk_s_ + 4 * distance / a) - 3 * jerk_s_) / 2;
  } else {
    jerk_s_ = std::cbrt(distance / (2 * j));
    steady_s_ = 0;
  }
}

MotionState SCurve::starting(double t) const {
  const double j = jerk_, a = j * jerk_s_;
  if (t <= jerk_s_) return {j * t * t * t / 6, j * t * t / 2, j * t};
  MotionState s{j * jerk_s_ * jerk_s_ * jerk_s_ / 6, j * jerk_s_ * jerk_s_ / 2, a};
  const double steady = std::min(t - jerk_s_, steady_s_);
  s.position += s.velocity * steady + a * steady * steady / 2;
  s.velocity += a * steady;
  const double fall = std::min(t - jerk_s_ - steady_s_, jerk_s_);
  if (fall <= 0) return s;
  s.position += s.velocity * fall + a * fall * fall / 2 - j * fall * fall * fall / 6;
  s.velocity += a * fall - j * fall * fall / 2;
  s.acceleration -= j * fall;
  const double cruise = t - 2 * jerk_s_ - steady_s_;
  if (cruise > 0) s = {s.position + s.velocity * cruise, s.velocity, 0};
  return s;
}

MotionState SCurve::at(double time_s) const {
  const double whole = duration_s();
  if (time_s <= 0 || whole <= 0) return {0, 0, 0};
  if (time_s >= whole) return {distance_, 0, 0};
  if (time_s <= whole - 2 * jerk_s_ - steady_s_) return starting(time_s);
  const MotionState mirrored = starting(whole - time_s);  // the stop is the start run backwards
  return {distance_ - mirrored.position, mirrored.velocity, -mirrored.acceleration};
}

}  // namespace marketgen::motion
