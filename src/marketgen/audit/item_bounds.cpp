#include "audit/item_bounds.h"

#include <cmath>

#include "base/parallel.h"

namespace marketgen::audit {
namespace {

// Half extents along the target's axes of a box or ellipsoid with half sizes `h` turned by `m`.
Vec3 box_extent(const Matrix34& m, Vec3 h) {
  const auto row = [&](int r) {
    return std::abs(m.m[r][0]) * h.x + std::abs(m.m[r][1]) * h.y + std::abs(m.m[r][2]) * h.z;
  };
  return {row(0), row(1), row(2)};
}

Vec3 ellipsoid_extent(const Matrix34& m, Vec3 h) {
  const auto row = [&](int r) {
    const double x = m.m[r][0] * h.x, y = m.m[r][1] * h.y, z = m.m[r][2] * h.z;
    return std::sqrt(x * x + y * y + z * z);
  };
  return {row(0), row(1), row(2)};
}

// A disc of radius r perpendicular to the axis reaches r * sqrt(1 - a^2) along a direction that has
// cosine a with the axis.
Vec3 cylinder_extent(const Matrix34& m, double radius, double half_length, int axis) {
  const auto row = [&](int r) {
    const double a = m.m[r][axis];
    return std::abs(a) * half_length + radius * std::sqrt(std::max(0.0, 1 - a * a));
  };
  return {row(0), row(1), row(2)};
}

}  // namespace

Bounds3 bounds_of(const assets::CollisionPrimitive& primitive, const Pose& target_from_item) {
  const Matrix34 m = matrix_of(target_from_item);
  const Vec3 h = to_double(primitive.half_size);
  Vec3 extent;
  switch (primitive.shape) {
    case assets::CollisionShape::box:
      extent = box_extent(m, h);
      break;
    case assets::CollisionShape::ellipsoid:
      extent = ellipsoid_extent(m, h);
      break;
    case assets::CollisionShape::cylinder:
      extent = cylinder_extent(m, h.x, h.z, primitive.lying ? 0 : 2);
      break;
  }
  const Vec3 center = target_from_item * to_double(primitive.center);
  return {to_float(center - extent), to_float(center + extent)};
}

Result<std::vector<Bounds3>> item_bounds(const scene::Scene& scene) {
  std::vector<assets::CollisionPrimitive> primitives;
  for (const catalog::Product& product : scene.catalog) {
    MARKETGEN_TRY(const assets::CollisionPrimitive primitive, assets::collision_of(product));
    primitives.push_back(primitive);
  }
  constexpr std::size_t grain = 512;
  return parallel_map(
      scene.products.size(),
      [&](std::size_t i) {
        const scene::SceneProduct& item = scene.products[i];
        return bounds_of(primitives[item.sku], scene::world_from_product(item));
      },
      grain);
}

}  // namespace marketgen::audit
