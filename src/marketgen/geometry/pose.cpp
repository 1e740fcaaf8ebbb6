#include "geometry/pose.h"

#include <cmath>

namespace marketgen {
inline namespace geometry {

Quaternion rotation_from_half_tangent(Vec3 axis, double t) {
  const double w = 1.0 / std::sqrt(1.0 + t * t);
  const double s = t * w;
  return {w, axis.x * s, axis.y * s, axis.z * s};
}

Quaternion rotation_about(Vec3 axis, double angle_rad) {
  const double s = std::sin(angle_rad / 2);
  return {std::cos(angle_rad / 2), axis.x * s, axis.y * s, axis.z * s};
}

Quaternion yaw_from_quarter_turns(int quarter_turns) {
  const double half = std::sqrt(0.5);
  switch (((quarter_turns % 4) + 4) % 4) {
    case 1:
      return {half, 0, 0, half};
    case 2:
      return {0, 0, 0, 1};
    case 3:
      return {half, 0, 0, -half};
    default:
      return {1, 0, 0, 0};
  }
}

Vec3 rotate(const Quaternion& q, Vec3 v) {
  const Vec3 u{q.x, q.y, q.z};
  const Vec3 t = cross(u, v) * 2.0;
  return v + t * q.w + cross(u, t);
}

Quaternion inverse(const Quaternion& q) {
  return {q.w, -q.x, -q.y, -q.z};
}

Vec3 ellipsoid_half_extents(const Quaternion& q, Vec3 half_axes) {
  const Vec3 x = rotate(q, {half_axes.x, 0, 0}), y = rotate(q, {0, half_axes.y, 0}),
             z = rotate(q, {0, 0, half_axes.z});
  return {std::sqrt(x.x * x.x + y.x * y.x + z.x * z.x),
          std::sqrt(x.y * x.y + y.y * y.y + z.y * z.y),
          std::sqrt(x.z * x.z + y.z * y.z + z.z * z.z)};
}

double yaw_of(const Quaternion& q) {
  return std::atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
}

Pose inverse(const Pose& pose) {
  const Quaternion back = inverse(pose.rotation);
  return {rotate(back, -pose.position), back};
}

Matrix34 matrix_of(const Pose& pose) {
  Matrix34 result{};
  const Vec3 columns[3] = {rotate(pose.rotation, {1, 0, 0}),
                           rotate(pose.rotation, {0, 1, 0}),
                           rotate(pose.rotation, {0, 0, 1})};
  for (int c = 0; c < 3; ++c) {
    result.m[0][c] = columns[c].x;
    result.m[1][c] = columns[c].y;
    result.m[2][c] = columns[c].z;
  }
  result.m[0][3] = pose.position.x;
  result.m[1][3] = pose.position.y;
  result.m[2][3] = pose.position.z;
  return result;
}

}  // namespace geometry
}  // namespace marketgen
