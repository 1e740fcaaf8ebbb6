// Rotations in the forms that robot descriptions use.
#pragma once
#include "geometry/pose.h"

namespace marketgen::robots {

// Roll about X, then pitch about Y, then yaw about Z, all about fixed axes (URDF); radians.
Quaternion rotation_from_rpy(Vec3 rpy);
// Its inverse; pitch from -pi/2 to pi/2, at both ends yaw 0. The quaternion need not be quite of
// length 1.
Vec3 rpy_from_rotation(const Quaternion& q);
// The shortest turn that takes Z to the unit vector `direction`.
Quaternion rotation_from_z_to(Vec3 direction);
// Axis times angle, 0..pi, of a unit quaternion.
Vec3 rotation_vector(const Quaternion& q);

}  // namespace marketgen::robots
