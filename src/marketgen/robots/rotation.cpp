#include "robots/rotation.h"

#include <cmath>

namespace marketgen::robots {

Quaternion rotation_from_rpy(Vec3 rpy) {
  return rotation_about({0, 0, 1}, rpy.z) * rotation_about({0, 1, 0}, rpy.y) *
         rotation_about({1, 0, 0}, rpy.x);
}

Vec3 rpy_from_rotation(const Quaternion& q) {
  constexpr double straight_up = 1e-9;  // cosine of the pitch: roll and yaw are one there
  const double norm = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  const Quaternion unit{q.w / norm, q.x / norm, q.y / norm, q.z / norm};
  const Vec3 x = rotate(unit, {1, 0, 0}), y = rotate(unit, {0, 1, 0}), z = rotate(unit, {0, 0, 1});
  const double level = std::hypot(x.x, x.y);
  const double pitch = std::atan2(-x.z, level);
  if (level < straight_up) return {std::atan2(-z.y, y.y), pitch, 0};
  return {std::atan2(y.z, z.z), pitch, std::atan2(x.y, x.x)};
}

Quaternion rotation_from_z_to(Vec3 direction) {
  const double w = 1 + direction.z;
  if (w < 1e-12) return {0, 1, 0, 0};  // half a turn about X
  const double norm = std::sqrt(w * w + direction.x * direction.x + direction.y * direction.y);
  return {w / norm, -direction.y / norm, direction.x / norm, 0};
}

Vec3 rotation_vector(const Quaternion& q) {
  const double sign = q.w < 0 ? -1 : 1;
  const Vec3 v = Vec3{q.x, q.y, q.z} * sign;
  const double s = length(v);
  if (s < 1e-12) return v * 2.0;
  return v * (2 * std::atan2(s, q.w * sign) / s);
}

}  // namespace marketgen::robots
