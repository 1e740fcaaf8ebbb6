#include "robots/setpoint.h"

#include <algorithm>
#include <cmath>

namespace marketgen {
namespace {

// Fastest approach, a second, from which the setpoint still stops within `way`: in m steps, each
// slower than the one before by acceleration x step_s, and the last by no more.
double approach(double way, double acceleration, double step_s) {
  if (way <= 0) return 0;
  if (!std::isfinite(acceleration)) return way / step_s;
  const double lost = acceleration * step_s, ways = way / (lost * step_s);
  const double m = std::max(1.0, std::ceil(std::sqrt(0.25 + 2 * ways) - 0.5));
  return lost * (ways / m + (m - 1) / 2);
}

}  // namespace

SetpointLimits setpoint_limits(const Joint& joint) {
  return {joint.lower, joint.upper, joint.velocity, joint.acceleration};
}

void Setpoint::follow(const Setpoint& wanted, const SetpointLimits& limits, double step_s) {
  const double ahead = wanted.position - position - wanted.velocity * step_s;
  const double catching = approach(std::abs(ahead), limits.acceleration, step_s);
  double next = wanted.velocity + std::copysign(catching, ahead);
  next = std::clamp(next, -limits.velocity, limits.velocity);
  next = std::clamp(next,
                    -approach(position - limits.lower, limits.acceleration, step_s),
                    approach(limits.upper - position, limits.acceleration, step_s));
  const double change = limits.acceleration * step_s;
  velocity = std::clamp(next, velocity - change, velocity + change);
  position = std::clamp(position + velocity * step_s, limits.lower, limits.upper);
}

void Setpoint::keep_near(double joint_position, double reach) {
  const double near = std::clamp(position, joint_position - reach, joint_position + reach);
  const bool runs_away = (near - position) * velocity < 0;
  position = near;
  if (runs_away) velocity = 0;
}

}  // namespace marketgen
