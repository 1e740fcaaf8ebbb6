#include "geometry/rotation_axes.h"

#include <algorithm>
#include <cmath>

namespace marketgen {
inline namespace geometry {

Quaternion rotation_with_axes(Vec3 y, Vec3 z) {
  const Vec3 x = cross(y, z);
  // The largest of the four squares keeps the root away from 0 (Shepperd 1978).
  const double w4 = 1 + x.x + y.y + z.z, x4 = 1 + x.x - y.y - z.z;
  const double y4 = 1 - x.x + y.y - z.z, z4 = 1 - x.x - y.y + z.z;
  const double largest = std::max({w4, x4, y4, z4});
  const double s = 0.5 / std::sqrt(largest), first = largest * s;
  if (largest == w4) return {first, (y.z - z.y) * s, (z.x - x.z) * s, (x.y - y.x) * s};
  if (largest == x4) return {(y.z - z.y) * s, first, (x.y + y.x) * s, (z.x + x.z) * s};
  if (largest == y4) return {(z.x - x.z) * s, (x.y + y.x) * s, first, (y.z + z.y) * s};
  return {(x.y - y.x) * s, (z.x + x.z) * s, (y.z + z.y) * s, first};
}

double turn_between(const Quaternion& a, const Quaternion& b) {
  const double along = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
  return 2 * std::acos(std::min(1.0, std::abs(along)));
}

}  // namespace geometry
}  // namespace marketgen
