// Every row stands, hangs or is fixed where it says: what stands on the floor does not fall over,
// what hangs reaches the wall or the ceiling.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fixture_table.h"
#include "oriented_box.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

constexpr double touch_m = 0.002;

// Where a part meets the floor: corners of boxes, and of cylinders the line or ring under them.
std::vector<Vec3> floor_contacts(const assets::FixturePart& part) {
  std::vector<Vec3> points;
  if (part.shape == assets::PartShape::box) {
    points = corners(oriented_box(part));
  } else {
    const Pose& pose = part.fixture_from_part;
    const Vec3 axis = rotate(pose.rotation, {0, 0, 1});
    const bool upright = std::abs(axis.z) > 0.99;
    for (const double end : {-1.0, 1.0}) {
      const Vec3 middle = pose.position + axis * (end * double(part.half_size.z));
      const double r = double(part.half_size.x);
      if (!upright) points.push_back({middle.x, middle.y, middle.z - r});
      if (!upright) continue;
      for (const Vec3& way : {Vec3{r, 0, 0}, Vec3{-r, 0, 0}, Vec3{0, r, 0}, Vec3{0, -r, 0}})
        points.push_back(middle + way);
    }
  }
  std::erase_if(points, [](Vec3 p) { return p.z > touch_m; });
  return points;
}

// Of bodies that are equally dense all over.
Vec3 center_of_mass(const assets::FixtureModel& model) {
  Vec3 sum;
  double mass = 0;
  for (const assets::FixturePart& part : model.parts) {
    const double volume =
        double(part.half_size.x) * double(part.half_size.y) * double(part.half_size.z);
    sum += part.fixture_from_part.position * volume;
    mass += volume;
  }
  return sum / mass;
}

// How far inside the hull of `points`, seen from above, the point lies; negative when outside.
double depth_in_hull(const std::vector<Vec3>& points, Vec3 point) {
  constexpr int directions = 64;
  double least = 1e9;
  for (int i = 0; i < directions; ++i) {
    const double angle = 6.283185307179586 * i / directions;
    const Vec3 way{std::cos(angle), std::sin(angle), 0};
    double reach = -1e9;
    for (const Vec3& p : points)
      reach = std::max(reach, dot(p, way));
    least = std::min(least, reach - dot(point, way));
  }
  return least;
}

double highest_of(const assets::FixtureModel& model, Vec3 way) {
  double reach = -1e9;
  for (const assets::FixturePart& part : model.parts) {
    for (const Vec3& corner : corners(oriented_box(part)))
      reach = std::max(reach, dot(corner, way));
  }
  return reach;
}

TEST(FixtureStand, EveryRowStandsOrHangsWhereItSays) {
  const catalog::Catalog& catalog = committed_catalog();
  for (const catalog::FixtureKind& kind : catalog.fixture_kinds) {
    SCOPED_TRACE(kind.kind);
    const assets::FixtureModel model = made(shape_of(kind), catalog);
    if (kind.mount == catalog::FixtureMount::ceiling) {
      EXPECT_NEAR(highest_of(model, {0, 0, 1}), kind.height_mm * 0.001, touch_m);
      continue;
    }
    if (kind.mount == catalog::FixtureMount::wall) {
      EXPECT_NEAR(highest_of(model, {0, 1, 0}), kind.depth_mm * 0.0005, touch_m);
      continue;
    }
    std::vector<Vec3> floor;
    for (const assets::FixturePart& part : model.parts) {
      const std::vector<Vec3> points = floor_contacts(part);
      floor.insert(floor.end(), points.begin(), points.end());
    }
    ASSERT_FALSE(floor.empty()) << "touches no floor";
    EXPECT_GT(depth_in_hull(floor, center_of_mass(model)), 0.015) << "falls over";
  }
}

TEST(FixtureStand, AHullKnowsInsideFromOutside) {
  const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_NEAR(depth_in_hull(square, {0.5, 0.2, 3}), 0.2, 1e-9);
  EXPECT_NEAR(depth_in_hull(square, {0.5, -0.1, 0}), -0.1, 1e-9);
}

}  // namespace
}  // namespace marketgen
