// Shapes as fields (implicit_mesh.h), and how they flow into one another: what bodies and their
// clothes are made of. Metres.
//
// Distances and soft unions after Inigo Quilez, "Distance functions" and "Smooth minimum"
// (iquilezles.org/articles).
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/vector.h"

namespace marketgen::assets {

// The lesser of two distances, rounded where they differ by less than `k`.
inline float soft_min(float a, float b, float k) {
  const float h = std::max(k - std::abs(a - b), 0.0F) / k;
  return std::min(a, b) - h * h * k * 0.25F;
}
inline float soft_max(float a, float b, float k) {
  return -soft_min(-a, -b, k);
}

// A limb's piece: a cone from `a` to `b` with round ends. Radii in metres.
float round_cone(Vec3f p, Vec3f a, Vec3f b, float radius_a, float radius_b);

// An axis-aligned ellipsoid; distances are near the surface's.
float ellipsoid(Vec3f p, Vec3f middle, Vec3f half);

// A box with rounded edges, turned about Z by `yaw_rad`.
float round_box(Vec3f p, Vec3f middle, Vec3f half, float edge, float yaw_rad = 0);

// A round bar along a ring in the plane z = middle.z.
float ring(Vec3f p, Vec3f middle, float radius, float bar);

// A trunk's girth at a height: an ellipse around (x, 0), a little squarer.
struct Girth {
  float z, x;            // of its middle
  float half_x, half_y;  // ahead, aside
};
// The trunk through rising girths, closed flat-round at both ends. Precondition: two or more.
float trunk(Vec3f p, const std::vector<Girth>& girths, float end_radius);

}  // namespace marketgen::assets
