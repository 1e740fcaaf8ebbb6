#include "geometry/solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace marketgen {
namespace {

Mesh box(Vec3f low, Vec3f high) {
  Mesh mesh;
  add_box(mesh, low, high, 0, 0);
  return mesh;
}

Mesh cylinder(float radius, float height) {
  Mesh mesh;
  add_lathe(mesh, {{0, 0, 0}, {radius, 0, 0}, {radius, height, 0}, {0, height, 0}}, 96);
  return mesh;
}

TEST(Solid, CubeHasItsVolumeCentreAndInertia) {
  const MassProperties p = Solid(box({0.1F, 0.2F, 0.3F}, {0.3F, 0.4F, 0.5F}), 50).mass_properties();
  EXPECT_NEAR(p.volume, 0.008, 1e-8);
  EXPECT_NEAR(p.centroid.x, 0.2, 1e-6);
  EXPECT_NEAR(p.centroid.y, 0.3, 1e-6);
  EXPECT_NEAR(p.centroid.z, 0.4, 1e-6);
  const double moment = 0.008 * 0.2 * 0.2 / 6;  // m a^2 / 6
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(p.inertia[i], moment, 1e-5 * moment);
  for (std::size_t i = 3; i < 6; ++i)
    EXPECT_NEAR(p.inertia[i], 0, 1e-5 * moment);
}

TEST(Solid, CylinderHasItsVolumeAndInertia) {
  const double r = 0.033, h = 0.115;
  const MassProperties p = Solid(cylinder(0.033F, 0.115F), 96).mass_properties();
  const double volume = std::numbers::pi * r * r * h;
  EXPECT_NEAR(p.volume, volume, 0.005 * volume);
  EXPECT_NEAR(p.centroid.z, h / 2, 1e-5);
  const double across = volume * (3 * r * r + h * h) / 12, along = volume * r * r / 2;
  EXPECT_NEAR(p.inertia[0], across, 0.01 * across);
  EXPECT_NEAR(p.inertia[1], across, 0.01 * across);
  EXPECT_NEAR(p.inertia[2], along, 0.01 * along);
}

TEST(Solid, ProductOfInertiaOfAnOffsetPair) {  // two cubes at opposite corners: mass along x = y
  Mesh mesh = box({0, 0, 0}, {0.1F, 0.1F, 0.1F});
  mesh.append(box({0.1F, 0.1F, 0}, {0.2F, 0.2F, 0.1F}));
  const MassProperties p = Solid(mesh, 40).mass_properties();
  EXPECT_NEAR(p.volume, 0.002, 1e-8);
  EXPECT_NEAR(p.inertia[3], -0.002 * 0.05 * 0.05, 1e-9);  // -sum m x y about the centre
}

TEST(Solid, PartsThatOverlapCountOnce) {
  Mesh mesh = box({0, 0, 0}, {0.1F, 0.1F, 0.1F});
  mesh.append(box({0.05F, 0, 0}, {0.15F, 0.1F, 0.1F}));
  EXPECT_NEAR(volume_of(mesh), 0.002, 1e-8);
  EXPECT_NEAR(Solid(mesh, 60).volume(), 0.0015, 1e-6);
}

TEST(Solid, FillsUpToAHeight) {
  const Solid solid(cylinder(0.04F, 0.2F), 60);
  EXPECT_NEAR(solid.fill_height(0.92), 0.184, 1e-4);
  EXPECT_NEAR(solid.mass_properties(0.1F).centroid.z, 0.05, 1e-4);
  EXPECT_NEAR(solid.mass_properties(0.1F).volume, solid.volume() / 2, 1e-6);
}

TEST(Solid, AHoleIsLeftOut) {  // a square ring, its middle turned inside out
  Mesh mesh = box({0, 0, 0}, {0.3F, 0.3F, 0.1F});
  Mesh hole = box({0.1F, 0.1F, 0.02F}, {0.2F, 0.2F, 0.08F});
  for (auto& t : hole.triangles)
    std::swap(t[1], t[2]);
  mesh.append(hole);
  EXPECT_NEAR(Solid(mesh, 60).volume(), 0.3 * 0.3 * 0.1 - 0.1 * 0.1 * 0.06, 1e-6);
  EXPECT_EQ(Solid(mesh, 60).spans(30, 30).size(), 2U);
}

}  // namespace
}  // namespace marketgen
