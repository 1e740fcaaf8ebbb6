// Worlds of generated shops.
#include "support/hand_laid_shop.h"
#include "unit/physics/small_worlds.h"

namespace marketgen {
namespace {

// 2,000 goods of 20 shops.
TEST(World, GoodsOfGeneratedStoresStayWhenTheyAreWoken) {
  std::size_t woken = 0, drifted = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const HandLaidShop shop = shop_of({"canned", "dairy", "beverages", "household"});
    const Result<scene::Scene> scene =
        scene::build_scene(shop.layout, shop.plan, committed_catalog(), Seed(seed));
    ASSERT_TRUE(scene.ok());
    physics::World world = made(*scene);
    const auto products = static_cast<std::uint32_t>(scene->products.size());
    ASSERT_GT(products, 500U);
    for (std::uint32_t i = 0; i < 100; ++i) {
      EXPECT_TRUE(world.wake(i * (products / 100)).ok());
    }
    run(world, 10 * second);
    const std::vector<physics::WorldEvent> events = world.take_events();
    EXPECT_EQ(
        count(events, physics::EventKind::toppled) + count(events, physics::EventKind::dropped), 0)
        << seed;
    for (const std::uint32_t product : world.moved_products()) {
      const Pose start = scene::world_from_product(scene->products[product]);
      const double drift = distance(world.product_pose(product), start);
      EXPECT_LT(drift, 0.005) << seed << " " << scene::product_id(*scene, product);
      ++woken;
      drifted += drift > 0.001 ? 1 : 0;
    }
  }
  EXPECT_GE(woken, 2000U);
  EXPECT_EQ(drifted, 0U);
}

}  // namespace
}  // namespace marketgen
