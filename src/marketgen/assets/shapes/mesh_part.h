// A part of a closed mesh between planes across the axes, and the convex hull around it: the
// material from which contact_pieces chooses.
#pragma once
#include <array>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/solid.h"

namespace marketgen::assets {

// A triangle, or a line on a cut face, cut by up to six planes.
struct ConvexPolygon {
  std::array<Vec3f, 9> points;
  int count = 0;
};

enum class CutAxis { x, y, z };

// Where a part lies. Along X and Y cuts run between columns of the solid, so that volumes are
// exact.
struct PartBox {
  Solid::Range x, y;
  float low_z, high_z;
};

struct MeshPart {
  PartBox box;
  std::vector<ConvexPolygon> skin = {};  // what of the mesh lies in the box, and its cut faces
  Bounds3 bounds = {};                   // of the skin
  double volume = 0;                     // of the solid in the box
  std::vector<Vec3f> hull_points = {};   // the farthest in several hundred directions
  double hull_volume = 0;
  double sampling = 1;  // the hull's volume over that of the hull of few directions
};

// What a hull has too much.
double excess(double hull_volume, double volume);

// A cut, and the excess of the two sides.
struct PartCut {
  CutAxis axis = CutAxis::z;
  int column = 0;    // X and Y: the first column of the far side
  float height = 0;  // Z
  double excess = 1e30;
};

MeshPart whole_part(const Mesh& mesh, const Solid& solid);

// The near and the far side.
std::array<MeshPart, 2> split(const MeshPart& part, const Solid& solid, const PartCut& cut);

// What of a part lies below a height.
struct PartFoot {
  float height = 0;
  double volume = 0;
  std::vector<Vec3f> hull_points = {};
  Bounds3 bounds = {};
};
// At equal steps up the part, rising.
std::vector<PartFoot> feet_of(const MeshPart& part, const Solid& solid);

// The cut that leaves the least excess; 1e30 when the part cannot be cut.
PartCut best_cut(const MeshPart& part, const Solid& solid);

}  // namespace marketgen::assets
