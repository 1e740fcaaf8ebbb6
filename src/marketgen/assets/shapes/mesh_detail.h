// The same pack with fewer triangles.
#pragma once
#include <cstddef>

#include "geometry/mesh.h"

namespace marketgen::assets {

// What may go for it.
struct DetailLimits {
  std::size_t triangles = 0;  // about so many are wanted
  // Shares of its volume that a body may lose: the pack's own (a cylinder loses 4.5 % to twelve
  // sides), and a small one beside it, a leaf or a string.
  double loss = 0.06, small_loss = 0.3;
};

// More triangles than wanted where the limits or the closed skin ask for them; the mesh itself when
// it has no more. Watertight if the mesh is, with its bounds, its surfaces, and the UVs of the
// vertices that are left. Deterministic; a few milliseconds for 3,000 triangles.
Mesh simplified(const Mesh& mesh, const DetailLimits& limits);

}  // namespace marketgen::assets
