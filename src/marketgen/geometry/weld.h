// Finding the vertices of a mesh that lie on one another although their normals or UVs differ.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/vector.h"

namespace marketgen {
inline namespace geometry {

// For each position the lowest index of a position at most `distance` away from it (per axis),
// itself included. Chains of near positions are not followed. O(n). Precondition: distance > 0.
std::vector<std::uint32_t> weld_positions(const std::vector<Vec3f>& positions, double distance);

}  // namespace geometry
}  // namespace marketgen
