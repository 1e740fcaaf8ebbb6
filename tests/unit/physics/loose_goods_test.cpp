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

// MuJoCo, told the same of a body of that mass, says the same of it.
TEST(LooseGoods, WeighAsManyTimesTheirRowAsTheyAreTold) {
  HandMadeScene shop = row_of_cans(2), heavy = row_of_cans(2);
  heavy.scene.catalog[can].mass_kg *= 1.5;
  physics::WorldOptions options = with_loose({0});
  options.mass_factors.assign(shop.scene.catalog.size(), 1.5);
  physics::World told = made(shop.scene, options), row = made(heavy.scene, with_loose({0}));
  for (physics::World* world : {&told, &row}) {
    ASSERT_TRUE(world->wake(0).ok());
    ASSERT_TRUE(world->push(0, {{0.4, 0.3, 2.0}, {0.01, 0, 0.02}}).ok());
    run(*world, 1);
    run(*world, second / 5);
  }
  const mjModel &a = told.model(), &b = row.model();
  const int body = mj_name2id(&a, mjOBJ_BODY, "pool-0");
  EXPECT_NEAR(a.body_mass[body], b.body_mass[body], 1e-9);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(a.body_inertia[3 * body + i], b.body_inertia[3 * body + i], 1e-9);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(a.dof_invweight0[a.body_dofadr[body] + i],
                b.dof_invweight0[b.body_dofadr[body] + i],
                1e-5 * b.dof_invweight0[b.body_dofadr[body] + i]);
  EXPECT_LT(distance(told.product_pose(0), row.product_pose(0)), 1e-5);
}

TEST(LooseGoods, FactorsOfMassThatMakeNoSenseAreAnError) {
  const HandMadeScene shop = row_of_cans(1);
  for (const std::vector<double>& factors :
       {std::vector<double>{1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0},
        std::vector<double>(shop.scene.catalog.size(), 0.0)}) {
    physics::WorldOptions options;
    options.mass_factors = factors;
    const auto world = physics::World::create(shop.scene, options);
    ASSERT_FALSE(world.ok());
    EXPECT_EQ(world.error().where, "WorldOptions.mass_factors");
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
