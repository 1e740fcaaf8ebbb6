#include "motion/base_follower.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

namespace marketgen::motion {
namespace {

constexpr double arrived = 1e-9;  // m or rad
constexpr double hardly_nearer_m = 0.01;

Vec2 in_metres(PointMm p) {
  return {p[0] * 1e-3, p[1] * 1e-3};
}

double wrapped(double angle) {
  return std::remainder(angle, 2 * std::numbers::pi);
}

// The fastest rate after a step of `dt` from which `left` still suffices to stop:
// v dt + v^2 / (2 a) = left. Following it asks for no more than `a`.
double stoppable(double left, double a, double dt) {
  return std::sqrt(a * a * dt * dt + 2 * a * std::max(left, 0.0)) - a * dt;
}

double next_rate(double rate, double cap, double a, double dt) {
  return std::max(std::min(rate + a * dt, cap), rate - a * dt);
}

bool usable(double limit) {
  return limit > 0 && std::isfinite(limit);
}

}  // namespace

Result<BaseLimits> base_limits(const robots::Robot& robot) {
  const int yaw = robot.find_dof("base_yaw");
  if (!robot.drive || yaw < 0)
    return Error{"motion.bad_limits", robot.name, "the robot's row has no drive or no base_yaw"};
  const robots::Drive& drive = *robot.drive;
  return BaseLimits{drive.speed,
                    drive.acceleration,
                    drive.turn_rate,
                    robot.joint_of_dof(static_cast<std::size_t>(yaw)).acceleration,
                    drive.wheel_track,
                    drive.wheel_radius};
}

Result<BaseFollower> BaseFollower::make(const navigation::FloorPath& path,
                                        double heading,
                                        std::optional<double> end_heading,
                                        const BaseLimits& limits,
                                        const BaseOptions& options) {
  for (const double limit : {limits.speed,
                             limits.acceleration,
                             limits.turn_rate,
                             limits.turn_acceleration,
                             limits.wheel_track,
                             limits.wheel_radius}) {
    if (!usable(limit))
      return Error{"motion.bad_limits", "base", "each limit must be positive and finite"};
  }
  if (path.points.empty() || !std::isfinite(heading) || !std::isfinite(end_heading.value_or(0)))
    return Error{"motion.bad_configuration", "base path", "needs a point and finite headings"};
  BaseFollower follower;
  follower.limits_ = limits;
  follower.options_ = options;
  follower.state_ = {in_metres(path.points.front()), wrapped(heading), 0, 0};
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
    const Vec2 a = in_metres(path.points[i]), b = in_metres(path.points[i + 1]), d = b - a;
    const double length = std::hypot(d.x, d.y);
    if (length <= 0) continue;
    const double along = std::atan2(d.y, d.x);
    follower.legs_.push_back({true, along, 0, a});
    follower.legs_.push_back({false, along, length, a});
  }
  if (end_heading)
    follower.legs_.push_back({true, wrapped(*end_heading), 0, in_metres(path.points.back())});
  return follower;
}

void BaseFollower::turn(const Leg& leg, double dt) {
  if (!turning_) {
    turning_ = true;
    left_ = wrapped(leg.heading - state_.heading);
  }
  const double side = left_ < 0 ? -1 : 1, a = limits_.turn_acceleration;
  const double cap = std::min(limits_.turn_rate, stoppable(std::abs(left_), a, dt));
  const double rate = next_rate(std::abs(state_.turn_rate), cap, a, dt);
  left_ -= side * rate * dt;
  state_.heading = wrapped(state_.heading + side * rate * dt);
  state_.turn_rate = side * rate;
  if (std::abs(left_) > arrived) return;
  state_.heading = leg.heading;
  state_.turn_rate = 0;
  turning_ = false;
  ++next_;
}

// How far the base may go along this leg before a disc could touch it while it still moves.
// Infinity when none can.
double BaseFollower::room_ahead(const Leg& leg, std::span<const MovingDisc> discs) const {
  const Vec2 ahead{std::cos(leg.heading), std::sin(leg.heading)};
  const double to_stop = options_.reaction_s + limits_.speed / limits_.acceleration;
  double room = std::numeric_limits<double>::infinity();
  for (const MovingDisc& disc : discs) {
    const Vec2 off = disc.position - state_.position;
    const double along = off.x * ahead.x + off.y * ahead.y;
    const double across = off.x * ahead.y - off.y * ahead.x;
    const double clear =
        options_.base_radius + options_.margin + disc.radius + disc.speed * to_stop;
    const double half = std::sqrt(std::max(clear * clear - across * across, 0.0));
    if (!std::isfinite(along + across + clear)) return 0;
    // Who is too near already does not hold it where it comes hardly nearer to them.
    if (half <= 0 || along <= 0 || std::abs(across) > std::hypot(along, across) - hardly_nearer_m)
      continue;
    room = std::min(room, std::max(along - half, 0.0));
  }
  return room;
}

void BaseFollower::drive(const Leg& leg, double dt, std::span<const MovingDisc> discs) {
  const double left = leg.length - driven_, room = room_ahead(leg, discs);
  const double a = limits_.acceleration;
  const double cap = std::min(limits_.speed, stoppable(std::min(left, room), a, dt));
  // An obstacle that appears too near is braked for at the limit, not over it.
  state_.speed = next_rate(state_.speed, cap, a, dt);
  waits_ = room < left && state_.speed < 1e-3;
  driven_ = std::min(driven_ + state_.speed * dt, leg.length);
  state_.position = leg.from + Vec2{std::cos(leg.heading), std::sin(leg.heading)} * driven_;
  if (leg.length - driven_ > arrived) return;
  state_.speed = 0;
  driven_ = 0;
  ++next_;
}

const BaseState& BaseFollower::step(double dt, std::span<const MovingDisc> discs) {
  waits_ = false;
  if (done()) return state_;
  const Leg& leg = legs_[next_];
  if (leg.turns) {
    turn(leg, dt);
  } else {
    drive(leg, dt, discs);
  }
  return state_;
}

WheelRates BaseFollower::wheels() const {
  const double across = state_.turn_rate * limits_.wheel_track / 2;
  return {(state_.speed - across) / limits_.wheel_radius,
          (state_.speed + across) / limits_.wheel_radius};
}

}  // namespace marketgen::motion
