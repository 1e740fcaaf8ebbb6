// The look of the robots: closed solids of the right size, held by the collision capsules, standing
// where the published dimensions say.
#include "robots/link_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>

#include "support/committed_robot.h"
#include "support/outside_of_link.h"

namespace marketgen {
namespace {

void expect_solid(const Mesh& mesh, double volume, double tolerance) {
  EXPECT_TRUE(is_watertight(mesh));
  EXPECT_NEAR(volume_of(mesh), volume, tolerance * volume);
  for (const Vec3f& n : mesh.normals)
    EXPECT_NEAR(length(n), 1, 1e-4);
}

TEST(LinkParts, SolidsAreClosedAndHaveTheirVolumes) {
  constexpr double pi = std::numbers::pi;
  robots::BodyShape box;
  box.size = {0.2, 0.3, 0.4};
  expect_solid(robots::mesh_of(box), 0.024, 1e-5);
  box.rounding = 0.05;
  // Inner box, six slabs, twelve quarter tubes, a ball (Steiner's formula).
  const double a = 0.1, b = 0.2, c = 0.3, r = 0.05;
  const double rounded = a * b * c + 2 * r * (a * b + b * c + c * a) + pi * r * r * (a + b + c) +
                         4.0 / 3 * pi * r * r * r;
  expect_solid(robots::mesh_of(box), rounded, 0.01);
  robots::BodyShape tube;
  tube.kind = robots::ShapeKind::tube;
  tube.radius = 0.1, tube.radius_end = 0.05, tube.length = 0.3;
  expect_solid(robots::mesh_of(tube), pi * 0.3 / 3 * (0.01 + 0.005 + 0.0025), 0.01);
  tube.rounding = 0.02;
  EXPECT_TRUE(is_watertight(robots::mesh_of(tube)));
  robots::BodyShape ball;
  ball.kind = robots::ShapeKind::ball, ball.radius = 0.1;
  expect_solid(robots::mesh_of(ball), 4.0 / 3 * pi * 0.001, 0.03);
  EXPECT_TRUE(robots::mesh_of(robots::BodyShape{}).positions.empty());
}

TEST(LinkParts, EverySolidOfEveryRowIsClosed) {
  for (const char* id :
       {"panda", "panda-on-stand", "realman-rm65", "realman-rm75", "suction-cup"}) {
    for (const robots::Link& link : committed_robot(id).links) {
      for (const robots::BodyShape& shape : link.look)
        EXPECT_TRUE(is_watertight(robots::mesh_of(shape))) << id << " " << link.name;
    }
  }
}

// To 6 mm: what the spheres' margin of 5 mm nearly holds too. The lowest 70 mm of stand and
// dual-arm robots, foot plate, wheels and skirt, are left open: capsules there would touch the
// floor.
TEST(LinkParts, CapsulesHoldWhatALinkLooksLike) {
  for (const char* id :
       {"panda", "panda-on-stand", "realman-rm65", "realman-rm75", "suction-cup"}) {
    for (const robots::Link& link : committed_robot(id).links) {
      const auto parts = robots::link_parts(link);
      ASSERT_TRUE(parts.ok()) << to_string(parts.error());
      if (link.look.empty()) continue;
      ASSERT_FALSE(link.capsules.empty()) << id << " " << link.name;
      const double floor = link.name == "base" || link.name == "stand" ? 0.07 : -1;
      double worst = -1;
      for (const robots::LinkPart& part : *parts) {
        for (const Vec3f& p : part.mesh.positions)
          worst = std::max(worst, p.z < floor ? -1 : outside(link, to_double(p)));
      }
      EXPECT_LT(worst, 0.006) << id << " " << link.name;
    }
  }
}

Bounds3 bounds_of_robot(const robots::Robot& robot,
                        const std::vector<double>& q,
                        std::string_view skip) {
  Bounds3 bounds;
  const auto parts = robots::robot_parts(robot, robots::link_poses(robot, q));
  EXPECT_TRUE(parts.ok());
  for (std::size_t link = 0; parts.ok() && link < parts->size(); ++link) {
    const std::string& name = robot.links[link].name;
    if (!skip.empty() && (name.starts_with("left_") || name.starts_with("right_"))) continue;
    for (const robots::LinkPart& part : (*parts)[link]) {
      for (const Vec3f& p : part.mesh.positions)
        bounds.include(p);
    }
  }
  return bounds;
}

TEST(LinkParts, TheDualArmRobotHasTheDataSheetsSize) {  // 640 x 450 x 1780 mm, arms aside
  const robots::Robot robot = committed_robot("realman-rm65");
  const Bounds3 body = bounds_of_robot(robot, robots::neutral_state(robot), "arms");
  EXPECT_NEAR(body.size().x, 0.640F, 0.01F);
  EXPECT_NEAR(body.size().y, 0.450F, 0.005F);
  EXPECT_NEAR(body.size().z, 1.780F, 0.02F);
  EXPECT_NEAR(body.low.z, 0, 1e-4F);  // the wheels stand on the floor
}

// The stowed arms, with grippers, stay within the circle in which the base turns on the spot.
TEST(LinkParts, TheStowedDualArmTurnsInItsOwnCircle) {
  for (const char* id : {"realman-rm65", "realman-rm75"}) {
    const robots::Robot robot = committed_robot(id);
    const auto q = robots::with_posture(*robot.find_posture("stow"), robots::neutral_state(robot));
    const auto parts = robots::robot_parts(robot, robots::link_poses(robot, q));
    ASSERT_TRUE(parts.ok());
    double farthest = 0;
    for (const auto& link : *parts) {
      for (const robots::LinkPart& part : link) {
        for (const Vec3f& p : part.mesh.positions)
          farthest = std::max(farthest, std::hypot(double{p.x}, double{p.y}));
      }
    }
    EXPECT_LT(farthest, 0.45) << id;
    EXPECT_GT(farthest, 0.32) << id;  // the corners of the base itself
  }
}

// Franka Hand manual: 204 mm across the fingers' way, 63 mm deep. At q = 0 the shoulder is at
// 333 mm, the wrist at 1033 mm (Denavit-Hartenberg table); the shells stand 40 to 70 mm above.
TEST(LinkParts, ThePandaHasItsPublishedDimensions) {
  const robots::Robot panda = committed_robot("panda");
  const auto hand =
      robots::link_parts(panda.links[static_cast<std::size_t>(panda.find_link("hand"))]);
  ASSERT_TRUE(hand.ok());
  Bounds3 bounds;
  for (const robots::LinkPart& part : *hand)
    for (const Vec3f& p : part.mesh.positions)
      bounds.include(p);
  EXPECT_NEAR(bounds.size().y, 0.204F, 0.001F);
  EXPECT_NEAR(bounds.size().x, 0.063F, 0.006F);
  const Bounds3 whole = bounds_of_robot(panda, std::vector<double>(9), "");
  EXPECT_NEAR(whole.low.z, 0, 1e-4F);
  EXPECT_GT(whole.high.z, 1.033F + 0.04F);
  EXPECT_LT(whole.high.z, 1.033F + 0.07F);
  const auto flange =
      robots::link_parts(panda.links[static_cast<std::size_t>(panda.find_link("link7"))]);
  ASSERT_TRUE(flange.ok());
  float top = 0;
  for (const robots::LinkPart& part : *flange)
    for (const Vec3f& p : part.mesh.positions)
      top = std::max(top, p.z);
  EXPECT_NEAR(top, 0.107F, 1e-4F);  // the shell ends at the flange
}

// White shells and dark joints, as photographs of both makers' arms show.
TEST(LinkParts, ArmsAreMostlyWhiteWithDarkJoints) {
  for (const char* id : {"panda", "rm65-b-v", "rm75-b"}) {
    std::map<std::string, double> area;
    for (const robots::Link& link : committed_robot(id).links) {
      const auto parts = robots::link_parts(link);
      ASSERT_TRUE(parts.ok());
      for (const robots::LinkPart& part : *parts) {
        for (const auto& t : part.mesh.triangles) {
          const Vec3f a = part.mesh.positions[t[0]];
          area[part.color] +=
              length(cross(part.mesh.positions[t[1]] - a, part.mesh.positions[t[2]] - a)) / 2;
        }
      }
    }
    double total = 0;
    for (const auto& [color, square_m] : area)
      total += square_m;
    EXPECT_GT(area["#e6e6e3"] / total, 0.6) << id;
    EXPECT_GT((area["#1b1b1d"] + area["#3a3d42"]) / total, 0.04) << id;
  }
}

TEST(LinkParts, ALinkWithoutALookShowsItsCapsules) {
  robots::Link link;
  link.capsules = {{{0, 0, 0}, {0, 0, 0.2}, 0.05}};
  const auto parts = robots::link_parts(link);
  ASSERT_TRUE(parts.ok());
  ASSERT_EQ(parts->size(), 1U);
  const Bounds3 bounds = bounds_of((*parts)[0].mesh);
  EXPECT_NEAR(bounds.size().z, 0.3F, 1e-4F);
  EXPECT_NEAR(bounds.size().x, 0.1F, 1e-3F);
}

TEST(LinkParts, MeshFilesAreScaledAndPlacedOrNamedInAnError) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir());
  const std::filesystem::path file = folder / "robots_link_parts.obj";
  std::ofstream(file) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  robots::Link link;
  link.look.resize(1);
  link.look[0].kind = robots::ShapeKind::mesh;
  link.look[0].mesh_file = file.string();
  link.look[0].size = {2, 2, 2};
  link.look[0].link_from_shape.position = {0, 0, 1};
  const auto parts = robots::link_parts(link);
  ASSERT_TRUE(parts.ok()) << to_string(parts.error());
  const Bounds3 bounds = bounds_of((*parts)[0].mesh);
  EXPECT_EQ(bounds.high.x, 2);
  EXPECT_EQ(bounds.low.z, 1);
  link.look[0].mesh_file = "arm.dae";
  const auto other = robots::link_parts(link);
  ASSERT_FALSE(other.ok());
  EXPECT_EQ(other.error().code, "robot.bad_file");
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace marketgen
