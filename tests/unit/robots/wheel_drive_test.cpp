// A drive on its wheels: it goes as told while they grip, slides where they do not, and reckons by
// its encoders alone.
#include "robots/wheel_drive.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robots/dynamics.h"
#include "support/committed_robot.h"

namespace marketgen {
namespace {

constexpr double step_s = 0.002;

// A rigid base of the robot's mass on the floor, its middle at its origin; `wall_x`: it goes no
// farther ahead.
struct Base {
  robots::Robot robot = committed_robot("realman-rm75");
  robots::WheelDrive wheels{robot, {}};
  robots::FloorMotion now = {};
  double mass = robots::total_mass(robot), gyration_m2 = 0.06, wall_x = 1e9;
  double max_force_n = 0, max_change_m_s = 0;

  void run(double drive_m_s, double turn_rad_s, double seconds) {
    for (int i = 0; i < static_cast<int>(seconds / step_s); ++i) {
      const robots::FloorForce force = wheels.push(now, drive_m_s, turn_rad_s, step_s);
      max_force_n = std::max(max_force_n, std::hypot(force.x_n, force.y_n));
      const double before = now.vx_m_s;
      now.vx_m_s += force.x_n / mass * step_s;
      now.vy_m_s += force.y_n / mass * step_s;
      now.turn_rad_s += force.turn_n_m / (mass * gyration_m2) * step_s;
      if (now.place.x_m >= wall_x) now.vx_m_s = std::min(now.vx_m_s, 0.0);
      max_change_m_s = std::max(max_change_m_s, now.vx_m_s - before);
      now.place.x_m += now.vx_m_s * step_s;
      now.place.y_m += now.vy_m_s * step_s;
      now.place.heading += now.turn_rad_s * step_s;
    }
  }
  double grip_n() const {
    return robot.drive->tyre_friction * robot.drive->wheel_load * mass * standard_gravity;
  }
};

TEST(WheelDrive, GoesAsToldAndKnowsWhereItIs) {
  Base base;
  base.run(1e3, 0, 2);
  EXPECT_NEAR(base.now.vx_m_s, base.robot.drive->speed, 1e-3);
  EXPECT_LT(base.max_change_m_s, 1.2 * base.robot.drive->acceleration * step_s)
      << "what the tyres give and take back included";
  base.run(0, 0, 2.5);
  base.run(0, 0.8, 1.5);
  base.run(0.3, -0.4, 1.5);
  base.run(0, 0, 1);
  EXPECT_NEAR(base.now.vx_m_s, 0, 1e-4);
  EXPECT_NEAR(base.wheels.reckoned().x_m, base.now.place.x_m, 2e-3);
  EXPECT_NEAR(base.wheels.reckoned().y_m, base.now.place.y_m, 2e-3);
  EXPECT_NEAR(base.wheels.reckoned().heading, base.now.place.heading, 2e-3);
}

TEST(WheelDrive, AgainstAWallItsWheelsSpinAndItsReckoningGoesOn) {
  Base base;
  base.wall_x = 0.2;
  base.run(0.5, 0, 3);
  EXPECT_NEAR(base.now.place.x_m, 0.2, 5e-3);
  EXPECT_GT(base.wheels.reckoned().x_m, 1.0);
  EXPECT_LT(base.max_force_n, 1.0001 * base.grip_n());
  EXPECT_GT(base.max_force_n, 0.9 * base.grip_n());
}

TEST(WheelDrive, WeakMotorsStallWithoutSlipping) {
  Base base;
  base.robot.drive->wheel_torque = 5;
  base.wheels = robots::WheelDrive(base.robot, {});
  base.wall_x = 0.2;
  base.run(0.5, 0, 3);
  EXPECT_NEAR(base.wheels.reckoned().x_m, base.now.place.x_m, 5e-3);
  EXPECT_LT(base.max_force_n, 1.0001 * 2 * 5 / base.robot.drive->wheel_radius);
}

TEST(WheelDrive, APushFromTheSideIsHeldUntilTheTyresSlide) {
  Base base;
  const auto pushed_m = [&](double force_n) {
    base.now = {};
    base.wheels = robots::WheelDrive(base.robot, {});
    for (int i = 0; i < 500; ++i) {
      base.now.vy_m_s += force_n / base.mass * step_s;
      base.run(0, 0, step_s * 1.5);
    }
    return base.now.place.y_m;
  };
  EXPECT_LT(pushed_m(0.5 * base.grip_n()), 2e-3);
  EXPECT_GT(pushed_m(1.2 * base.grip_n()), 0.1);
}

}  // namespace
}  // namespace marketgen
