// Worlds whose fixtures move.
#include <cmath>

#include "unit/physics/small_worlds.h"

namespace marketgen {
namespace {

TEST(World, ABeltCarriesWhatStandsOnIt) {
  HandMadeScene shop;
  const scene::Scene scene = with_joint(shop, assets::JointKind::belt);
  physics::World world = made(scene);
  ASSERT_TRUE(world.set_belt_speed(0, 0.2).ok());
  EXPECT_TRUE(world.awake(0));
  run(world, second);
  EXPECT_NEAR(world.product_pose(0).position.x, 3.2, 0.02);
  EXPECT_NEAR(world.product_motion(0).velocity_m_s.x, 0.2, 0.005);
  ASSERT_TRUE(world.set_belt_speed(0, 0).ok());
  run(world, second);
  EXPECT_FALSE(world.awake(0));
  EXPECT_FALSE(world.set_belt_speed(0, 0.6).ok()) << "above its limit";
}

TEST(World, ADrawerTakesItsGoodsAlong) {
  HandMadeScene shop;
  const scene::Scene scene = with_joint(shop, assets::JointKind::slide);
  physics::World world = made(scene);
  run(world, 100);
  EXPECT_EQ(world.counts().woken, 0);
  ASSERT_TRUE(world.set_joint_force(0, 0.2).ok());
  run(world, second);
  const double opened = world.joint_position(0);
  EXPECT_GT(opened, 0.02);
  EXPECT_TRUE(world.awake(0));
  EXPECT_NEAR(world.product_pose(0).position.x - 3, opened, 0.01);
  EXPECT_EQ(made(scene, {.articulated = false}).set_joint_force(0, 1).error().code,
            "physics.bad_command");
}

// A flap of 2 kg, 1.5 m before its hinge, falls until its limit of half a radian holds it.
TEST(World, AFlapFallsToItsLimit) {
  HandMadeScene shop;
  const scene::Scene scene = with_joint(shop, assets::JointKind::hinge);
  physics::World world = made(scene);
  ASSERT_TRUE(world.set_joint_force(0, -0.1).ok());  // wakes it
  run(world, 4 * second);
  EXPECT_NEAR(std::abs(world.joint_position(0)), 0.5, 0.03);
}

TEST(World,
     FrictionComesFromTheMaterialPair) {  // cardboard on a rubber belt: 0.7, not the can's 0.4
  HandMadeScene shop;
  const scene::Scene scene = with_joint(shop, assets::JointKind::belt);
  for (const bool with_table : {true, false}) {
    physics::WorldOptions options;
    if (with_table) options.frictions = {{"cardboard", "rubber", 0.7, "", "", {}}};
    physics::World world = made(scene, options);
    ASSERT_TRUE(world.push(0, {{0.5 * 0.35 * 9.81, 0, 0}, {}}).ok());
    run(world, 100);
    const double way = world.product_pose(0).position.x - 3;
    if (with_table)
      EXPECT_LT(way, 0.001);
    else  // (0.5 - 0.4) g for 0.2 s
      EXPECT_NEAR(way, 0.5 * 0.1 * 9.81 * 0.04, 0.004);
  }
}

}  // namespace
}  // namespace marketgen
