#include "physics/contact_shape.h"

#include <cmath>

namespace marketgen {
namespace {

Vec3 size_of(CollisionShape shape, Vec3f half_size) {
  const Vec3 half = to_double(half_size);
  return shape == CollisionShape::cylinder ? Vec3{half.x, half.z, 0} : half;
}

}  // namespace

ContactShape contact_shape_of(const ScenePart& part) {
  const CollisionShape shape =
      part.shape == PartShape::box ? CollisionShape::box : CollisionShape::cylinder;
  const auto& [x, y, z] = part.half_size_m;
  return {shape, fixture_from_part(part), size_of(shape, {x, y, z})};
}

ContactShape contact_shape_of(const CollisionPrimitive& primitive) {
  ContactShape made{primitive.shape,
                    {to_double(primitive.center), {}},
                    size_of(primitive.shape, primitive.half_size)};
  if (primitive.lying) made.pose.rotation = rotation_from_half_tangent({0, 1, 0}, 1.0);  // Z onto X
  return made;
}

ContactShape operator*(const Pose& pose, const ContactShape& shape) {
  return {shape.shape, pose * shape.pose, shape.size};
}

Vec3 half_extents(const ContactShape& shape) {
  const Vec3 x = rotate(shape.pose.rotation, {1, 0, 0}), y = rotate(shape.pose.rotation, {0, 1, 0});
  const Vec3 z = rotate(shape.pose.rotation, {0, 0, 1});
  const Vec3& s = shape.size;
  const auto along = [&](double ax, double ay, double az) {
    switch (shape.shape) {
      case CollisionShape::box:
        return std::abs(ax) * s.x + std::abs(ay) * s.y + std::abs(az) * s.z;
      case CollisionShape::cylinder:
        return std::sqrt(ax * ax + ay * ay) * s.x + std::abs(az) * s.y;
      default:
        return std::sqrt(ax * ax * s.x * s.x + ay * ay * s.y * s.y + az * az * s.z * s.z);
    }
  };
  return {along(x.x, y.x, z.x), along(x.y, y.y, z.y), along(x.z, y.z, z.z)};
}

}  // namespace marketgen
