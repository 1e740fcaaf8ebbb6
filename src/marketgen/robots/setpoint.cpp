#include "robots/setpoint.h"

#include <algorithm>
#include <cmath>

namespace marketgen::robots {
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

// Over how many steps a mean turns full acceleration into full braking within the jerk.
std::size_t steps_to_turn(const SetpointLimits& limits, double step_s) {
  constexpr double rounding = 1e-9;
  if (!std::isfinite(limits.acceleration) || !std::isfinite(limits.jerk) || limits.jerk <= 0)
    return 1;
  const double steps = 2 * limits.acceleration / (limits.jerk * step_s);
  return static_cast<std::size_t>(std::max(1.0, std::ceil(steps - rounding)));
}

Setpoint mean_of(const std::vector<Setpoint>& list) {
  Setpoint sum;
  for (const Setpoint& each : list)
    sum.position += each.position, sum.velocity += each.velocity;
  const auto count = static_cast<double>(list.size());
  return {sum.position / count, sum.velocity / count};
}

}  // namespace

SetpointLimits setpoint_limits(const Joint& joint) {
  return {joint.lower, joint.upper, joint.velocity, joint.acceleration, joint.jerk};
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

void Setpoint::keep_near(const Setpoint& joint, double reach) {
  const double near = std::clamp(position, joint.position - reach, joint.position + reach);
  const bool runs_away = (near - position) * velocity < 0;
  position = near;
  if (runs_away)
    velocity = std::clamp(joint.velocity, std::min(velocity, 0.0), std::max(velocity, 0.0));
}

void SmoothSetpoint::follow(const Setpoint& wanted, const SetpointLimits& limits, double step_s) {
  if (recent_.empty()) recent_.assign(steps_to_turn(limits, step_s), now_);
  const double late_s = static_cast<double>(recent_.size() - 1) / 2 * step_s;  // the mean is
  Setpoint next = recent_.back();
  next.follow({wanted.position + wanted.velocity * late_s, wanted.velocity}, limits, step_s);
  recent_.erase(recent_.begin());
  recent_.push_back(next);
  const double before = now_.velocity;
  now_ = mean_of(recent_);
  acceleration_ = std::isfinite(limits.acceleration) ? (now_.velocity - before) / step_s : 0;
}

void SmoothSetpoint::keep_near(const Setpoint& joint, double reach) {
  Setpoint kept = now_;
  kept.keep_near(joint, reach);
  if (kept.position == now_.position) return;
  now_ = kept;
  acceleration_ = 0;
  std::ranges::fill(recent_, now_);
}

}  // namespace marketgen::robots
