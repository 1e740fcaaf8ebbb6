#include "robots/rotation.h"

#include <cmath>

namespace marketgen::robots {

Quaternion rotation_from_rpy(Vec3 rpy) {
  return rotation_about({0, 0, 1}, rpy.z) * rotation_about({0, 1, 0}, rpy.y) *
         rotation_about({1, 0, 0}, rpy.x);
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
