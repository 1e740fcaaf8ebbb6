#include "geometry/box_extents.h"

#include <cmath>

namespace marketgen {
inline namespace geometry {

Vec3 box_half_extents(const Quaternion& q, Vec3 half) {
  const Quaternion back = inverse(q);
  const auto along = [&](Vec3 axis) {
    const Vec3 d = rotate(back, axis);
    return std::abs(d.x) * half.x + std::abs(d.y) * half.y + std::abs(d.z) * half.z;
  };
  return {along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})};
}

}  // namespace geometry
}  // namespace marketgen
