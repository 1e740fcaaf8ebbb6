#include "assets/shapes/outer_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/convex_hull.h"

namespace marketgen::assets {
namespace {

constexpr int rings = 20, around = 20;  // directions, over the sphere's two angles

Vec3f direction(int ring, int turn) {
  constexpr double pi = 3.14159265358979323846;
  // Half a step off the axes: a box's corners are outermost in one direction each, its faces in
  // none.
  const double tilt = pi * (ring + 0.5) / rings, heading = 2 * pi * (turn + 0.5) / around;
  return to_float(
      Vec3{std::sin(tilt) * std::cos(heading), std::sin(tilt) * std::sin(heading), std::cos(tilt)});
}

std::uint32_t outermost(const std::vector<Vec3f>& points, Vec3f d) {
  std::uint32_t best = 0;
  float reach = -std::numeric_limits<float>::infinity();
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const float along = dot(points[i], d);
    if (along > reach) {
      reach = along;
      best = i;
    }
  }
  return best;
}

}  // namespace

Mesh outer_hull(const std::vector<Vec3f>& points) {
  std::vector<std::uint32_t> chosen;
  for (int ring = 0; ring < rings && !points.empty(); ++ring) {
    for (int turn = 0; turn < around; ++turn)
      chosen.push_back(outermost(points, direction(ring, turn)));
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  std::vector<Vec3f> outer;
  for (const std::uint32_t i : chosen)
    outer.push_back(points[i]);
  Mesh mesh;
  for (const auto& [a, b, c] : convex_hull(outer).triangles) {
    if (mesh.positions.empty()) {
      for (const Vec3f& p : outer)
        mesh.add_vertex(p, {0, 0, 1}, {});
    }
    mesh.add_triangle(a, b, c, 0);
  }
  return mesh;
}

}  // namespace marketgen::assets
