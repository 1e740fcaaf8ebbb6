#include <gtest/gtest.h>

#include "geometry/pose.h"
#include "geometry/rectangle.h"

namespace marketgen {
namespace {

TEST(Pose, QuarterTurnsAreExactDirections) {
  for (int turns = -4; turns <= 4; ++turns) {
    const Vec3 v = rotate(yaw_from_quarter_turns(turns), {1, 0, 0});
    const int t = ((turns % 4) + 4) % 4;
    EXPECT_NEAR(v.x, t == 0 ? 1 : (t == 2 ? -1 : 0), 1e-15);
    EXPECT_NEAR(v.y, t == 1 ? 1 : (t == 3 ? -1 : 0), 1e-15);
  }
}

TEST(Pose, HalfTangentGivesTheAngle) {
  EXPECT_NEAR(yaw_of(rotation_from_half_tangent({0, 0, 1}, 0.1)),
              2 * 0.09966865249116204,
              1e-15);  // 2 atan(0.1)
}

TEST(Pose, InverseUndoes) {
  const Pose a{{1, 2, 3}, rotation_about({0, 0, 1}, 0.7)};
  const Vec3 p = (inverse(a) * a) * Vec3{4, 5, 6};
  EXPECT_NEAR(p.x, 4, 1e-12);
  EXPECT_NEAR(p.y, 5, 1e-12);
  EXPECT_NEAR(p.z, 6, 1e-12);
}

TEST(Pose, MatrixAgreesWithRotation) {
  const Pose a{{1, 2, 3}, rotation_about(normalized(Vec3{1, 1, 0}), 1.1)};
  const Matrix34 m = matrix_of(a);
  const Vec3 v{0.3, -0.2, 0.9}, w = a * v;
  EXPECT_NEAR(m.m[0][0] * v.x + m.m[0][1] * v.y + m.m[0][2] * v.z + m.m[0][3], w.x, 1e-12);
  EXPECT_NEAR(m.m[2][0] * v.x + m.m[2][1] * v.y + m.m[2][2] * v.z + m.m[2][3], w.z, 1e-12);
}

TEST(Rectangle, TouchingIsNotOverlap) {
  const RectMm a{0, 0, 10, 10};
  EXPECT_FALSE(overlap(a, {10, 0, 20, 10}));
  EXPECT_TRUE(overlap(a, {9, 9, 20, 20}));
  EXPECT_EQ(gap_mm(a, {15, 0, 20, 10}), 5);
  EXPECT_EQ(gap_mm(a, {5, 5, 20, 10}), -5);
}

TEST(Polygon, AreaAndInsideOfAnL) {
  const PolygonMm l{{0, 0}, {2000, 0}, {2000, 1000}, {1000, 1000}, {1000, 2000}, {0, 2000}};
  EXPECT_DOUBLE_EQ(area_m2(l), 3.0);
  EXPECT_TRUE(contains(l, {500, 1500}));
  EXPECT_FALSE(contains(l, {1500, 1500}));
  EXPECT_TRUE(contains(l, {1500, 1000}));  // on the border
}

}  // namespace
}  // namespace marketgen
