#include "assets/contact_shape.h"

#include <cmath>

#include "geometry/box_extents.h"

namespace marketgen::assets {
namespace {

Vec3 contact_size(CollisionShape shape, Vec3f half_size) {
  const Vec3 half = to_double(half_size);
  return shape == CollisionShape::cylinder ? Vec3{half.x, half.z, 0} : half;
}

}  // namespace

ContactShape contact_shape_of(const CollisionPrimitive& primitive) {
  ContactShape made{primitive.shape,
                    {to_double(primitive.center), {}},
                    contact_size(primitive.shape, primitive.half_size)};
  if (primitive.lying) made.pose.rotation = rotation_from_half_tangent({0, 1, 0}, 1.0);  // Z onto X
  return made;
}

ContactShape contact_shape_of(const ContactPiece& piece) {
  return contact_shape_of(CollisionPrimitive{
      static_cast<CollisionShape>(piece.shape), piece.center, piece.half_size, piece.lying});
}

ContactPiece piece_of(const CollisionPrimitive& primitive) {
  return {static_cast<PieceShape>(primitive.shape),
          primitive.center,
          primitive.half_size,
          primitive.lying};
}

ContactShape operator*(const Pose& pose, const ContactShape& shape) {
  return {shape.shape, pose * shape.pose, shape.size};
}

Vec3 half_extents(const ContactShape& shape) {
  const Quaternion& turned = shape.pose.rotation;
  const Vec3& s = shape.size;
  if (shape.shape == CollisionShape::ellipsoid) return ellipsoid_half_extents(turned, s);
  if (shape.shape == CollisionShape::box) return box_half_extents(turned, s);
  const Vec3 x = rotate(turned, {1, 0, 0}), y = rotate(turned, {0, 1, 0}),
             z = rotate(turned, {0, 0, 1});
  const auto along = [&](double ax, double ay, double az) {
    return std::sqrt(ax * ax + ay * ay) * s.x + std::abs(az) * s.y;
  };
  return {along(x.x, y.x, z.x), along(x.y, y.y, z.y), along(x.z, y.z, z.z)};
}

}  // namespace marketgen::assets
