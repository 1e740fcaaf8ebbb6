#include <limits>

#include "unit/physics/small_worlds.h"

namespace marketgen {
namespace {

TEST(World, RefusesWhatMakesNoSense) {
  HandMadeScene shop;
  shop.stock();
  physics::World world = made(shop.scene);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string before = world.state_hash();
  for (const Result<void>& result : {world.push(0, {{nan, 0, 0}, {}}),
                                     world.push(99, {}),
                                     world.wake(99),
                                     world.place(0, {{0, 0, 1}, {0, 0, 0, 0}}),
                                     world.place(0, {{nan, 0, 1}, {}}),
                                     world.place(0, {{-0.5, 1, 1}, {}}),
                                     world.place(0, {{1, 1, 50}, {}}),
                                     world.set_control(0, 1),
                                     world.set_control(-1, 1),
                                     world.set_joint_force(0, 1),
                                     world.set_belt_speed(5, 1),
                                     world.step(-1),
                                     world.restore({})}) {
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, "physics.bad_command");
  }
  EXPECT_EQ(world.state_hash(), before);
  EXPECT_FALSE(world.actuator("arm").ok());
  EXPECT_TRUE(world.commands().empty());
}

TEST(World, RefusesGoodsWithoutMassAndOptionsOutOfRange) {
  HandMadeScene shop;
  shop.stock();
  EXPECT_EQ(physics::World::create(shop.scene, {.pool = 0}).error().where, "WorldOptions.pool");
  EXPECT_EQ(physics::World::create(shop.scene, {.wake_within_m = -1}).error().code,
            "physics.bad_command");
  physics::WorldOptions slippery;
  slippery.frictions = {{"tin", "steel", std::numeric_limits<double>::quiet_NaN(), "", "", {}}};
  EXPECT_EQ(physics::World::create(shop.scene, slippery).error().where, "WorldOptions.frictions");
  const std::array<double, 4> inside_out{3, 3, 1, 1};
  EXPECT_EQ(physics::World::create(shop.scene, {.region_m = inside_out}).error().where,
            "WorldOptions.region_m");
  shop.scene.catalog[can].mass_kg = 0;
  const Result<physics::World> massless = physics::World::create(shop.scene, {});
  ASSERT_FALSE(massless.ok());
  EXPECT_EQ(massless.error().code, "catalog.bad_row");
  EXPECT_EQ(massless.error().where, "can-cola");
}

// MuJoCo's own abort, a shape that it does not compile, and an error of the caller's.
TEST(World, WhatActorsGetWrongIsAnErrorAndNoAbort) {
  const HandMadeScene shop;
  physics::WorldOptions aborts, shapeless, refuses;
  aborts.add_actors = [](mjSpec_&) -> Result<void> {
    mju_error("no such mesh");
    return {};
  };
  shapeless.add_actors = [](mjSpec_& spec) -> Result<void> {
    mjs_addGeom(mjs_findBody(&spec, "world"), nullptr)->type = mjGEOM_BOX;  // without a size
    return {};
  };
  refuses.add_actors = [](mjSpec_&) -> Result<void> {
    return Error{"physics.bad_command", "arm", "not today"};
  };
  const Result<physics::World> aborted = physics::World::create(shop.scene, aborts);
  ASSERT_FALSE(aborted.ok());
  EXPECT_EQ(aborted.error().code, "physics.failed");
  EXPECT_NE(aborted.error().message.find("no such mesh"), std::string::npos);
  const Result<physics::World> sizeless = physics::World::create(shop.scene, shapeless);
  ASSERT_FALSE(sizeless.ok());
  EXPECT_EQ(sizeless.error().code, "physics.failed");
  EXPECT_EQ(physics::World::create(shop.scene, refuses).error().where, "arm");
}

TEST(World, AFullPoolLeavesTheRestFixedAndSaysSo) {
  const HandMadeScene shop = row_of_cans(3);
  physics::World world = made(shop.scene, {.pool = 1});
  ASSERT_TRUE(world.push(0, {{4, 0, 0}, {}}).ok());
  EXPECT_TRUE(world.step(60).ok());
  EXPECT_FALSE(world.awake(1));
  EXPECT_GE(world.counts().refused, 1);
  EXPECT_GE(count(world.take_events(), physics::EventKind::refused), 1);
  EXPECT_LT(distance(world.product_pose(1), scene::world_from_product(shop.scene.products[1])),
            1e-9);
}

TEST(World, AnExplosionIsAnErrorAndASnapshotMendsIt) {
  HandMadeScene shop;
  shop.stock();
  physics::World world = made(shop.scene);
  const physics::WorldSnapshot start = world.snapshot();
  ASSERT_TRUE(world.push(0, {{1e300, 0, 0}, {}}).ok());
  const Result<void> exploded = world.step(100);
  ASSERT_FALSE(exploded.ok());
  EXPECT_EQ(exploded.error().code, "physics.failed");
  EXPECT_FALSE(world.step().ok());
  ASSERT_TRUE(world.restore(start).ok());
  run(world, 10);
  EXPECT_FALSE(world.awake(0));
}

TEST(World, KnowsOnlyItsRegion) {
  HandMadeScene shop;
  shop.add(can, {2.6F, on_shelf_y, lower});
  shop.add(can, {3.4F, on_shelf_y, lower});
  const std::array<double, 4> left{0, 0, 3, 4};
  physics::World world = made(shop.scene, {.region_m = left});
  EXPECT_TRUE(world.has(0));
  EXPECT_FALSE(world.has(1));
  EXPECT_EQ(world.wake(1).error().code, "physics.bad_command");
}

}  // namespace
}  // namespace marketgen
