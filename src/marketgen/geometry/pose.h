// Rigid poses, named target_from_source: world_from_shelf * shelf_from_item = world_from_item.
#pragma once
#include "geometry/vector.h"

namespace marketgen {
inline namespace geometry {

// Unit quaternion, w first.
struct Quaternion {
  double w = 1, x = 0, y = 0, z = 0;
  friend constexpr Quaternion operator*(const Quaternion& a, const Quaternion& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
            a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
  }
  friend constexpr bool operator==(const Quaternion&, const Quaternion&) = default;
};

// Rotation about a unit axis whose half-angle has the tangent `t`. Only + * / sqrt: the same bits
// on every machine.
Quaternion rotation_from_half_tangent(Vec3 axis, double t);
Quaternion rotation_about(Vec3 axis, double angle_rad);  // unit axis
// Exact for the four directions of fixtures: 0, 90, 180, 270 (any multiple of 90, negative too).
Quaternion yaw_from_quarter_turns(int quarter_turns);
Vec3 rotate(const Quaternion& q, Vec3 v);
Quaternion inverse(const Quaternion& q);
// Of the axis-aligned box around a turned ellipsoid with these half axes.
Vec3 ellipsoid_half_extents(const Quaternion& q, Vec3 half_axes);
double yaw_of(const Quaternion& q);  // radians about Z, -pi..pi

struct Pose {
  Vec3 position;  // metres
  Quaternion rotation;
  friend Pose operator*(const Pose& a, const Pose& b) {
    return {a.position + rotate(a.rotation, b.position), a.rotation * b.rotation};
  }
  friend Vec3 operator*(const Pose& a, Vec3 point) {
    return a.position + rotate(a.rotation, point);
  }
};

Pose inverse(const Pose& pose);

// Row-major 3x4 [R | t].
struct Matrix34 {
  double m[3][4];
};
Matrix34 matrix_of(const Pose& pose);

}  // namespace geometry
}  // namespace marketgen
