// Closed meshes of surfaces that are written as fields: the points where a field is zero.
//
// Shapes that flow into one another (a shoulder into its arm, a nose into its face) are a sum of
// soft shapes (soft_shapes.h), which no loft can give without a seam.
#pragma once
#include <functional>

#include "geometry/mesh.h"

namespace marketgen::assets {

// About the distance to the surface in metres, negative inside. It must not overstate the distance
// more than twofold.
using Field = std::function<float(Vec3f)>;

// Marching cubes (Lorensen & Cline 1987) over cells of `cell_m`; faces with two crossings keep
// their inner corners apart, which every two cells that share one see alike, so that the mesh is
// watertight. Vertices are moved onto the surface afterwards and normals are the field's gradient:
// curves are smooth even where cells are coarse. UVs are 0 and every triangle shows surface 0.
// Precondition: the field is positive on the border of `bounds`. O(cells near the surface).
Mesh mesh_of_field(const Field& field, const Bounds3& bounds, float cell_m);

}  // namespace marketgen::assets
