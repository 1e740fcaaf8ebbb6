// Convex pieces of any mesh by CoACD (Wei et al., SIGGRAPH 2022), which runs in Python beside us.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/mesh.h"

namespace marketgen::assets {

// At most 16 pieces of at most 64 points each, in the mesh's frame; to 0.01 mm. Takes seconds; is
// given up after 120 s (program.failed). The same mesh gives the same pieces. Errors:
// usage.unavailable, program.failed, input.too_large (more than 200,000 triangles).
Result<std::vector<std::vector<Vec3f>>> convex_pieces(const Mesh& mesh);

}  // namespace marketgen::assets
