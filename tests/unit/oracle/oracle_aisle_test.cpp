// The whole way of one item: driven to, taken off its shelf, let down into the basket; and of the
// executor that moves the robot.
#include "oracle/oracle_aisle.h"

#include <gtest/gtest.h>

#include "skills/body_executor.h"
#include "support/can_aisle.h"

namespace marketgen {
namespace {

std::filesystem::path data() {
  return std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data";
}

// What becomes of the episode; `failure`: what the oracle says.
Result<episodes::EpisodeResult> fetched(episodes::AisleWorld& world, std::string& failure) {
  MARKETGEN_TRY(const auto oracle, oracle::make_aisle_oracle(world, data(), Seed(3)));
  agent::Observation now = world.observe();
  MARKETGEN_CHECK(oracle->begin({"Collect it", world.spec().limit_s}, now));
  while (!world.done()) {
    MARKETGEN_TRY(const agent::Action action, oracle->act(now));
    MARKETGEN_TRY(now, world.step(action));
  }
  failure = oracle->failure();
  return world.finish();
}

// Small boxes on the upper board of a shelf that hangs higher: a cup is shorter than fingers, and
// the arm cannot bend so far down with it. The robot's right arm ends in a cup.
std::shared_ptr<const episodes::AisleStore> boxes_for_a_cup() {
  constexpr float higher_m = 0.5F;
  HandMadeScene shop;
  shop.scene.fixtures.front().position_m[2] = higher_m;
  catalog::Product& box = shop.scene.catalog.front();
  box.size_mm = {100, 40, 130};
  box.mass_kg = 0.15;
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t row = shop.add(0,
                                       {2.8F + 0.104F * static_cast<float>(i),
                                        HandMadeScene::shelf_y_m - 0.12F,
                                        HandMadeScene::upper_board_m + higher_m});
    shop.scene.products[row].flags |= scene::product_front_row;
  }
  auto store = episodes::open_aisle_store(data(), shop.scene, "suction");
  if (!store.ok()) fatal(to_string(store.error()).c_str());
  return std::move(store).value();
}

TEST(AisleOracle, FetchesABoxWithItsCup) {
  const auto store = boxes_for_a_cup();
  episodes::EpisodeSpec spec = can_episode(*store);
  spec.tools = "suction";
  spec.goals = {{"box-cereal", 1}};
  episodes::AisleWorld world(store, committed_catalog().frictions);
  ASSERT_TRUE(world.reset(spec).ok());
  std::string failure;
  const auto result = fetched(world, failure);
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_TRUE(result->success_strict) << failure << " after " << result->simulated_s;
  EXPECT_EQ(result->side_effects.dropped, 0);
  EXPECT_EQ(result->side_effects.displaced, 0) << "a cup needs no room beside the pack";
}

TEST(AisleOracle, FetchesACan) {
  const auto world = can_world(can_episode(*can_aisle()));
  std::string failure;
  const auto result = fetched(*world, failure);
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_TRUE(result->success_strict) << failure << " after " << result->simulated_s;
  EXPECT_EQ(result->side_effects.dropped, 0);
  EXPECT_EQ(result->side_effects.base_collisions, 0);
  EXPECT_GT(result->spl, 0.2);
  EXPECT_EQ(world->in_basket().size(), 1U);
}

TEST(BodyExecutor, MovesTheLiftAndStops) {
  const auto world = can_world(can_episode(*can_aisle()));
  const robots::Robot& robot = world->robot();
  skills::BodyExecutor body(robot, episodes::commanded_dofs(robot));
  agent::Observation now = world->observe();
  body.start(now);
  ASSERT_TRUE(body.move_joint(robot.find_dof("lift"), 0.5, 0.9).ok());
  body.grip(1, {0.02, 10});
  body.wait(0.5);
  int steps = 0;
  for (; !body.idle() && steps < 200; ++steps)
    now = world->step(body.next(now)).value();
  EXPECT_LT(steps, 200);
  EXPECT_NEAR(world->robot_state()[static_cast<std::size_t>(robot.find_dof("lift"))], 0.5, 2e-3);
  EXPECT_NEAR(now.openings_m[1], 0.02, 2e-3);
  EXPECT_NEAR(now.base.x_m, 2.0, 1e-3);
}

TEST(BodyExecutor, DrivesStraightBack) {
  const auto world = can_world(can_episode(*can_aisle()));
  skills::BodyExecutor body(world->robot(), episodes::commanded_dofs(world->robot()));
  agent::Observation now = world->observe();
  body.start(now);
  ASSERT_TRUE(body.drive_straight(-0.3, 0.2).ok());
  body.wait(0.3);
  while (!body.idle())
    now = world->step(body.next(now)).value();
  EXPECT_NEAR(now.base.x_m, 1.7, 0.01);
  EXPECT_NEAR(now.base.y_m, 1.6, 0.005);
  EXPECT_FALSE(body.drive_straight(0.3, 0).ok()) << "no speed is no way";
}

}  // namespace
}  // namespace marketgen
