// A stocked hall has the same hash in every build: release, dev and under the sanitizers.
#include "support/golden.h"

#include "scene/scene.h"
#include "support/hand_laid_shop.h"

namespace marketgen {
namespace {

TEST(Golden, HandLaidShop) {
  HandLaidShop shop = shop_of(selling_types());
  for (plan::Zone& zone : shop.plan.zones)
    zone.stock.misplaced = 0.05;
  const auto scene = scene::build_scene(shop.layout, shop.plan, committed_catalog(), Seed(5));
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  expect_golden("hand-laid shop, seed 5", scene::scene_hash(*scene));
}

}  // namespace
}  // namespace marketgen
