// The same again: threads, snapshots, replay.
#include "base/parallel.h"
#include "unit/physics/small_worlds.h"

namespace marketgen {
namespace {

World pushed_row(const Scene& scene) {
  World world = made(scene);
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
           World world = pushed_row(shop.scene);
           return world.step(2 * second).ok() ? world.state_hash() : std::string("failed");
         }))
      hashes.push_back(hash);
  }
  EXPECT_NE(hashes[0], "failed");
  EXPECT_EQ(std::ranges::count(hashes, hashes[0]), 12);
}

TEST(World, GoesOnFromASnapshotAsIfNothingHadHappened) {
  const HandMadeScene shop = row_of_cans(10);
  World world = pushed_row(shop.scene);
  const WorldSnapshot half_way = world.snapshot();
  const std::string before = world.state_hash();
  run(world, second);
  const std::string end = world.state_hash();
  EXPECT_NE(before, end);

  ASSERT_TRUE(world.restore(half_way).ok());
  EXPECT_EQ(world.state_hash(), before);
  run(world, second);
  EXPECT_EQ(world.state_hash(), end);

  World other = made(shop.scene);
  ASSERT_TRUE(other.place(7, {{1, 1, 0.5}, {}}).ok());
  run(other, 77);
  ASSERT_TRUE(other.restore(half_way).ok());
  run(other, second);
  EXPECT_EQ(other.state_hash(), end);
  EXPECT_EQ(distance(other.product_pose(7), world_from_product(shop.scene.products[7])), 0);
}

TEST(World, TellingAnotherWorldTheSameGivesTheSame) {
  const HandMadeScene shop = row_of_cans(10);
  World world = pushed_row(shop.scene);
  run(world, second);
  World other = made(shop.scene);
  ASSERT_TRUE(replay(other, world.commands()).ok());
  EXPECT_EQ(other.state_hash(), world.state_hash());
  run(other, 1);
  EXPECT_NE(other.state_hash(), world.state_hash());
}

}  // namespace
}  // namespace marketgen
