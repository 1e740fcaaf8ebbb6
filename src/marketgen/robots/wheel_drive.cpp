#include "robots/wheel_drive.h"

#include <algorithm>
#include <cmath>

#include "robots/dynamics.h"

namespace marketgen::robots {
namespace {

// Of the robot's mass on its tyres, critically damped: firm rubber, 1 mm under half of its weight.
constexpr double tyre_quickness = 60;  // rad/s

double change_towards(double from, double to, double max_change) {
  return from + std::clamp(to - from, -max_change, max_change);
}

}  // namespace

WheelDrive::WheelDrive(const Robot& robot, const BasePlace& place)
    : drive_(*robot.drive), reckoned_(place) {
  const int yaw = robot.find_dof("base_yaw");
  if (yaw >= 0)
    max_turn_acceleration_ = robot.joint_of_dof(static_cast<std::size_t>(yaw)).acceleration;
  const double mass = total_mass(robot);
  stiffness_ = mass * tyre_quickness * tyre_quickness / 2;
  damping_ = mass * tyre_quickness;
  max_grip_n_ = drive_.tyre_friction * drive_.wheel_load * mass * standard_gravity / 2;
  max_motor_n_ = drive_.wheel_torque / drive_.wheel_radius;
}

WheelDrive::Pull WheelDrive::pull(
    Wheel& wheel, double along_m_s, double across_m_s, double rim_m_s, double step_s) const {
  const double slip = rim_m_s - along_m_s;
  Pull pull{stiffness_ * wheel.along_m + damping_ * slip,
            stiffness_ * wheel.across_m - damping_ * across_m_s,
            rim_m_s};
  wheel.along_m += slip * step_s;
  wheel.across_m -= across_m_s * step_s;
  const double load = std::hypot(pull.along_n, pull.across_n);
  if (load > max_grip_n_) {  // it slides
    pull.along_n *= max_grip_n_ / load, pull.across_n *= max_grip_n_ / load;
    wheel = {pull.along_n / stiffness_, pull.across_n / stiffness_};
  }
  if (std::abs(pull.along_n) > max_motor_n_) {  // the motor cannot turn it on
    pull.along_n = std::copysign(max_motor_n_, pull.along_n);
    wheel.along_m = pull.along_n / stiffness_;
    pull.rolled_m_s = along_m_s;
  }
  return pull;
}

void WheelDrive::reckon(double left_m_s, double right_m_s, double step_s) {
  const double along = (left_m_s + right_m_s) / 2 * step_s;
  const double turn = (right_m_s - left_m_s) / drive_.wheel_track * step_s;
  const double middle = reckoned_.heading + turn / 2;
  const double a = drive_.axle_x;
  reckoned_.x_m += along * std::cos(middle) + a * turn * std::sin(middle);
  reckoned_.y_m += along * std::sin(middle) - a * turn * std::cos(middle);
  reckoned_.heading += turn;
}

FloorForce WheelDrive::push(const FloorMotion& now,
                            double drive_m_s,
                            double turn_rad_s,
                            double step_s) {
  speed_ = change_towards(
      speed_, std::clamp(drive_m_s, -drive_.speed, drive_.speed), drive_.acceleration * step_s);
  turn_ = change_towards(turn_,
                         std::clamp(turn_rad_s, -drive_.turn_rate, drive_.turn_rate),
                         max_turn_acceleration_ * step_s);
  const double cosine = std::cos(now.place.heading), sine = std::sin(now.place.heading);
  const double along = now.vx_m_s * cosine + now.vy_m_s * sine;
  const double across = now.vy_m_s * cosine - now.vx_m_s * sine + now.turn_rad_s * drive_.axle_x;
  const double half = drive_.wheel_track / 2;
  const auto wheel = [&](std::size_t which, double side) {
    return pull(wheels_[which],
                along - side * half * now.turn_rad_s,
                across,
                speed_ - side * half * turn_,
                step_s);
  };
  const Pull left = wheel(0, 1), right = wheel(1, -1);
  reckon(left.rolled_m_s, right.rolled_m_s, step_s);
  const double ahead = left.along_n + right.along_n, aside = left.across_n + right.across_n;
  return {ahead * cosine - aside * sine,
          ahead * sine + aside * cosine,
          (right.along_n - left.along_n) * half + aside * drive_.axle_x};
}

}  // namespace marketgen::robots
