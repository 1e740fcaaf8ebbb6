// The same again: threads, snapshots, replay.
#include "base/parallel.h"
#include "unit/physics/small_worlds.h"

namespace marketgen {
namespace {

physics::World pushed_row(const scene::Scene& scene) {
  physics::World world = made(scene);
  EXPECT_TRUE(world.push(0, {{4, 0.3, 0}, {}}).ok());
  EXPECT_TRUE(world.step(60).ok());
  return world;
}

TEST(World, IsTheSameForEveryThreadCount) {
  const HandMadeScene shop = row_of_cans(10);
  std::vector<std::string> hashes;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    for (const std::string& hash : parallel_map(4, [&](std::size_t) {
           physics::World world = pushed_row(shop.scene);
           return world.step(2 * second).ok() ? world.state_hash() : std::string("failed");
         }))
      hashes.push_back(hash);
  }
  EXPECT_NE(hashes[0], "failed");
  EXPECT_EQ(std::ranges::count(hashes, hashes[0]), 12);
}

TEST(World, GoesOnFromASnapshotAsIfNothingHadHappened) {
  const HandMadeScene shop = row_of_cans(10);
  physics::World world = pushed_row(shop.scene);
  const physics::WorldSnapshot half_way = world.snapshot();
  const std::string before = world.state_hash();
  run(world, second);
  const std::string end = world.state_hash();
  EXPECT_NE(before, end);

  ASSERT_TRUE(world.restore(half_way).ok());
  EXPECT_EQ(world.state_hash(), before);
  run(world, second);
  EXPECT_EQ(world.state_hash(), end);

  physics::World other = made(shop.scene);
  ASSERT_TRUE(other.place(7, {{1, 1, 0.5}, {}}).ok());
  run(other, 77);
  ASSERT_TRUE(other.restore(half_way).ok());
  run(other, second);
  EXPECT_EQ(other.state_hash(), end);
  EXPECT_EQ(distance(other.product_pose(7), scene::world_from_product(shop.scene.products[7])), 0);

  const std::string bytes = half_way.bytes();  // as another process would have it
  const auto read = physics::WorldSnapshot::of_bytes(bytes);
  ASSERT_TRUE(read.ok());
  physics::World third = made(shop.scene);
  ASSERT_TRUE(third.restore(*read).ok());
  EXPECT_EQ(third.snapshot().bytes(), bytes);
  run(third, second);
  EXPECT_EQ(third.state_hash(), end);
  for (const std::size_t length : {std::size_t{0}, bytes.size() / 2, bytes.size() - 1})
    EXPECT_FALSE(physics::WorldSnapshot::of_bytes(bytes.substr(0, length)).ok());
}

// A push every five seconds.
void thirty_seconds(physics::World& world, int from_push = 0, int to_push = 6) {
  for (int i = from_push; i < to_push; ++i) {
    ASSERT_TRUE(world.push(static_cast<std::uint32_t>(i), {{3, 0.2 * i, 0}, {}}).ok());
    run(world, 60);
    run(world, 5 * second - 60);
  }
}

TEST(World, ThirtySecondsAreTheSameOverThreadsSnapshotAndReplay) {
  const HandMadeScene shop = row_of_cans(6);
  const std::vector<std::string> threads = parallel_map(2, [&](std::size_t) {
    physics::World world = made(shop.scene);
    thirty_seconds(world);
    return world.state_hash();
  });
  physics::World straight = made(shop.scene);
  thirty_seconds(straight);
  EXPECT_NEAR(straight.time_s(), 30, 1e-9);
  EXPECT_GT(straight.moved_products().size(), 1U);
  EXPECT_EQ(threads, std::vector<std::string>(2, straight.state_hash()));

  physics::World first_half = made(shop.scene), second_half = made(shop.scene);
  thirty_seconds(first_half, 0, 3);
  ASSERT_TRUE(second_half.restore(first_half.snapshot()).ok());
  thirty_seconds(second_half, 3, 6);
  EXPECT_EQ(second_half.state_hash(), straight.state_hash());

  physics::World told = made(shop.scene);
  ASSERT_TRUE(physics::replay(told, straight.commands()).ok());
  EXPECT_EQ(told.state_hash(), straight.state_hash());
}

// The finger goes on by a millimetre every other step, into the side of the first can.
void poke(physics::World& world, int from_mm, int to_mm) {
  const float start_x = 2.6F - 0.033F - 0.02F;
  for (int i = from_mm; i < to_mm; ++i) {
    const Vec3 tip{start_x + 0.001 * i, on_shelf_y, lower + 0.05};
    ASSERT_TRUE(world.move_mocap("finger", {tip, {}}).ok());
    run(world, 2);
  }
}

// How contacts are solved depends on whether an actor touches something.
TEST(World, GoesOnFromASnapshotTakenWhileAnActorPushes) {
  const HandMadeScene shop = row_of_cans(4);
  physics::World straight = made(shop.scene, with_finger());
  poke(straight, 0, 30);
  const physics::WorldSnapshot pushing = straight.snapshot();
  EXPECT_TRUE(std::ranges::any_of(straight.contacts(), [](const physics::WorldContact& contact) {
    return contact.a.kind == physics::BodyKind::product &&
           contact.b.kind == physics::BodyKind::actor;
  }));
  EXPECT_GT(straight.model().opt.noslip_iterations, 0);
  poke(straight, 30, 60);

  physics::World other = made(shop.scene, with_finger());
  ASSERT_TRUE(other.restore(pushing).ok());
  poke(other, 30, 60);
  EXPECT_EQ(other.state_hash(), straight.state_hash());
  physics::World told = made(shop.scene, with_finger());
  ASSERT_TRUE(physics::replay(told, straight.commands()).ok());
  EXPECT_EQ(told.state_hash(), straight.state_hash());
}

TEST(World, TellingAnotherWorldTheSameGivesTheSame) {
  const HandMadeScene shop = row_of_cans(10);
  physics::World world = pushed_row(shop.scene);
  run(world, second);
  physics::World other = made(shop.scene);
  ASSERT_TRUE(physics::replay(other, world.commands()).ok());
  EXPECT_EQ(other.state_hash(), world.state_hash());
  run(other, 1);
  EXPECT_NE(other.state_hash(), world.state_hash());
}

}  // namespace
}  // namespace marketgen
