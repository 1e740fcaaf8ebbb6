// Convex hulls of small point sets: contact shapes, packing. Qhull finds the same triangles in 3 to
// 22 times the time up to 200 points (docs/architecture.md, "Why our own").
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/vector.h"

namespace marketgen {
inline namespace geometry {

struct ConvexHull {
  // Counter-clockwise seen from outside; indices into the points given. Coplanar faces stay cut
  // into triangles.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  double volume = 0;  // cubic metres
};

// Empty for fewer than four points or points in one plane (thinner than a millionth of their
// extent). Faces are exact to a millionth of the extent: points are moved by less than that so that
// no four lie in one plane. O(n * faces): meant for hundreds of points.
ConvexHull convex_hull(const std::vector<Vec3f>& points);

// At most so many of the points, rising indices: those whose hull stays nearest to the hull of all.
// Empty where convex_hull is. O(n * most^2).
std::vector<std::uint32_t> hull_points(const std::vector<Vec3f>& points, std::size_t most);

}  // namespace geometry
}  // namespace marketgen
