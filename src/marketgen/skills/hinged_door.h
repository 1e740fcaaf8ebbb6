// A door on an upright hinge, as whoever opens it needs to know it: where it hangs, the bar by
// which it is pulled, what of it an arm must not meet.
//
// A door's position is the angle by which it is open, rad. World frame, SI units.
#pragma once
#include <array>

#include "motion/collision_world.h"

namespace marketgen::skills {

struct HingedDoor {
  Vec3 hinge;                    // a point of the axis, on the floor
  Vec3 along, out;               // level unit vectors: along the closed leaf, and to where it opens
  double length_m = 0;           // from the hinge to the free edge
  double low_m = 0, high_m = 0;  // of the leaf over the floor
  double face_m = 0, back_m = 0;  // of its outer and inner face, along `out` from the hinge
  double hold_rad = 0;            // from where on it stays open by itself; 0: nowhere
  double open_rad = 0;            // as far as it goes
  motion::Obstacles leaf = {};    // all that turns, as it stands when closed

  // An upright round bar before the outer face.
  struct Bar {
    double along_m = 0, out_m = 0;  // of its axis, from the hinge
    double low_m = 0, high_m = 0;   // its ends, over the floor
    double radius_m = 0;
  } bar = {};

  // 1: it opens counter-clockwise as seen from above, otherwise -1.
  double turn() const { return cross(along, out).z > 0 ? 1 : -1; }
  Quaternion turned(double position_rad) const;
  // A point of the leaf that is there when it is closed, and how high over the floor.
  Vec3 point_at(double position_rad, double along_m, double out_m, double height_m) const;
  motion::Obstacles leaf_at(double position_rad) const;
  // What the leaf and its bar stand on, seen from above: corners of a rectangle that may be turned.
  std::array<Vec3, 4> outline_at(double position_rad) const;
};

}  // namespace marketgen::skills
