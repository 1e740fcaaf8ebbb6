// Oriented boxes and how deep they reach into one another, for tests of what may not overlap.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "assets/fixtures/fixture_model.h"
#include "geometry/pose.h"

namespace marketgen {

struct OrientedBox {
  Vec3 center;
  std::array<Vec3, 3> axes;  // unit
  Vec3 half;
};

inline OrientedBox oriented_box(const Pose& pose, Vec3 half) {
  return {pose.position,
          {rotate(pose.rotation, {1, 0, 0}),
           rotate(pose.rotation, {0, 1, 0}),
           rotate(pose.rotation, {0, 0, 1})},
          half};
}

// A cylinder counts as the box round it.
inline OrientedBox oriented_box(const assets::FixturePart& part) {
  return oriented_box(part.fixture_from_part, to_double(part.half_size));
}

inline std::vector<Vec3> corners(const OrientedBox& b) {
  std::vector<Vec3> result;
  for (const double x : {-b.half.x, b.half.x}) {
    for (const double y : {-b.half.y, b.half.y}) {
      for (const double z : {-b.half.z, b.half.z}) {
        result.push_back(b.center + b.axes[0] * x + b.axes[1] * y + b.axes[2] * z);
      }
    }
  }
  return result;
}

// Half the length of the box's shadow on a unit axis.
inline double reach_along(const OrientedBox& b, Vec3 axis) {
  return b.half.x * std::abs(dot(b.axes[0], axis)) + b.half.y * std::abs(dot(b.axes[1], axis)) +
         b.half.z * std::abs(dot(b.axes[2], axis));
}

// How far the boxes would have to move apart to touch only; negative when they are apart. By the
// separating-axis theorem (Gottschalk, Lin, Manocha 1996) over the 6 face normals and the 9
// products of edges.
inline double penetration(const OrientedBox& a, const OrientedBox& b) {
  const double far = length(b.center - a.center) - length(a.half) - length(b.half);
  if (far > 0) return -far;  // their balls are apart
  double least = std::numeric_limits<double>::infinity();
  const auto look_along = [&](Vec3 axis) {
    const double apart = std::abs(dot(b.center - a.center, axis));
    least = std::min(least, reach_along(a, axis) + reach_along(b, axis) - apart);
  };
  for (const Vec3& axis : a.axes)
    look_along(axis);
  for (const Vec3& axis : b.axes)
    look_along(axis);
  for (const Vec3& u : a.axes) {
    for (const Vec3& v : b.axes) {
      if (least < 0) return least;  // apart along one axis is apart
      const Vec3 product = cross(u, v);
      if (length(product) > 1e-6) look_along(normalized(product));
    }
  }
  return least;
}

inline bool contains(const OrientedBox& b, Vec3 point, double tolerance) {
  const Vec3 d = point - b.center;
  return std::abs(dot(d, b.axes[0])) <= b.half.x + tolerance &&
         std::abs(dot(d, b.axes[1])) <= b.half.y + tolerance &&
         std::abs(dot(d, b.axes[2])) <= b.half.z + tolerance;
}

// What a shelf promises to goods: its usable area up to its clearance.
inline OrientedBox free_volume(const assets::ShelfSurface& shelf) {
  const Pose to_middle{{0, shelf.depth_m / 2, shelf.clearance_m / 2}, {}};
  return oriented_box(shelf.fixture_from_shelf * to_middle,
                      Vec3{shelf.width_m, shelf.depth_m, shelf.clearance_m} * 0.5);
}

}  // namespace marketgen
