// The room that a product takes where it stands upright, whichever way its front looks.
#pragma once
#include "catalog/product.h"
#include "geometry/mesh.h"
#include "geometry/pose.h"

namespace marketgen::catalog {

struct StandingBox {
  Vec3 low, high;
};

// `position` is the middle of its bottom; the box is along the axes of the frame that position and
// rotation are given in. A product's footprint that is turned takes the box around it.
StandingBox standing_box(const Product& product, const Vec3& position, const Quaternion& rotation);

inline Bounds3 bounds_of(const StandingBox& box) {
  return {to_float(box.low), to_float(box.high)};
}

}  // namespace marketgen::catalog
