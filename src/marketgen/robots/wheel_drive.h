// A differential drive as it stands on the floor: two wheels whose motors and whose grip are
// bounded, and what their encoders make of where they went.
//
// Each tyre is a bristle (Dahl, "A solid friction model", 1968; Canudas de Wit et al., "Dynamic
// friction models for longitudinal road/tire interaction", 2003): it gives under a load like a
// spring, and slides as soon as that is more than its friction. Until a tyre slides the encoders
// tell where the robot is; from then on they do not.
#pragma once
#include <array>

#include "geometry/pose.h"
#include "robots/robot.h"

namespace marketgen::robots {

// Of a base that drives: on the floor, heading about Z from X.
struct BasePlace {
  double x_m = 0, y_m = 0, heading = 0;
};
// Of the base's origin, in the frame of the floor.
struct FloorMotion {
  BasePlace place;
  double vx_m_s = 0, vy_m_s = 0, turn_rad_s = 0;
};
// On the base, at its origin, in the frame of the floor.
struct FloorForce {
  double x_n = 0, y_n = 0, turn_n_m = 0;
};

class WheelDrive {
 public:
  WheelDrive() = default;
  // `robot` has a drive. It stands at `place`, where its reckoning begins.
  WheelDrive(const Robot& robot, const BasePlace& place);

  // What the wheels do to the robot during the next `step_s`, told to go as fast as this at its
  // end. Limits of the drive's row: speed, turn rate, and how quickly either changes.
  FloorForce push(const FloorMotion& now, double drive_m_s, double turn_rad_s, double step_s);

  double drive_m_s() const { return speed_; }  // what the wheels are told now
  double turn_rad_s() const { return turn_; }
  // Where the robot would stand if its wheels had not slipped.
  const BasePlace& reckoned() const { return reckoned_; }

  // What changes; its row it has from the constructor.
  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.speed_, self.turn_, self.reckoned_, self.wheels_);
  }

 private:
  // Of the bristle, base frame: along and across.
  struct Wheel {
    double along_m = 0, across_m = 0;
  };
  struct Pull {
    double along_n = 0, across_n = 0, rolled_m_s = 0;  // rolled: over the floor, by the encoder
  };
  Pull pull(Wheel& wheel, double along_m_s, double across_m_s, double rim_m_s, double step_s) const;
  void reckon(double left_m_s, double right_m_s, double step_s);

  Drive drive_;
  double max_turn_acceleration_ = 0;
  double stiffness_ = 0, damping_ = 0;       // of one tyre, N/m and N s/m
  double max_grip_n_ = 0, max_motor_n_ = 0;  // of one wheel, at the floor
  double speed_ = 0, turn_ = 0;
  BasePlace reckoned_;
  std::array<Wheel, 2> wheels_;  // left, right
};

}  // namespace marketgen::robots
