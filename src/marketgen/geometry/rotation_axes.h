// Rotations given by the axes they make, and how far apart rotations are.
#pragma once
#include "geometry/pose.h"

namespace marketgen {
inline namespace geometry {

// The rotation whose axes are `y` and `z` (unit, at right angles) and y x z: it turns (0, 1, 0)
// into `y` and (0, 0, 1) into `z`.
Quaternion rotation_with_axes(Vec3 y, Vec3 z);
// The least turn from one to the other, 0..pi. Of unit quaternions; one and its negative are alike.
double turn_between(const Quaternion& a, const Quaternion& b);

}  // namespace geometry
}  // namespace marketgen
