// Vectors and turns as the arrays of 32-bit numbers that the scene's rows hold.
#pragma once
#include <array>

#include "geometry/pose.h"

namespace marketgen::scene {

inline std::array<float, 3> as_array(Vec3 v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
inline std::array<float, 3> as_array(Vec3f v) {
  return {v.x, v.y, v.z};
}
// w, x, y, z
inline std::array<float, 4> as_array(const Quaternion& q) {
  return {static_cast<float>(q.w),
          static_cast<float>(q.x),
          static_cast<float>(q.y),
          static_cast<float>(q.z)};
}

}  // namespace marketgen::scene
