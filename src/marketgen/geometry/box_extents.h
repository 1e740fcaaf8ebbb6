// How far a turned box reaches along the axes.
#pragma once
#include "geometry/pose.h"

namespace marketgen {
inline namespace geometry {

// Of the axis-aligned box around a box with these half extents along its own axes, turned by `q`.
Vec3 box_half_extents(const Quaternion& q, Vec3 half);

}  // namespace geometry
}  // namespace marketgen
