// Soft packs on the shelves, pegs and heaps of generated shops.
#include "physics/soft/soft_pack.h"
#include "support/hand_laid_shop.h"
#include "unit/physics/small_worlds.h"

namespace marketgen {
namespace {

std::vector<std::uint32_t> soft_products(const scene::Scene& scene) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t row = 0; row < scene.products.size(); ++row) {
    if (physics::may_be_soft_pack(scene.catalog[scene.products[row].sku])) rows.push_back(row);
  }
  return rows;
}

// Every third, on level and tilted shelves.
TEST(SoftWorld, BagsOfGeneratedStoresStayWhenTheyAreWoken) {
  std::size_t woken = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const HandLaidShop shop = shop_of({"snacks", "dry_goods", "frozen", "bakery"});
    const Result<scene::Scene> scene =
        scene::build_scene(shop.layout, shop.plan, committed_catalog(), Seed(seed));
    ASSERT_TRUE(scene.ok());
    physics::World world = made(*scene, {.soft_pool = 150});
    const std::vector<std::uint32_t> soft = soft_products(*scene);
    for (std::size_t i = 0; i < soft.size(); i += 3)
      EXPECT_TRUE(world.wake(soft[i]).ok());
    run(world, 10 * second);
    EXPECT_EQ(world.counts().in_pool, 0);
    const std::vector<physics::WorldEvent> events = world.take_events();
    EXPECT_EQ(
        count(events, physics::EventKind::toppled) + count(events, physics::EventKind::dropped), 0)
        << seed;
    for (const std::uint32_t product : world.moved_products()) {
      EXPECT_LT(distance(world.product_pose(product),
                         scene::world_from_product(scene->products[product])),
                0.001)
          << seed << " " << scene::product_id(*scene, product);
      ++woken;
    }
  }
  EXPECT_GT(woken, 180U);
}

}  // namespace
}  // namespace marketgen
