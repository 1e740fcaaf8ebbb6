// A closed mesh as a body: the space it fills, cut into upright columns. Parts that run into one
// another (a cap on its bottle, leaves on a stalk) count once.
#pragma once
#include <array>
#include <vector>

#include "geometry/mesh.h"

namespace marketgen {
inline namespace geometry {

// Of a body of density one.
struct MassProperties {
  double volume = 0;
  Vec3 centroid{};
  std::array<double, 6> inertia{};  // about the centroid: xx yy zz xy xz yz
};

class Solid {
 public:
  struct Span {
    float low, high;
  };
  // Columns `first` up to but not `last` along X and Y.
  struct Range {
    int first = 0, last = 0;
  };

  // `columns` along X and along Y over the mesh's bounds; each is as full as its middle line.
  // Precondition: the mesh is watertight. O(triangles + what they cover).
  Solid(const Mesh& mesh, int columns);

  int columns() const { return columns_; }
  // Where column `index` begins; `columns()` gives the far bound.
  float column_x(int index) const { return low_.x + static_cast<float>(index) * pitch_.x; }
  float column_y(int index) const { return low_.y + static_cast<float>(index) * pitch_.y; }
  const Bounds3& bounds() const { return bounds_; }
  double column_area() const { return static_cast<double>(pitch_.x) * pitch_.y; }

  // Rising, apart from one another.
  const std::vector<Span>& spans(int x, int y) const {
    return spans_[static_cast<std::size_t>(y * columns_ + x)];
  }

  double volume() const;
  // Of what lies below that height.
  MassProperties mass_properties(float below_z = 1e30F) const;
  // The height below which that share of the volume lies.
  float fill_height(double share) const;

 private:
  int columns_;
  Bounds3 bounds_;
  Vec3f low_, pitch_;
  std::vector<std::vector<Span>> spans_;  // x fastest
};

}  // namespace geometry
}  // namespace marketgen
