// Meshes: volumes and areas known from school, normals and UVs of every builder, watertightness
// both ways.
#include "geometry/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/circle.h"
#include "geometry/weld.h"

namespace marketgen {
namespace {

Mesh box(float bevel, float uv_per_metre = 0) {
  Mesh mesh;
  add_box(mesh, {-0.1F, -0.2F, 0.0F}, {0.1F, 0.2F, 0.3F}, bevel, 3, uv_per_metre);
  return mesh;
}

// A closed cylinder of radius 0.05 and height 0.2 with hard rims.
Mesh cylinder(int segments) {
  Mesh mesh;
  add_lathe(mesh, {{0, 0, 0}, {0.05F, 0, 1, true}, {0.05F, 0.2F, 2, true}, {0, 0.2F, 2}}, segments);
  return mesh;
}

Vec3 triangle_normal(const Mesh& mesh, std::size_t t) {
  const auto& v = mesh.triangles[t];
  const Vec3 a = to_double(mesh.positions[v[0]]);
  return normalized(
      cross(to_double(mesh.positions[v[1]]) - a, to_double(mesh.positions[v[2]]) - a));
}

void expect_sound(const Mesh& mesh) {
  ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
  ASSERT_EQ(mesh.positions.size(), mesh.uvs.size());
  ASSERT_EQ(mesh.triangles.size(), mesh.surfaces.size());
  for (const Vec3f n : mesh.normals)
    EXPECT_NEAR(length(n), 1.0F, 1e-5F);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) {
      EXPECT_GT(dot(to_double(mesh.normals[v]), triangle_normal(mesh, t)), 0.0) << "triangle " << t;
    }
  }
}

void expect_uvs_in_unit_square(const Mesh& mesh) {
  for (const Vec2f uv : mesh.uvs) {
    EXPECT_GE(std::min(uv.x, uv.y), -1e-6F);
    EXPECT_LE(std::max(uv.x, uv.y), 1.0F + 1e-6F);
  }
}

TEST(Circle, ExactAtQuarterTurnsAndCloseElsewhere) {
  EXPECT_EQ(unit_circle(0.25), (Vec2{0, 1}));
  EXPECT_EQ(unit_circle(0.5), (Vec2{-1, 0}));
  EXPECT_EQ(unit_circle(-0.25), (Vec2{0, -1}));
  for (int i = -40; i <= 40; ++i) {
    const double turns = i / 29.0;
    EXPECT_NEAR(unit_circle(turns).x, std::cos(turns * 2 * std::numbers::pi), 1e-14);
    EXPECT_NEAR(unit_circle(turns).y, std::sin(turns * 2 * std::numbers::pi), 1e-14);
  }
}

TEST(Mesh, SharpBoxHasTheVolumeAndBoundsOfABox) {
  const Mesh mesh = box(0);
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_NEAR(volume_of(mesh), 0.2 * 0.4 * 0.3, 1e-8);
  EXPECT_EQ(bounds_of(mesh).low, (Vec3f{-0.1F, -0.2F, 0.0F}));
  EXPECT_EQ(bounds_of(mesh).high, (Vec3f{0.1F, 0.2F, 0.3F}));
  EXPECT_TRUE(is_watertight(mesh));
  expect_sound(mesh);
  expect_uvs_in_unit_square(mesh);
}

TEST(Mesh, BevelCutsTheEdgesOffAndKeepsTheBounds) {
  const double bevel = 0.01;
  const Mesh mesh = box(static_cast<float>(bevel));
  // Each edge of length l loses a prism of area b^2/2 between its corners; each corner loses b^3 *
  // 5/6.
  const double edges = 4 * (0.2 + 0.4 + 0.3) - 24 * bevel;
  const double cut = edges * bevel * bevel / 2 + 8 * 5.0 / 6.0 * bevel * bevel * bevel;
  EXPECT_NEAR(volume_of(mesh), 0.2 * 0.4 * 0.3 - cut, 1e-8);
  EXPECT_NEAR(bounds_of(mesh).size().y, 0.4F, 1e-6F);
  EXPECT_EQ(mesh.triangles.size(), 44U);  // 6 faces, 12 edges, 8 corners
  EXPECT_TRUE(is_watertight(mesh));
  expect_sound(mesh);
  expect_uvs_in_unit_square(mesh);
}

TEST(Mesh, BevelNeverTurnsAThinBoardInsideOut) {
  Mesh mesh;
  add_box(mesh, {0, 0, 0}, {1, 0.5F, 0.002F}, 0.01F, 0);
  EXPECT_TRUE(is_watertight(mesh));
  EXPECT_GT(volume_of(mesh), 0.0);
  expect_sound(mesh);
}

TEST(Mesh, BoxFacesShowTheirPictureUprightAndUnmirrored) {
  const Mesh mesh = box(0);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3f p = mesh.positions[i];
    const Vec2f uv = mesh.uvs[i];
    if (mesh.normals[i].y < -0.5F) {  // front: u to the right (+X), v down
      EXPECT_EQ(uv, (Vec2f{p.x > 0 ? 1.0F : 0.0F, p.z > 0.1F ? 0.0F : 1.0F}));
    }
    if (mesh.normals[i].y > 0.5F) {  // back: seen from behind
      EXPECT_EQ(uv.x, p.x > 0 ? 0.0F : 1.0F);
    }
  }
}

TEST(Mesh, MetricUvsMeasureMetres) {
  const Mesh mesh = box(0, 2.0F);  // two repeats a metre
  float widest = 0;
  for (const Vec2f uv : mesh.uvs)
    widest = std::max({widest, uv.x, uv.y});
  EXPECT_NEAR(widest, 0.8F, 1e-6F);  // the longest edge, 0.4 m
}

TEST(Mesh, LatheCylinderHasThePrismVolumeOfItsPolygon) {
  for (const int segments : {8, 32, 40}) {
    const Mesh mesh = cylinder(segments);
    const double area = 0.5 * segments * 0.05 * 0.05 * std::sin(2 * std::numbers::pi / segments);
    EXPECT_NEAR(volume_of(mesh), area * 0.2, 1e-8);
    EXPECT_TRUE(is_watertight(mesh));
    expect_sound(mesh);
    expect_uvs_in_unit_square(mesh);
  }
  EXPECT_NEAR(volume_of(cylinder(64)), std::numbers::pi * 0.05 * 0.05 * 0.2, 0.002 * 0.00157);
}

TEST(Mesh, LatheCreasesAreHardAndTheRestIsSmooth) {
  for (const Mesh mesh = cylinder(32); const Vec3f n : mesh.normals) {
    EXPECT_TRUE(std::abs(n.z) < 1e-6F || std::abs(n.z) > 1.0F - 1e-6F) << n.z;
  }
  Mesh sphere;
  std::vector<ProfilePoint> arc;
  for (int i = 0; i <= 24; ++i) {
    const Vec2 p = unit_circle(-0.25 + i / 48.0);
    arc.push_back({i == 0 || i == 24 ? 0.0F : static_cast<float>(p.x), static_cast<float>(p.y), 0});
  }
  add_lathe(sphere, arc, 48);
  for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
    EXPECT_GT(dot(sphere.normals[i], normalized(sphere.positions[i])), 0.999F);
  }
  EXPECT_NEAR(volume_of(sphere), 4.0 / 3.0 * std::numbers::pi, 0.04);
}

TEST(Mesh, LatheSeamIsBehindAndTheFrontIsInTheMiddle) {
  const Mesh mesh = cylinder(32);
  bool front = false, left = false;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (std::abs(mesh.normals[i].z) > 0.5F) continue;
    if (mesh.uvs[i].x == 0.0F || mesh.uvs[i].x == 1.0F) {
      EXPECT_GT(mesh.positions[i].y, 0.0499F);
    }
    if (mesh.uvs[i].x == 0.5F) front = mesh.positions[i].y < -0.0499F;
    if (mesh.uvs[i].x == 0.25F) left = mesh.positions[i].x < -0.0499F;
  }
  EXPECT_TRUE(front && left);
}

TEST(Mesh, AHoleATurnedTriangleAndALooseQuadAreNotWatertight) {
  Mesh hole = box(0.01F);
  hole.triangles.pop_back();
  EXPECT_FALSE(is_watertight(hole));
  Mesh turned = box(0.01F);
  std::swap(turned.triangles[5][0], turned.triangles[5][1]);
  EXPECT_FALSE(is_watertight(turned));
  Mesh quad;
  add_quad(quad, {0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}, 0);
  EXPECT_FALSE(is_watertight(quad));
  EXPECT_EQ(quad.normals[0], (Vec3f{0, -1, 0}));
  EXPECT_FALSE(is_watertight(Mesh{}));
}

TEST(Mesh, AppendKeepsBothAndTranslateMoves) {
  Mesh two = box(0);
  Mesh other = cylinder(16);
  translate(other, {1, 0, 0});
  const double apart = volume_of(two) + volume_of(other);
  const std::size_t triangles = two.triangles.size() + other.triangles.size();
  two.append(other);
  EXPECT_EQ(two.triangles.size(), triangles);
  EXPECT_EQ(two.surfaces.size(), triangles);
  EXPECT_NEAR(volume_of(two), apart, 1e-8);
  EXPECT_NEAR(bounds_of(two).high.x, 1.05F, 1e-6F);
  EXPECT_TRUE(is_watertight(two));
}

TEST(Mesh, RecomputedNormalsKeepABoxHardAndMakeABarrelSmooth) {
  Mesh hard = box(0);
  for (Vec3f& n : hard.normals)
    n = {0, 0, 1};
  recompute_normals(hard);
  expect_sound(hard);
  for (const Vec3f n : hard.normals) {
    EXPECT_NEAR(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}), 1.0F, 1e-6F);
  }
  Mesh barrel = cylinder(32);
  recompute_normals(barrel);
  expect_sound(barrel);
  EXPECT_TRUE(is_watertight(barrel));
  for (std::size_t i = 0; i < barrel.positions.size(); ++i) {
    if (std::abs(barrel.normals[i].z) > 0.5F) continue;
    const Vec3f p = barrel.positions[i];
    EXPECT_GT(dot(barrel.normals[i], normalized(Vec3f{p.x, p.y, 0})), 0.999F);
  }
}

TEST(Weld, JoinsWithinTheDistanceOnlyAcrossCellBorders) {
  const std::vector<Vec3f> points{{0, 0, 0}, {9e-7F, 0, 0}, {-9e-7F, -9e-7F, 0}, {3e-6F, 0, 0}};
  EXPECT_EQ(weld_positions(points, 1e-6), (std::vector<std::uint32_t>{0, 0, 0, 3}));
}

}  // namespace
}  // namespace marketgen
