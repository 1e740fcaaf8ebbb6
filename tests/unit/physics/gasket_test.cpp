// Magnetic gaskets of cooler doors: what it takes to open every row's.
#include <cmath>

#include "scene/fixture_stage.h"
#include "support/committed_catalog.h"
#include "unit/physics/small_worlds.h"

namespace marketgen {
namespace {

constexpr double ajar_rad = 0.2;

// From the hinge to the handle, along the closed door.
double lever_of(const scene::Scene& scene, std::uint32_t joint) {
  for (const scene::ScenePart& part : scene.parts) {
    if (part.unit == assets::UnitKind::handle && part.joint == static_cast<std::int32_t>(joint))
      return std::abs(double(part.position_m[0]) - double(scene.joints[joint].position_m[0]));
  }
  ADD_FAILURE() << "no handle";
  return 0.5;
}

// Half a second's pull at the handle, square to the door, and how far the door has come.
double opened_by(physics::World& world,
                 const scene::Scene& scene,
                 std::uint32_t joint,
                 double newtons) {
  const double lever = lever_of(scene, joint);
  EXPECT_TRUE(world.set_joint_force(joint, newtons * lever).ok());
  run(world, second / 2);
  return world.joint_position(joint);
}

// Calls `check` with the scene of every row whose doors have gaskets, and each such joint.
template <class Check>
int for_every_gasket(Check check) {
  int doors = 0;
  for (const catalog::FixtureKind& kind : committed_catalog().fixture_kinds) {
    const scene::Scene scene = scene::stage_fixture(kind, committed_catalog()).value();
    for (std::uint32_t row = 0; row < scene.joints.size(); ++row) {
      if (scene.joints[row].gasket <= 0) continue;
      SCOPED_TRACE(kind.kind + " " + scene.joints[row].name);
      check(scene, row);
      ++doors;
    }
  }
  return doors;
}

TEST(Gasket, TenNewtonsKeepACoolersDoorShutAndSixtyOpenIt) {
  const int doors = for_every_gasket([](const scene::Scene& scene, std::uint32_t row) {
    physics::World world = made(scene);
    EXPECT_LT(std::abs(opened_by(world, scene, row, 10)), 0.002);
    EXPECT_LT(std::abs(opened_by(world, scene, row, 20)), 0.002);
    EXPECT_GT(opened_by(world, scene, row, 60), ajar_rad);
  });
  EXPECT_GT(doors, 20);
}

// 12 mm from the frame only the hinge and its spring are left: 5 N open it on.
TEST(Gasket, LetsGoWithinTwoCentimetresAndTakesHoldAgain) {
  const scene::Scene scene =
      scene::stage_fixture(*committed_catalog().fixture_kind("cooler-one-door"),
                           committed_catalog())
          .value();
  ASSERT_GT(scene.joints[0].gasket, 0);
  physics::World world = made(scene);
  const double lever = lever_of(scene, 0);
  ASSERT_TRUE(world.set_joint_force(0, 45 * lever).ok());
  while (world.joint_position(0) * lever < 0.02)
    run(world, 1);
  ASSERT_TRUE(world.set_joint_force(0, 8 * lever).ok());
  const double let_go = world.joint_position(0);
  run(world, second / 2);
  EXPECT_GT(world.joint_position(0), let_go + 0.02);
  ASSERT_TRUE(world.set_joint_force(0, 0).ok());
  run(world, 15 * second);
  EXPECT_LT(std::abs(world.joint_position(0)), 0.002) << "it closes by itself";
  EXPECT_LT(std::abs(opened_by(world, scene, 0, 10)), 0.002);
}

// A moment taken with the door on its way goes on bit for bit, in another World too.
TEST(Gasket, GoesOnFromAnyMoment) {
  const scene::Scene scene =
      scene::stage_fixture(*committed_catalog().fixture_kind("cooler-one-door"),
                           committed_catalog())
          .value();
  physics::World world = made(scene), other = made(scene);
  const double torque = 2 * double(scene.joints[0].gasket);
  ASSERT_TRUE(world.set_joint_force(0, torque).ok());
  run(world, 20);
  const physics::WorldSnapshot moment = world.snapshot();
  ASSERT_GT(world.joint_position(0), 0);
  ASSERT_LT(world.joint_position(0), double(scene.joints[0].gasket_reach));
  run(world, 200);
  ASSERT_TRUE(other.restore(moment).ok());
  run(other, 200);
  EXPECT_EQ(world.joint_position(0), other.joint_position(0));
}

}  // namespace
}  // namespace marketgen
