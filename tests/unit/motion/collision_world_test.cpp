#include "motion/collision_world.h"

#include <gtest/gtest.h>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/distance.h>

#include <cmath>
#include <limits>

#include "base/seed.h"
#include "support/collision_reference.h"

namespace marketgen {
namespace {

bool hits(const motion::CollisionWorld& world, Vec3 center, double radius) {
  const std::vector<motion::SphereBlock> blocks =
      motion::packed(std::vector<motion::PlainSphere>{{center, radius}});
  return world.hits(blocks, to_float(center), static_cast<float>(radius));
}

Pose random_pose(Stream& draw) {
  const Vec3 axis = normalized(Vec3{draw.normal(), draw.normal(), draw.normal()});
  return {{draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-1, 1)},
          rotation_about(axis, draw.uniform(-3, 3))};
}

motion::Obstacles random_obstacles(std::uint64_t seed) {
  Stream draw = Seed(seed).child("obstacles").stream();
  const auto size = [&] { return draw.uniform(0.02, 0.3); };
  motion::Obstacles all;
  for (int i = 0; i < 9; ++i) {
    all.boxes.push_back({random_pose(draw), {size(), size(), size()}});
    all.cylinders.push_back({random_pose(draw), size(), size()});
    motion::ConvexObstacle piece{random_pose(draw), {}};
    for (int k = 0; k < 12; ++k)
      piece.points.push_back(to_float({draw.normal() * 0.1, draw.normal() * 0.1, size()}));
    all.convex.push_back(piece);
  }
  motion::CloudObstacle cloud;
  const Vec3 at = random_pose(draw).position;
  for (int k = 0; k < 3000; ++k)
    cloud.points.push_back(to_float(at + Vec3{draw.normal(), draw.normal(), 0.1} * 0.3));
  all.clouds.push_back(cloud);
  return all;
}

TEST(CollisionWorld, ABoxIsTouchedExactlyAtItsFacesAndCorners) {
  motion::Obstacles obstacles;
  obstacles.boxes.push_back({{{1, 2, 3}, {}}, {0.1, 0.2, 0.3}});
  const auto world = motion::CollisionWorld::make(obstacles);
  ASSERT_TRUE(world.ok());
  EXPECT_TRUE(hits(*world, {1.149, 2, 3}, 0.05));
  EXPECT_FALSE(hits(*world, {1.151, 2, 3}, 0.05));
  const double off = 0.05 / std::sqrt(3.0);
  EXPECT_TRUE(hits(*world, {1.1 + 0.99 * off, 2.2 + 0.99 * off, 3.3 + 0.99 * off}, 0.05));
  EXPECT_FALSE(hits(*world, {1.1 + 1.01 * off, 2.2 + 1.01 * off, 3.3 + 1.01 * off}, 0.05));
}

TEST(CollisionWorld, NamesWhatIsHitAndSeesEveryLane) {
  motion::Obstacles obstacles;
  obstacles.boxes.push_back({{{5, 0, 0}, {}}, {0.1, 0.1, 0.1}});
  obstacles.cylinders.push_back({{{0, 5, 0}, {}}, 0.1, 0.1});
  const auto world = motion::CollisionWorld::make(obstacles);
  ASSERT_TRUE(world.ok());
  for (std::size_t lane = 0; lane < 11; ++lane) {
    std::vector<motion::PlainSphere> spheres(11, {{0, 0, 0}, 0.05});
    EXPECT_EQ(world->first_hit(motion::packed(spheres), {0, 0, 0}, 6), "");
    spheres[lane].center = {0, 5.12, 0};
    EXPECT_EQ(world->first_hit(motion::packed(spheres), {0, 0, 0}, 6), "cylinders/0");
  }
}

TEST(CollisionWorld, NothingCollidesInAnEmptyWorld) {
  const auto world = motion::CollisionWorld::make({});
  ASSERT_TRUE(world.ok());
  EXPECT_FALSE(hits(*world, {0, 0, 0}, 1));
}

TEST(CollisionWorld, BadObstaclesAreErrorsThatNameTheRow) {
  const auto where = [](const motion::Obstacles& obstacles) {
    const auto world = motion::CollisionWorld::make(obstacles);
    return world.ok() ? "ok" : world.error().code + " " + world.error().where;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  motion::Obstacles box, cylinder, convex, cloud, turned;
  box.boxes = {{{}, {1, 1, 1}}, {{}, {1, nan, 1}}};
  cylinder.cylinders = {{{}, 0, 1}};
  convex.convex = {{{}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}};
  cloud.clouds = {{{{0, static_cast<float>(nan), 0}}, 0.01}};
  turned.boxes = {{{{0, 0, 0}, {0, 0, 0, 0}}, {1, 1, 1}}};
  EXPECT_EQ(where(box), "motion.bad_obstacle boxes/1");
  EXPECT_EQ(where(cylinder), "motion.bad_obstacle cylinders/0");
  EXPECT_EQ(where(convex), "motion.bad_obstacle convex/0");
  EXPECT_EQ(where(cloud), "motion.bad_obstacle clouds/0");
  EXPECT_EQ(where(turned), "motion.bad_obstacle boxes/0");
}

// ---- Properties over random worlds ----

TEST(CollisionWorld, KernelsAgreeWithThePlainReference) {
  int touched = 0, at_edges = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const motion::Obstacles obstacles = random_obstacles(seed);
    const auto world = motion::CollisionWorld::make(obstacles);
    ASSERT_TRUE(world.ok());
    Stream draw = Seed(seed).child("spheres").stream();
    for (int i = 0; i < 2500; ++i) {
      const Vec3 at{draw.uniform(-1.5, 1.5), draw.uniform(-1.5, 1.5), draw.uniform(-1.5, 1.5)};
      const double radius = draw.uniform(0.01, 0.15);
      const bool hit = hits(*world, at, radius);
      touched += hit ? 1 : 0;
      if (hit) {
        EXPECT_TRUE(hits_reference(obstacles, at, radius + 2e-5));
      } else if (hits_reference(obstacles, at, radius - 2e-5)) {
        // The reference has a convex piece's faces alone: larger at edges than the kernel.
        ++at_edges;
        motion::Obstacles smooth = obstacles;
        smooth.convex.clear();
        EXPECT_FALSE(hits_reference(smooth, at, radius - 2e-5));
      }
    }
  }
  EXPECT_GT(touched, 1000);
  EXPECT_LT(at_edges, touched / 2);
}

double fcl_distance(const fcl::CollisionGeometryd& shape, const Pose& pose, Vec3 point) {
  const auto transform = [](const Pose& p) {
    const Quaternion& q = p.rotation;
    fcl::Transform3d t = fcl::Transform3d::Identity();
    t.linear() = fcl::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
    t.translation() = fcl::Vector3d(p.position.x, p.position.y, p.position.z);
    return t;
  };
  const fcl::Sphered probe(1e-6);
  fcl::DistanceRequestd request;
  fcl::DistanceResultd result;
  fcl::distance(&shape, transform(pose), &probe, transform({point, {}}), request, result);
  return result.min_distance;
}

TEST(CollisionWorld, FclAgreesAboutBoxesAndCylinders) {
  Stream draw = Seed(11).child("fcl").stream();
  int touched = 0;
  for (int i = 0; i < 800; ++i) {
    motion::Obstacles obstacles;
    const Vec3 half{draw.uniform(0.05, 0.4), draw.uniform(0.05, 0.4), draw.uniform(0.05, 0.4)};
    const Pose pose = random_pose(draw);
    const Vec3 at{draw.uniform(-1.5, 1.5), draw.uniform(-1.5, 1.5), draw.uniform(-1.5, 1.5)};
    double away = 0;
    if (i % 2 == 0) {
      obstacles.boxes.push_back({pose, half});
      away = fcl_distance(fcl::Boxd(2 * half.x, 2 * half.y, 2 * half.z), pose, at);
    } else {
      obstacles.cylinders.push_back({pose, half.x, half.z});
      away = fcl_distance(fcl::Cylinderd(half.x, 2 * half.z), pose, at);
    }
    const auto world = motion::CollisionWorld::make(obstacles);
    ASSERT_TRUE(world.ok());
    if (away < 0.002) {  // inside, or too near for its iterative solver
      EXPECT_TRUE(hits(*world, at, 0.01));
      continue;
    }
    EXPECT_TRUE(hits(*world, at, away + 1e-3)) << i;
    EXPECT_FALSE(hits(*world, at, away - 1e-3)) << i;
    ++touched;
  }
  EXPECT_GT(touched, 400);
}

// A right-angled edge is the convex piece's worst common case: 1 / cos(22.5 degrees) radii.
TEST(CollisionWorld, AConvexPieceIsNeverTooSmallAndLittleTooLarge) {
  motion::Obstacles as_box, as_hull;
  Stream draw = Seed(5).child("hull").stream();
  const Pose pose = random_pose(draw);
  const Vec3 half{0.1, 0.2, 0.3};
  as_box.boxes.push_back({pose, half});
  as_hull.convex.push_back({pose, {}});
  for (const double x : {-half.x, half.x})
    for (const double y : {-half.y, half.y})
      for (const double z : {-half.z, half.z})
        as_hull.convex[0].points.push_back(to_float({x, y, z}));
  const auto box = motion::CollisionWorld::make(as_box),
             hull = motion::CollisionWorld::make(as_hull);
  ASSERT_TRUE(box.ok() && hull.ok());
  for (int i = 0; i < 3000; ++i) {
    const Vec3 at =
        pose * Vec3{draw.uniform(-0.3, 0.3), draw.uniform(-0.4, 0.4), draw.uniform(-0.5, 0.5)};
    if (hits(*box, at, 0.05)) {
      EXPECT_TRUE(hits(*hull, at, 0.05 + 1e-5));
    }
    if (hits(*hull, at, 0.05)) {
      EXPECT_TRUE(hits(*box, at, 0.05 * 1.25));
    }
  }
}

}  // namespace
}  // namespace marketgen
