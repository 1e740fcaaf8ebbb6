// Boxes of turned primitives against formulas.
#include "audit/item_bounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace marketgen {
namespace {

Pose turned(double yaw_deg, Vec3 at = {}) {
  return {at, rotation_about({0, 0, 1}, yaw_deg * std::numbers::pi / 180)};
}

Vec3 extent(const Bounds3& b) {
  return {(b.high.x - b.low.x) / 2.0, (b.high.y - b.low.y) / 2.0, (b.high.z - b.low.z) / 2.0};
}

TEST(ItemBounds, TurnedBox) {  // half sizes 2 and 1 at 30 degrees: 2 cos + 1 sin, 2 sin + 1 cos
  const assets::CollisionPrimitive box{
      assets::CollisionShape::box, {0, 0, 0.5F}, {2, 1, 0.5F}, false};
  const Vec3 e = extent(audit::bounds_of(box, turned(30)));
  EXPECT_NEAR(e.x, 2 * std::sqrt(3.0) / 2 + 0.5, 1e-6);
  EXPECT_NEAR(e.y, 1 + std::sqrt(3.0) / 2, 1e-6);
  EXPECT_NEAR(e.z, 0.5, 1e-6);
}

TEST(ItemBounds, UprightCylinderIsRound) {
  const assets::CollisionPrimitive cylinder{
      assets::CollisionShape::cylinder, {0, 0, 1}, {0.5F, 0.5F, 1}, false};
  for (const double yaw : {0.0, 17.0, 45.0, 90.0}) {
    const Vec3 e = extent(audit::bounds_of(cylinder, turned(yaw)));
    EXPECT_NEAR(e.x, 0.5, 1e-6);
    EXPECT_NEAR(e.y, 0.5, 1e-6);
    EXPECT_NEAR(e.z, 1, 1e-6);
  }
}

TEST(ItemBounds, LyingCylinderAtSixtyDegrees) {  // half length 2, radius 0.5, axis X: 2 cos + 0.5
                                                 // sin, 2 sin + 0.5 cos
  const assets::CollisionPrimitive cylinder{
      assets::CollisionShape::cylinder, {0, 0, 0.5F}, {0.5F, 0.5F, 2}, true};
  const Vec3 e = extent(audit::bounds_of(cylinder, turned(60)));
  EXPECT_NEAR(e.x, 1 + 0.5 * std::sqrt(3.0) / 2, 1e-6);
  EXPECT_NEAR(e.y, std::sqrt(3.0) + 0.25, 1e-6);
  EXPECT_NEAR(e.z, 0.5, 1e-6);
}

TEST(ItemBounds, EllipsoidAtFortyFiveDegrees) {  // sqrt((a^2 + b^2) / 2)
  const assets::CollisionPrimitive ellipsoid{
      assets::CollisionShape::ellipsoid, {0, 0, 1}, {3, 1, 1}, false};
  const Vec3 e = extent(audit::bounds_of(ellipsoid, turned(45)));
  EXPECT_NEAR(e.x, std::sqrt(5.0), 1e-6);
  EXPECT_NEAR(e.y, std::sqrt(5.0), 1e-6);
}

TEST(ItemBounds, CentreTurnsAlong) {
  const assets::CollisionPrimitive box{
      assets::CollisionShape::box, {1, 0, 0.5F}, {0.1F, 0.1F, 0.5F}, false};
  const Bounds3 b = audit::bounds_of(box, turned(90, {10, 20, 30}));
  EXPECT_NEAR((b.low.x + b.high.x) / 2, 10, 1e-5);
  EXPECT_NEAR((b.low.y + b.high.y) / 2, 21, 1e-5);
  EXPECT_NEAR(b.low.z, 30, 1e-5);
}

}  // namespace
}  // namespace marketgen
