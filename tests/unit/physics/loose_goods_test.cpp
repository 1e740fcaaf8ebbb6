// Goods that lie loose (WorldOptions::loose): bodies of their own kind, which they keep at rest.
#include "physics/goods/goods_body.h"
#include "unit/physics/small_worlds.h"

namespace marketgen {
namespace {

physics::WorldOptions with_loose(std::vector<std::uint32_t> rows) {
  physics::WorldOptions options;
  options.loose = std::move(rows);
  options.pool = 4;
  return options;
}

TEST(LooseGoods, KeepTheirBodyAtRestWhereOthersGiveItBack) {
  const HandMadeScene shop = row_of_cans(2);
  physics::World world = made(shop.scene, with_loose({0}));
  for (const std::uint32_t can_row : {0U, 1U})
    ASSERT_TRUE(world.wake(can_row).ok());
  run(world, 3 * second);
  EXPECT_EQ(world.counts().awake, 0);
  EXPECT_EQ(world.counts().in_pool, 1);
  EXPECT_TRUE(world.awake(0));
  EXPECT_FALSE(world.awake(1));
}

TEST(LooseGoods, HaveTheBodyOfGoodsInBulk) {
  const HandMadeScene shop = row_of_cans(2);
  for (const bool loose : {true, false}) {
    physics::World world =
        made(shop.scene, with_loose(loose ? std::vector{0U} : std::vector<std::uint32_t>{}));
    ASSERT_TRUE(world.wake(0).ok());
    run(world, 1);
    const mjModel& m = world.model();
    const int geom = m.body_geomadr[mj_name2id(&m, mjOBJ_BODY, "pool-0")];
    const auto body = physics::goods_body(
        shop.scene.catalog[can], loose ? physics::GoodsUse::bulk : physics::GoodsUse::stocked);
    ASSERT_TRUE(body.ok());
    EXPECT_EQ(m.geom_condim[geom], (*body)->contact.dimensions);
    EXPECT_DOUBLE_EQ(m.geom_friction[3 * geom + 2], (*body)->contact.rolling_m);
  }
}

TEST(LooseGoods, RowsThatTheSceneDoesNotHaveAreAnError) {
  const HandMadeScene shop = row_of_cans(2);
  const auto world = physics::World::create(shop.scene, with_loose({2}));
  ASSERT_FALSE(world.ok());
  EXPECT_EQ(world.error().code, "physics.bad_command");
}

}  // namespace
}  // namespace marketgen
