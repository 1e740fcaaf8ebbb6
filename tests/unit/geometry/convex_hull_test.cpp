#include "geometry/convex_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/circle.h"
#include "geometry/mesh.h"

namespace marketgen {
namespace {

std::vector<Vec3f> prism(int sides, float radius, float height) {
  std::vector<Vec3f> points;
  for (int i = 0; i < sides; ++i) {
    const Vec2 p = unit_circle(static_cast<double>(i) / sides);
    for (const float z : {0.0F, height})
      points.push_back({radius * static_cast<float>(p.x), radius * static_cast<float>(p.y), z});
  }
  return points;
}

double prism_volume(int sides, double radius, double height) {
  return height * 0.5 * sides * radius * radius * std::sin(2 * std::numbers::pi / sides);
}

TEST(ConvexHull, BoxOfEightCornersWhateverLiesInside) {
  std::vector<Vec3f> points;
  for (const float x : {0.0F, 0.2F, 0.1F}) {
    for (const float y : {0.0F, 0.1F, 0.3F}) {
      for (const float z : {0.0F, 0.02F, 0.05F})
        points.push_back({x, y, z});
    }
  }
  const ConvexHull hull = convex_hull(points);
  EXPECT_NEAR(hull.volume, 0.2 * 0.3 * 0.05, 1e-8);
  const std::vector<std::uint32_t> corners = hull_points(points, 8);
  ASSERT_EQ(corners.size(), 8U);
  for (const std::uint32_t i : corners) {
    EXPECT_TRUE(points[i].x == 0.0F || points[i].x == 0.2F);
    EXPECT_TRUE(points[i].y == 0.0F || points[i].y == 0.3F);
    EXPECT_TRUE(points[i].z == 0.0F || points[i].z == 0.05F);
  }
}

TEST(ConvexHull, PrismsWithManyPointsInOnePlane) {
  for (const int sides : {3, 4, 12, 48, 160}) {
    EXPECT_NEAR(convex_hull(prism(sides, 0.04F, 0.1F)).volume,
                prism_volume(sides, 0.04, 0.1),
                1e-6 * 0.0005)
        << sides;
  }
}

TEST(ConvexHull, IsClosedWithEveryPointInside) {
  std::vector<Vec3f> points;
  for (int i = 0; i < 200; ++i) {  // a bumpy ball
    const double turn = 0.618034 * i, height = 2.0 * (i + 0.5) / 200 - 1;
    const Vec2 p = unit_circle(turn);
    const double r = std::sqrt(1 - height * height) * (i % 7 == 0 ? 0.7 : 1.0);
    points.push_back(to_float({r * p.x, r * p.y, height}));
  }
  const ConvexHull hull = convex_hull(points);
  Mesh mesh;
  for (const Vec3f p : points)
    mesh.add_vertex(p, {}, {});
  for (const auto& t : hull.triangles) {
    mesh.add_triangle(t[0], t[1], t[2], 0);
    const Vec3 a = to_double(points[t[0]]);
    const Vec3 n = normalized(cross(to_double(points[t[1]]) - a, to_double(points[t[2]]) - a));
    for (const Vec3f p : points)
      EXPECT_LT(dot(to_double(p) - a, n), 1e-5);
  }
  EXPECT_TRUE(is_watertight(mesh));
  EXPECT_NEAR(volume_of(mesh), hull.volume, 1e-5);
}

TEST(ConvexHull, FewPointsStayNearTheHullOfAll) {
  const std::vector<Vec3f> all = prism(200, 0.04F, 0.1F);
  const std::vector<std::uint32_t> chosen = hull_points(all, 64);
  EXPECT_LE(chosen.size(), 64U);
  EXPECT_TRUE(std::is_sorted(chosen.begin(), chosen.end()));
  std::vector<Vec3f> few;
  for (const std::uint32_t i : chosen)
    few.push_back(all[i]);
  // A prism of 32 sides has 0.6 % less volume than its cylinder.
  EXPECT_GT(convex_hull(few).volume, 0.985 * convex_hull(all).volume);
}

TEST(ConvexHull, FlatAndSmallSetsHaveNone) {
  EXPECT_TRUE(convex_hull({}).triangles.empty());
  EXPECT_TRUE(convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).triangles.empty());
  EXPECT_TRUE(
      convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}).triangles.empty());
  EXPECT_TRUE(hull_points({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, 8).empty());
}

}  // namespace
}  // namespace marketgen
