#include "physics/world/world.h"

#include "physics/settle/settle_model.h"
#include "unit/physics/small_worlds.h"

namespace marketgen {
namespace {

TEST(World, NothingMovesThatNobodyTouches) {
  HandMadeScene shop;
  shop.stock();
  physics::World world = made(shop.scene);
  EXPECT_EQ(world.counts().products, 8);
  run(world, second);
  EXPECT_EQ(world.counts().woken, 0);
  EXPECT_EQ(world.counts().awake, 0);
  EXPECT_TRUE(world.contacts().empty());
  EXPECT_NEAR(world.time_s(), 1, 1e-9);
}

TEST(World, AWokenCanRestsWhereItStoodAndBecomesStaticAgain) {
  HandMadeScene shop;
  const std::uint32_t it = shop.add(can, {3, on_shelf_y, lower});
  physics::World world = made(shop.scene);
  ASSERT_TRUE(world.wake(it).ok());
  EXPECT_TRUE(world.awake(it));
  run(world, second);
  EXPECT_FALSE(world.awake(it));
  EXPECT_EQ(world.counts().in_pool, 0);
  EXPECT_LT(distance(world.product_pose(it), scene::world_from_product(shop.scene.products[it])),
            0.0005);
  const std::vector<physics::WorldEvent> events = world.take_events();
  EXPECT_EQ(count(events, physics::EventKind::woke), 1);
  EXPECT_EQ(count(events, physics::EventKind::fell_asleep), 1);
  EXPECT_EQ(count(events, physics::EventKind::displaced), 0);
}

TEST(World, AStandingCanPressesWithItsWeight) {
  HandMadeScene shop;
  const std::uint32_t it = shop.add(can, {3, on_shelf_y, lower});
  physics::World world = made(shop.scene);
  double pressed = 0;
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(world.push(it, {}).ok());  // keeps it awake
    run(world, 1);
  }
  for (const physics::WorldContact& contact : world.contacts()) {
    EXPECT_EQ(contact.a.kind, physics::BodyKind::fixture);
    EXPECT_EQ(contact.b.kind, physics::BodyKind::product);
    EXPECT_EQ(contact.b.row, it);
    pressed += contact.force_n.z;
  }
  EXPECT_NEAR(pressed, 0.35 * 9.81, 0.02);
}

// Two cartons on top of each other: each contact has the friction of its own pair.
TEST(World, EveryContactHasTheFrictionOfItsPair) {
  HandMadeScene shop;
  const double height = shop.scene.catalog[cereal].height_m();
  const std::uint32_t below = shop.add(cereal, {3, on_shelf_y, upper});
  const std::uint32_t above = shop.add(cereal, {3, on_shelf_y, upper + static_cast<float>(height)});
  physics::WorldOptions options;
  options.frictions = {{"cardboard", "steel", 0.35, "", "", {}},
                       {"cardboard", "cardboard", 0.5, "", "", {}}};
  physics::World world = made(shop.scene, options);
  for (int i = 0; i < 50; ++i) {
    ASSERT_TRUE(world.push(below, {}).ok());
    ASSERT_TRUE(world.push(above, {}).ok());
    run(world, 1);
  }
  int on_shelf = 0, on_carton = 0;
  for (const physics::WorldContact& contact : world.contacts()) {
    const bool goods = contact.a.kind == physics::BodyKind::product;
    (goods ? on_carton : on_shelf) += 1;
    EXPECT_NEAR(contact.friction, goods ? 0.5 : 0.35, 1e-12);
  }
  EXPECT_GE(on_shelf, 3);
  EXPECT_GE(on_carton, 3);
}

TEST(World, TheCanAboveFallsWhenTheLowerOneIsTaken) {
  HandMadeScene shop;
  const std::uint32_t below = shop.add(can, {3, on_shelf_y, lower});
  const std::uint32_t above = shop.add(can, {3, on_shelf_y, lower + can_height});
  physics::World world = made(shop.scene);
  ASSERT_TRUE(world.place(below, {{1, 1, 0.3}, {}}).ok());
  EXPECT_TRUE(world.awake(above));
  run(world, 2 * second);
  EXPECT_NEAR(world.product_pose(above).position.z, double(lower), 0.001);
  EXPECT_NEAR(world.product_pose(below).position.z, 0, 0.001);
  const std::vector<physics::WorldEvent> events = world.take_events();
  EXPECT_EQ(count(events, physics::EventKind::dropped), 2);
  EXPECT_EQ(count(events, physics::EventKind::displaced), 2);
  EXPECT_EQ(world.counts().in_pool, 0);
}

TEST(World, AKnockedOverBoxIsReported) {
  HandMadeScene shop;
  const std::uint32_t it = shop.add(cereal, {3, on_shelf_y, HandMadeScene::upper_board_m});
  physics::World world = made(shop.scene);
  ASSERT_TRUE(world.push(it, {{}, {0.4, 0, 0}}).ok());
  run(world, 100);
  run(world, 2 * second);
  EXPECT_EQ(count(world.take_events(), physics::EventKind::toppled), 1);
}

// The same push in a model in which every can is a free body from the start.
std::vector<Vec3> reference_push(const scene::Scene& scene, Vec3 force, int steps, int after) {
  std::vector<std::uint32_t> all(scene.products.size());
  for (std::uint32_t i = 0; i < all.size(); ++i)
    all[i] = i;
  const Result<physics::SettleModel> built = physics::settle_model(scene, all, 3);
  const Result<physics::MujocoData> data = physics::make_data(*built->model, "reference");
  mjData* d = data->get();
  for (int i = 0; i < steps + after; ++i) {
    const bool pushing = i < steps;
    d->xfrc_applied[6] = pushing ? force.x : 0, d->xfrc_applied[7] = pushing ? force.y : 0;
    mj_step(built->model.get(), d);
  }
  std::vector<Vec3> ends;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const mjtNum* q = d->qpos + 7 * i;
    ends.push_back({q[0], q[1], q[2]});
  }
  return ends;
}

TEST(World, PushingARowWakesWhatMovesAndEndsAsIfAllWereFree) {
  const HandMadeScene shop = row_of_cans(10);
  const Vec3 force{4, 0, 0};
  constexpr int pushed = 60;
  physics::World world = made(shop.scene);
  ASSERT_TRUE(world.push(0, {force, {}}).ok());
  run(world, pushed);
  run(world, second);
  const std::vector<Vec3> ends = reference_push(shop.scene, force, pushed, second);
  const std::vector<std::uint32_t> woken = world.moved_products();
  int moved = 0;
  for (std::uint32_t i = 0; i < 10; ++i) {
    const Vec3 start = scene::world_from_product(shop.scene.products[i]).position;
    const bool moves = length(ends[i] - start) > 0.001;
    moved += moves ? 1 : 0;
    EXPECT_EQ(std::ranges::binary_search(woken, i), moves) << i;
    EXPECT_LT(length(world.product_pose(i).position - ends[i]), 0.005) << i;
  }
  EXPECT_GE(moved, 2);
  EXPECT_LE(moved, 9);
}

TEST(World, AFingerPushesWhatIsInItsWay) {
  const HandMadeScene shop = row_of_cans(3);
  physics::World world = made(shop.scene, with_finger());
  constexpr double start = 2.6 - 0.033 - 0.015, way = 0.03;
  for (int i = 0; i <= 300;
       ++i) {  // 30 mm at 0.05 m/s: 25 mm into the first, 20 mm into the second
    const double x = start + way * i / 300;
    ASSERT_TRUE(
        world.move_mocap("finger", {{x, double(on_shelf_y), double(lower) + 0.04}, {}}).ok());
    run(world, 1);
  }
  run(world, second);
  EXPECT_NEAR(world.product_pose(0).position.x, 2.6 + 0.025, 0.003);
  EXPECT_NEAR(world.product_pose(1).position.x, 2.6 + can_pitch + 0.020, 0.004);
  EXPECT_NEAR(world.product_pose(2).position.x, 2.6 + 2 * can_pitch + 0.015, 0.005);
  EXPECT_FALSE(world.move_mocap("thumb", {}).ok());
}

TEST(World, GoodsOnPegsHangUntilTheyArePulled) {
  HandMadeScene shop;
  shop.scene.shelves[1].use = assets::ShelfUse::hang;
  const std::uint32_t it = shop.add(cereal, {3, on_shelf_y - 0.6F, 1.2F});
  physics::World world = made(shop.scene);
  ASSERT_TRUE(world.wake(it).ok());
  run(world, second);
  EXPECT_LT(distance(world.product_pose(it), scene::world_from_product(shop.scene.products[it])),
            0.001);
  ASSERT_TRUE(world.wake(it).ok());
  EXPECT_EQ(world.moved_products().size(), 1U);
}

}  // namespace
}  // namespace marketgen
