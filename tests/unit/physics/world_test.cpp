#include "physics/world.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "physics/settle_model.h"
#include "support/hand_laid_shop.h"
#include "support/hand_made_scene.h"

namespace marketgen {
namespace {

constexpr float lower = HandMadeScene::lower_board_m;
constexpr float on_shelf_y = HandMadeScene::shelf_y_m - 0.1F;
constexpr std::uint32_t cereal = 0, can = 1;
constexpr float can_height = 0.115F, can_pitch = 0.071F;  // 66 mm wide, 5 mm apart
constexpr int second = 500;                               // steps

World made(const Scene& scene, WorldOptions options = {}) {
  Result<World> world = World::create(scene, std::move(options));
  if (!world.ok()) fatal(to_string(world.error()).c_str());
  return std::move(world).value();
}

void run(World& world, int steps) {
  const Result<void> done = world.step(steps);
  ASSERT_TRUE(done.ok()) << to_string(done.error());
}

double distance(const Pose& a, const Pose& b) {
  return length(a.position - b.position);
}

int count(const std::vector<WorldEvent>& events, EventKind kind) {
  return static_cast<int>(std::ranges::count(events, kind, &WorldEvent::kind));
}

HandMadeScene row_of_cans(int cans) {
  HandMadeScene shop;
  for (int i = 0; i < cans; ++i)
    shop.add(can, {2.6F + can_pitch * static_cast<float>(i), on_shelf_y, lower});
  return shop;
}

TEST(World, NothingMovesThatNobodyTouches) {
  HandMadeScene shop;
  shop.stock();
  World world = made(shop.scene);
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
  World world = made(shop.scene);
  ASSERT_TRUE(world.wake(it).ok());
  EXPECT_TRUE(world.awake(it));
  run(world, second);
  EXPECT_FALSE(world.awake(it));
  EXPECT_EQ(world.counts().in_pool, 0);
  EXPECT_LT(distance(world.product_pose(it), world_from_product(shop.scene.products[it])), 0.0005);
  const std::vector<WorldEvent> events = world.take_events();
  EXPECT_EQ(count(events, EventKind::woke), 1);
  EXPECT_EQ(count(events, EventKind::fell_asleep), 1);
  EXPECT_EQ(count(events, EventKind::displaced), 0);
}

TEST(World, AStandingCanPressesWithItsWeight) {
  HandMadeScene shop;
  const std::uint32_t it = shop.add(can, {3, on_shelf_y, lower});
  World world = made(shop.scene);
  double pressed = 0;
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(world.push(it, {}).ok());  // keeps it awake
    run(world, 1);
  }
  for (const WorldContact& contact : world.contacts()) {
    EXPECT_EQ(contact.a.kind, BodyKind::fixture);
    EXPECT_EQ(contact.b.kind, BodyKind::product);
    EXPECT_EQ(contact.b.row, it);
    pressed += contact.force_n.z;
  }
  EXPECT_NEAR(pressed, 0.35 * 9.81, 0.02);
}

TEST(World, TheCanAboveFallsWhenTheLowerOneIsTaken) {
  HandMadeScene shop;
  const std::uint32_t below = shop.add(can, {3, on_shelf_y, lower});
  const std::uint32_t above = shop.add(can, {3, on_shelf_y, lower + can_height});
  World world = made(shop.scene);
  ASSERT_TRUE(world.place(below, {{1, 1, 0.3}, {}}).ok());
  EXPECT_TRUE(world.awake(above));
  run(world, 2 * second);
  EXPECT_NEAR(world.product_pose(above).position.z, double(lower), 0.001);
  EXPECT_NEAR(world.product_pose(below).position.z, 0, 0.001);
  const std::vector<WorldEvent> events = world.take_events();
  EXPECT_EQ(count(events, EventKind::dropped), 2);
  EXPECT_EQ(count(events, EventKind::displaced), 2);
  EXPECT_EQ(world.counts().in_pool, 0);
}

TEST(World, AKnockedOverBoxIsReported) {
  HandMadeScene shop;
  const std::uint32_t it = shop.add(cereal, {3, on_shelf_y, HandMadeScene::upper_board_m});
  World world = made(shop.scene);
  ASSERT_TRUE(world.push(it, {{}, {0.4, 0, 0}}).ok());
  run(world, 100);
  run(world, 2 * second);
  EXPECT_EQ(count(world.take_events(), EventKind::toppled), 1);
}

// The same push in a model in which every can is a free body from the start.
std::vector<Vec3> reference_push(const Scene& scene, Vec3 force, int steps, int after) {
  std::vector<std::uint32_t> all(scene.products.size());
  for (std::uint32_t i = 0; i < all.size(); ++i)
    all[i] = i;
  const Result<SettleModel> built = settle_model(scene, all, 3);
  const Result<MujocoData> data = make_data(*built->model, "reference");
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
  World world = made(shop.scene);
  ASSERT_TRUE(world.push(0, {force, {}}).ok());
  run(world, pushed);
  run(world, second);
  const std::vector<Vec3> ends = reference_push(shop.scene, force, pushed, second);
  const std::vector<std::uint32_t> woken = world.moved_products();
  int moved = 0;
  for (std::uint32_t i = 0; i < 10; ++i) {
    const Vec3 start = world_from_product(shop.scene.products[i]).position;
    const bool moves = length(ends[i] - start) > 0.001;
    moved += moves ? 1 : 0;
    EXPECT_EQ(std::ranges::binary_search(woken, i), moves) << i;
    EXPECT_LT(length(world.product_pose(i).position - ends[i]), 0.005) << i;
  }
  EXPECT_GE(moved, 2);
  EXPECT_LE(moved, 9);
}

WorldOptions with_finger() {
  WorldOptions options;
  options.add_actors = [](mjSpec_& spec) -> Result<void> {
    mjsBody* finger = mjs_addBody(mjs_findBody(&spec, "world"), nullptr);
    mjs_setName(finger->element, "finger");
    finger->mocap = 1;
    finger->pos[2] = 2;
    mjsGeom* tip = mjs_addGeom(finger, nullptr);
    tip->type = mjGEOM_SPHERE;
    tip->size[0] = 0.01;
    return {};
  };
  return options;
}

TEST(World, AFingerPushesWhatIsInItsWay) {
  const HandMadeScene shop = row_of_cans(3);
  World world = made(shop.scene, with_finger());
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
  shop.scene.shelves[1].use = ShelfUse::hang;
  const std::uint32_t it = shop.add(cereal, {3, on_shelf_y - 0.6F, 1.2F});
  World world = made(shop.scene);
  ASSERT_TRUE(world.wake(it).ok());
  run(world, second);
  EXPECT_LT(distance(world.product_pose(it), world_from_product(shop.scene.products[it])), 0.001);
  ASSERT_TRUE(world.wake(it).ok());
  EXPECT_EQ(world.moved_products().size(), 1U);
}

// ---- Fixtures that move ----

// A flap or a belt under one can, in a fixture of its own.
Scene with_joint(HandMadeScene& shop, JointKind kind) {
  Scene& scene = shop.scene;
  SceneJoint joint;
  joint.name = "moving";
  joint.kind = kind;
  joint.lower = -0.5F, joint.upper = 0.5F;
  joint.rotation_wxyz = {0.70710678F, 0, 0.70710678F, 0};  // axis along X
  joint.mass_kg = 2;
  joint.damping = 1;
  scene.fixtures[0].joint_count = 1;
  scene.joints.push_back(joint);
  ScenePart part;
  part.unit = kind == JointKind::belt ? UnitKind::belt : UnitKind::drawer;
  part.position_m = {0, -1.5F, 0.5F};
  part.half_size_m = {0.6F, 0.2F, 0.02F};
  part.joint = 0;
  scene.parts.push_back(part);
  ++scene.fixtures[0].part_count;
  shop.add(can, {3, HandMadeScene::shelf_y_m - 1.5F, 0.52F});
  return scene;
}

TEST(World, ABeltCarriesWhatStandsOnIt) {
  HandMadeScene shop;
  const Scene scene = with_joint(shop, JointKind::belt);
  World world = made(scene);
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
  const Scene scene = with_joint(shop, JointKind::slide);
  World world = made(scene);
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

TEST(World,
     FrictionComesFromTheMaterialPair) {  // cardboard on a rubber belt: 0.7, not the can's 0.4
  HandMadeScene shop;
  const Scene scene = with_joint(shop, JointKind::belt);
  for (const bool with_table : {true, false}) {
    WorldOptions options;
    if (with_table) options.frictions = {{"cardboard", "rubber", 0.7, ""}};
    World world = made(scene, options);
    ASSERT_TRUE(world.push(0, {{0.5 * 0.35 * 9.81, 0, 0}, {}}).ok());
    run(world, 100);
    const double way = world.product_pose(0).position.x - 3;
    if (with_table)
      EXPECT_LT(way, 0.001);
    else  // (0.5 - 0.4) g for 0.2 s
      EXPECT_NEAR(way, 0.5 * 0.1 * 9.81 * 0.04, 0.004);
  }
}

// ---- The same again ----

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

// ---- Stores ----

TEST(World, GoodsOfGeneratedStoresStayWhenTheyAreWoken) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const HandLaidShop shop = shop_of({"canned", "dairy", "beverages", "household"});
    const Result<Scene> scene =
        build_scene(shop.layout, shop.plan, committed_catalog(), Seed(seed));
    ASSERT_TRUE(scene.ok());
    World world = made(*scene);
    const auto products = static_cast<std::uint32_t>(scene->products.size());
    ASSERT_GT(products, 500U);
    for (std::uint32_t i = 0; i < 100; ++i) {
      EXPECT_TRUE(world.wake(i * (products / 100)).ok());
    }
    run(world, 10 * second);
    EXPECT_EQ(count(world.take_events(), EventKind::toppled), 0) << seed;
    for (const std::uint32_t product : world.moved_products()) {
      const Pose start = world_from_product(scene->products[product]);
      EXPECT_LT(distance(world.product_pose(product), start), 0.001)
          << seed << " " << product_id(*scene, product);
    }
  }
}

// ---- Bad input ----

TEST(World, RefusesWhatMakesNoSense) {
  HandMadeScene shop;
  shop.stock();
  World world = made(shop.scene);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string before = world.state_hash();
  for (const Result<void>& result : {world.push(0, {{nan, 0, 0}, {}}),
                                     world.push(99, {}),
                                     world.wake(99),
                                     world.place(0, {{0, 0, 1}, {0, 0, 0, 0}}),
                                     world.place(0, {{nan, 0, 1}, {}}),
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
  EXPECT_EQ(World::create(shop.scene, {.pool = 0}).error().where, "WorldOptions.pool");
  EXPECT_EQ(World::create(shop.scene, {.wake_within_m = -1}).error().code, "physics.bad_command");
  const std::array<double, 4> inside_out{3, 3, 1, 1};
  EXPECT_EQ(World::create(shop.scene, {.region_m = inside_out}).error().where,
            "WorldOptions.region_m");
  shop.scene.catalog[can].mass_kg = 0;
  const Result<World> massless = World::create(shop.scene, {});
  ASSERT_FALSE(massless.ok());
  EXPECT_EQ(massless.error().code, "catalog.bad_row");
  EXPECT_EQ(massless.error().where, "can-cola");
}

TEST(World, AFullPoolLeavesTheRestFixedAndSaysSo) {
  const HandMadeScene shop = row_of_cans(3);
  World world = made(shop.scene, {.pool = 1});
  ASSERT_TRUE(world.push(0, {{4, 0, 0}, {}}).ok());
  EXPECT_TRUE(world.step(60).ok());
  EXPECT_FALSE(world.awake(1));
  EXPECT_GE(world.counts().refused, 1);
  EXPECT_GE(count(world.take_events(), EventKind::refused), 1);
  EXPECT_LT(distance(world.product_pose(1), world_from_product(shop.scene.products[1])), 1e-9);
}

TEST(World, AnExplosionIsAnErrorAndASnapshotMendsIt) {
  HandMadeScene shop;
  shop.stock();
  World world = made(shop.scene);
  const WorldSnapshot start = world.snapshot();
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
  World world = made(shop.scene, {.region_m = left});
  EXPECT_TRUE(world.has(0));
  EXPECT_FALSE(world.has(1));
  EXPECT_EQ(world.wake(1).error().code, "physics.bad_command");
}

}  // namespace
}  // namespace marketgen
