// A mesh as meshoptimizer wants it for simplification, and back.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace marketgen::assets {

using WedgeIndices = std::vector<unsigned int>;  // three a triangle

// Vertices that differ only in their normal are one wedge: creases would hold their edges fast.
// Vertices on the border of two surfaces are two, so that the border holds.
struct MeshWedges {
  std::vector<Vec3f> positions;
  std::vector<Vec2f> uvs;
  std::vector<std::uint16_t> surfaces;
  std::vector<std::uint32_t> places;  // the same number where wedges lie on one another
  WedgeIndices indices;
};

MeshWedges wedges_of(const Mesh& mesh);

// Of these triangles, without normals. Where sheets of a coarse mesh touch along edges they are set
// apart by a few micrometres, so that it stays watertight.
Mesh mesh_of(const MeshWedges& wedges, const WedgeIndices& indices);

// Leaves out triangles that lie back to back: what is left of a thin part that collapsed.
WedgeIndices without_folds(const MeshWedges& wedges, const WedgeIndices& indices);

// Every edge is walked as often one way as the other: closed, though sheets may touch.
bool is_closed(const MeshWedges& wedges, const WedgeIndices& indices);

// The bodies of a mesh: its parts that hang together.
class WedgeBodies {
 public:
  explicit WedgeBodies(const MeshWedges& wedges);
  // One list of triangles for each body, in one order for every selection.
  std::vector<WedgeIndices> split(const WedgeIndices& indices) const;

 private:
  const MeshWedges& wedges_;
  std::vector<std::size_t> body_of_place_;
  std::size_t count_ = 0;
};

double volume_of(const MeshWedges& wedges, const WedgeIndices& indices);
Bounds3 bounds_of(const MeshWedges& wedges, const WedgeIndices& indices);

}  // namespace marketgen::assets
