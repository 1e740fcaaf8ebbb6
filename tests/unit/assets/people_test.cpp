// People: measures as published, closed meshes, feet that stand on the floor and do not slide.
#include "assets/people/person.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "assets/people/gait.h"
#include "assets/people/implicit_mesh.h"
#include "assets/people/soft_shapes.h"
#include "base/parallel.h"

namespace marketgen {
namespace {

using assets::ArmUse;
using assets::BodyForm;
using assets::PersonLook;
using assets::PersonPart;
using assets::PersonPose;
using assets::PersonRole;

constexpr Vec3f green{0.02F, 0.2F, 0.05F};

PersonLook person_of(std::uint64_t seed, PersonRole role = PersonRole::shopper) {
  return assets::draw_person(role, green, Seed(seed));
}

Bounds3 bounds_of_parts(const std::vector<PersonPart>& parts) {
  Bounds3 bounds;
  for (const PersonPart& part : parts) {
    bounds.include(bounds_of(part.mesh).low);
    bounds.include(bounds_of(part.mesh).high);
  }
  return bounds;
}

// Once round a circle of 2 m, to the left.
assets::WayPlace on_circle(double walked_m) {
  const double angle = walked_m / 2;
  return {{2 * std::cos(angle), 2 * std::sin(angle)}, angle + std::numbers::pi / 2};
}

TEST(ImplicitMesh, OfABallIsClosedAndHasItsVolume) {
  const auto ball = [](Vec3f p) { return length(p - Vec3f{0.1F, 0, 0}) - 0.2F; };
  const Mesh mesh = assets::mesh_of_field(ball, {{-0.2F, -0.3F, -0.3F}, {0.4F, 0.3F, 0.3F}}, 0.02F);
  EXPECT_TRUE(is_watertight(mesh));
  EXPECT_NEAR(volume_of(mesh), 4.0 / 3 * std::numbers::pi * 0.008, 0.0002);
  for (const Vec3f& p : mesh.positions)
    EXPECT_NEAR(ball(p), 0, 1e-4);
}

TEST(ImplicitMesh, ClosesWhereInnerCornersLieAcross) {  // two balls that touch along a diagonal
  const auto balls = [](Vec3f p) {
    return std::min(length(p - Vec3f{0.05F, 0.05F, 0.05F}),
                    length(p + Vec3f{0.05F, 0.05F, 0.05F})) -
           0.0866F;
  };
  for (const float cell : {0.011F, 0.02F, 0.033F, 0.05F}) {
    const Mesh mesh =
        assets::mesh_of_field(balls, {{-0.2F, -0.2F, -0.2F}, {0.2F, 0.2F, 0.2F}}, cell);
    EXPECT_TRUE(is_watertight(mesh)) << cell;
  }
}

TEST(People, HaveStaturesAsMeasured) {  // ANSUR II; older people are up to 3 and 5 cm shorter
  double sum[2] = {0, 0};
  int count[2] = {0, 0};
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const PersonLook look = person_of(seed);
    EXPECT_GE(look.stature_m, assets::min_stature_m);
    EXPECT_LE(look.stature_m, assets::max_stature_m);
    const auto form = static_cast<std::size_t>(look.form);
    sum[form] += look.stature_m;
    ++count[form];
  }
  EXPECT_NEAR(sum[0] / count[0], 1.75, 0.012);
  EXPECT_NEAR(sum[1] / count[1], 1.62, 0.014);
  EXPECT_NEAR(count[0] / 2000.0, 0.5, 0.04);
}

TEST(People, DifferFromOneAnother) {
  std::set<std::string> seen;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const PersonLook look = person_of(seed);
    seen.insert(std::to_string(look.stature_m) + "/" + std::to_string(look.nose) + "/" +
                std::to_string(look.jaw));
  }
  EXPECT_EQ(seen.size(), 40U);
}

TEST(People, StaffWearTheHousesApron) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const PersonLook look = person_of(seed, PersonRole::staff);
    EXPECT_TRUE(look.apron);
    EXPECT_EQ(look.apron_color, green);
  }
  EXPECT_FALSE(person_of(1).apron);
}

TEST(People, AreAsTallAsTheyShouldBe) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const PersonLook look = person_of(seed);
    const Bounds3 bounds = bounds_of_parts(
        assets::person_parts(look, assets::standing_pose(look), assets::PersonDetail::far));
    // Soles below, hair above.
    EXPECT_NEAR(bounds.high.z, look.stature_m + 0.022, 0.035) << seed;
    EXPECT_NEAR(bounds.low.z, 0, 0.002) << seed;
    // Elbow to elbow about a third of the stature, heel to toe and belly to back well less.
    EXPECT_NEAR(bounds.size().y / look.stature_m, 0.32, 0.06) << seed;
    EXPECT_LT(bounds.size().x / look.stature_m, 0.25) << seed;
  }
}

TEST(People, EveryPartIsClosedInEveryPose) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const PersonLook look =
        person_of(seed, seed % 3 == 2 ? PersonRole::staff : PersonRole::shopper);
    PersonPose pose =
        assets::walking_pose(look, on_circle, 6, 9, 0.4 + 0.37 * static_cast<double>(seed));
    if (seed % 4 == 1) pose.arms[1] = ArmUse::basket;
    if (seed % 4 == 2) pose.arms = {ArmUse::carry, ArmUse::carry};
    if (seed % 4 == 3) pose.arms[0] = ArmUse::rest;
    for (const PersonPart& part : assets::person_parts(look, pose)) {
      EXPECT_FALSE(part.mesh.triangles.empty()) << seed << " " << part.name;
      EXPECT_TRUE(is_watertight(part.mesh)) << seed << " " << part.name;
      EXPECT_GT(volume_of(part.mesh), 0) << seed << " " << part.name;
    }
  }
}

TEST(People, AreTheSameForAnyNumberOfThreads) {
  const PersonLook look = person_of(3);
  const PersonPose pose = assets::standing_pose(look);
  std::vector<PersonPart> one, many;
  {
    const ThreadLimit limit(1);
    one = assets::person_parts(look, pose, assets::PersonDetail::far);
  }
  {
    const ThreadLimit limit(4);
    many = assets::person_parts(look, pose, assets::PersonDetail::far);
  }
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].mesh.positions, many[i].mesh.positions) << one[i].name;
    EXPECT_EQ(one[i].mesh.triangles, many[i].mesh.triangles) << one[i].name;
  }
}

TEST(Gait, StandsAtBothEnds) {
  const PersonLook look = person_of(1);
  const PersonPose rest = assets::standing_pose(look);
  const auto straight = [](double s) { return assets::WayPlace{{s, 0}, 0}; };
  for (const int steps : {1, 2, 5, 8}) {
    for (const double walked : {0.0, 3.0}) {
      const PersonPose pose = assets::walking_pose(look, straight, 3, steps, walked);
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(length(pose.feet[i].ball - rest.feet[i].ball), 0, 1e-9) << steps;
        EXPECT_NEAR(pose.feet[i].yaw_rad, rest.feet[i].yaw_rad, 1e-9) << steps;
        EXPECT_NEAR(pose.feet[i].pitch_rad, 0, 1e-9) << steps;
      }
    }
  }
}

// Every foot that is flat on the floor stays where it is in the store, on a curve, too; one foot at
// least always stands, and no foot goes through the floor or jumps.
TEST(Gait, FeetDoNotSlide) {
  const PersonLook look = person_of(2);
  constexpr double length_m = 8, dx = 0.005;
  constexpr int steps = 12;
  const auto in_store = [&](double walked, std::size_t foot) {
    const assets::WayPlace at = on_circle(walked);
    const Pose pose{{at.position.x, at.position.y, 0}, rotation_about({0, 0, 1}, at.heading_rad)};
    return pose * assets::walking_pose(look, on_circle, length_m, steps, walked).feet[foot].ball;
  };
  const auto pitch = [&](double walked, std::size_t foot) {
    return assets::walking_pose(look, on_circle, length_m, steps, walked).feet[foot].pitch_rad;
  };
  for (double walked = 0; walked + dx <= length_m; walked += dx) {
    int on_floor = 0;
    for (std::size_t foot = 0; foot < 2; ++foot) {
      const Vec3 before = in_store(walked, foot), after = in_store(walked + dx, foot);
      EXPECT_GE(before.z, -1e-9);
      const double moved = length(after - before);
      EXPECT_LT(moved, 0.10) << walked;  // a swinging foot overtakes the body
      const bool ball_down = before.z < 1e-9 && after.z < 1e-9;
      if (ball_down && pitch(walked, foot) >= 0 && pitch(walked + dx, foot) >= 0) {
        EXPECT_LT(moved, 1e-9) << walked;
      }
      on_floor += before.z < 0.08 && moved < 0.01 ? 1 : 0;
    }
    EXPECT_GE(on_floor, 1) << walked;
  }
}

TEST(Gait, SolesTouchTheFloorThroughoutAStep) {
  const PersonLook look = person_of(5);
  for (double walked = 1.0; walked < 2.3; walked += 0.21) {
    const PersonPose pose = assets::walking_pose(look, on_circle, 6, 9, walked);
    const Bounds3 bounds =
        bounds_of_parts(assets::person_parts(look, pose, assets::PersonDetail::far));
    EXPECT_NEAR(bounds.low.z, 0, 0.006) << walked;
  }
}

TEST(Gait, TurnsOnTheSpotAndStandsAfterwards) {
  const PersonLook look = person_of(4);
  const PersonPose rest = assets::standing_pose(look);
  for (const double turn : {1.0, -0.8}) {
    EXPECT_DOUBLE_EQ(assets::turned_rad(turn, 1), turn);
    for (const double done : {0.0, 1.0}) {
      const PersonPose pose = assets::turning_pose(look, turn, done);
      for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(length(pose.feet[i].ball - rest.feet[i].ball), 0, 1e-9) << turn << " " << done;
    }
    // Half way one foot has gone and the other has not yet.
    const PersonPose half = assets::turning_pose(look, turn, 0.5);
    EXPECT_NEAR(half.feet[0].ball.z + half.feet[1].ball.z, 0, 1e-9);
  }
}

TEST(Gait, StepsGrowWithSpeed) {  // walk ratio 0.0065 m min: 0.68 m at 1.2 m/s
  EXPECT_NEAR(assets::step_length_m(1.2), 0.684, 0.001);
  EXPECT_LT(assets::step_length_m(0.6), 0.5);
}

}  // namespace
}  // namespace marketgen
