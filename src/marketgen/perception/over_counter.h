// How something moves over a counter: aside, and about the vertical.
#pragma once
#include "geometry/pose.h"

namespace marketgen::perception {

struct OverCounter {
  double x_m = 0, y_m = 0, turn_rad = 0;
  // base_from_base, turning about the pivot.
  Pose about(Vec3 pivot) const {
    const Quaternion turn = rotation_about({0, 0, 1}, turn_rad);
    return {pivot - rotate(turn, pivot) + Vec3{x_m, y_m, 0}, turn};
  }
  OverCounter operator+(const OverCounter& other) const {
    return {x_m + other.x_m, y_m + other.y_m, turn_rad + other.turn_rad};
  }
  OverCounter operator*(double share) const { return {x_m * share, y_m * share, turn_rad * share}; }
};

}  // namespace marketgen::perception
