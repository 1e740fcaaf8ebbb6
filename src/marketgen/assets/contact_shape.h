// The primitives of which packs and fixtures are made up where something touches them: one
// description for the simulation, for planners and for what is written to files.
#pragma once
#include "assets/product_model.h"
#include "geometry/pose.h"

namespace marketgen::assets {

struct ContactShape {
  CollisionShape shape = CollisionShape::box;
  Pose pose;  // owner_from_shape; a cylinder's axis is Z
  Vec3 size;  // as MuJoCo counts: half extents, or radius, half length and 0
};

ContactShape contact_shape_of(const CollisionPrimitive& primitive);   // in the product frame
ContactShape contact_shape_of(const ContactPiece& piece);             // the same; not of a hull
ContactShape operator*(const Pose& pose, const ContactShape& shape);  // moved along with its owner

ContactPiece piece_of(const CollisionPrimitive& primitive);  // the same solid

// Half extents of the axis-aligned box around the shape, in its owner's frame.
Vec3 half_extents(const ContactShape& shape);

}  // namespace marketgen::assets
