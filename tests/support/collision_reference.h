// Collision questions in plain double precision, one sphere against every obstacle without any
// structure to hurry it: what tests hold the kernels against.
#pragma once
#include <algorithm>
#include <cmath>

#include "geometry/convex_hull.h"
#include "motion/collision_world.h"

namespace marketgen {
inline double beyond(double coordinate, double half) {
  return std::max(std::abs(coordinate) - half, 0.0);
}

inline double distance_from(const motion::BoxObstacle& box, Vec3 point) {
  const Vec3 p = inverse(box.pose) * point;
  return length(Vec3{
      beyond(p.x, box.half_size.x), beyond(p.y, box.half_size.y), beyond(p.z, box.half_size.z)});
}

inline double distance_from(const motion::CylinderObstacle& cylinder, Vec3 point) {
  const Vec3 p = inverse(cylinder.pose) * point;
  const double across = std::max(std::hypot(p.x, p.y) - cylinder.radius, 0.0);
  return std::hypot(across, beyond(p.z, cylinder.half_length));
}

// Not above the true distance: the farthest that the point lies beyond one face.
inline double distance_from(const motion::ConvexObstacle& convex, Vec3 point) {
  const Vec3 p = inverse(convex.pose) * point;
  double farthest = -1e30;
  for (const auto& t : convex_hull(convex.points).triangles) {
    const Vec3 a = to_double(convex.points[t[0]]), b = to_double(convex.points[t[1]]);
    const Vec3 n = normalized(cross(b - a, to_double(convex.points[t[2]]) - a));
    farthest = std::max(farthest, dot(n, p - a));
  }
  return farthest;
}

inline double distance_from(const motion::CloudObstacle& cloud, Vec3 point) {
  double nearest = 1e30;
  for (const Vec3f& p : cloud.points)
    nearest = std::min(nearest, length(to_double(p) - point));
  return nearest - cloud.radius;
}

// Precondition: CollisionWorld::make accepts the obstacles.
inline bool hits_reference(const motion::Obstacles& obstacles, Vec3 center, double radius) {
  const auto any = [&](const auto& list) {
    return std::any_of(
        list.begin(), list.end(), [&](const auto& o) { return distance_from(o, center) < radius; });
  };
  return any(obstacles.boxes) || any(obstacles.cylinders) || any(obstacles.convex) ||
         any(obstacles.clouds);
}

}  // namespace marketgen
