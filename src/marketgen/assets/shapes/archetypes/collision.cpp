#include "assets/shapes/archetypes/collision.h"

#include <algorithm>
#include <cstdlib>

namespace marketgen::assets {
namespace {

// A circle stands in for an ellipse whose axes differ by at most this share of the longer one.
constexpr int nearly_equal_percent = 4;

constexpr int grown_percent = 34;  // of cucumbers, carrots

bool nearly_equal(int a_mm, int b_mm, int percent = nearly_equal_percent) {
  return 100 * std::abs(a_mm - b_mm) <= percent * std::max(a_mm, b_mm);
}

CollisionPrimitive filling(const catalog::Product& product, CollisionShape shape) {
  const Vec3f half{static_cast<float>(product.width_m() / 2),
                   static_cast<float>(product.depth_m() / 2),
                   static_cast<float>(product.height_m() / 2)};
  return {shape, {0, 0, half.z}, half, false};
}

}  // namespace

CollisionPrimitive box_around(const catalog::Product& product) {
  return filling(product, CollisionShape::box);
}

CollisionPrimitive cylinder_around(const catalog::Product& product) {
  if (!nearly_equal(product.size_mm[0], product.size_mm[1])) return box_around(product);
  CollisionPrimitive p = filling(product, CollisionShape::cylinder);
  p.half_size.x = p.half_size.y = std::min(p.half_size.x, p.half_size.y);
  return p;
}

CollisionPrimitive lying_cylinder_around(const catalog::Product& product) {
  const bool round = nearly_equal(product.size_mm[1], product.size_mm[2]);
  return round ? grown_cylinder_around(product) : box_around(product);
}

CollisionPrimitive grown_cylinder_around(const catalog::Product& product) {
  if (!nearly_equal(product.size_mm[1], product.size_mm[2], grown_percent))
    return box_around(product);
  const CollisionPrimitive box = filling(product, CollisionShape::cylinder);
  const float radius = std::min(box.half_size.y, box.half_size.z);
  return {CollisionShape::cylinder, {0, 0, radius}, {radius, radius, box.half_size.x}, true};
}

CollisionPrimitive ellipsoid_around(const catalog::Product& product) {
  return filling(product, CollisionShape::ellipsoid);
}

}  // namespace marketgen::assets
