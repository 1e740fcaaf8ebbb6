// The convex hull of any number of points, as a closed mesh of a few hundred.
#pragma once
#include <vector>

#include "geometry/mesh.h"

namespace marketgen::assets {

// Of the points that lie outermost in 400 directions: a ball loses 1 % of its volume, a box
// nothing. Empty when the points lie in one plane. O(400 n). Deterministic.
Mesh outer_hull(const std::vector<Vec3f>& points);

}  // namespace marketgen::assets
