// The whole way of one item: driven to, taken off its shelf, let down into the basket; and of the
// executor that moves the robot.
#include "oracle/oracle_aisle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "skills/body_executor.h"
#include "support/can_aisle.h"

namespace marketgen {
namespace {

std::filesystem::path data() {
  return std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data";
}

// What a control step did, by the physics, and what the oracle said that it was for.
struct Step {
  agent::Subtask subtask = agent::Subtask::none;
  double drove_m = 0, turned_rad = 0;  // of the base
  double opening_m = 0;                // of its tools together, after it
  bool holds = false;                  // something, after it
  std::size_t in_basket = 0;
};

Step step_between(const agent::Observation& before,
                  const agent::Observation& after,
                  const episodes::AisleWorld& world) {
  Step step;
  step.drove_m = std::hypot(after.base.x_m - before.base.x_m, after.base.y_m - before.base.y_m);
  step.turned_rad = std::abs(std::remainder(after.base.heading - before.base.heading, 2 * M_PI));
  step.opening_m = std::accumulate(after.openings_m.begin(), after.openings_m.end(), 0.0);
  for (const auto& [product, item] : world.watch().items())
    step.holds = step.holds || item.held_by >= 0;
  step.in_basket = world.in_basket().size();
  return step;
}

struct Fetched {
  episodes::EpisodeResult result;
  std::string failure;  // what the oracle says
  std::vector<Step> steps;
};

Result<Fetched> fetched(episodes::AisleWorld& world) {
  MARKETGEN_TRY(const auto oracle, oracle::make_aisle_oracle(world, data(), Seed(3)));
  agent::Observation now = world.observe();
  MARKETGEN_CHECK(oracle->begin({"Collect it", world.spec().limit_s}, now));
  Fetched made;
  while (!world.done()) {
    MARKETGEN_TRY(const agent::Action action, oracle->act(now));
    const agent::Observation before = now;
    MARKETGEN_TRY(now, world.step(action));
    made.steps.push_back(step_between(before, now, world));
    made.steps.back().subtask = oracle->subtask();
  }
  made.failure = oracle->failure();
  MARKETGEN_TRY(made.result, world.finish());
  return made;
}

// Names of the sub-tasks, one after another.
std::vector<std::string_view> order_of(const std::vector<Step>& steps) {
  std::vector<std::string_view> names;
  for (const Step& step : steps) {
    if (names.empty() || names.back() != name_of(step.subtask))
      names.push_back(name_of(step.subtask));
  }
  return names;
}

// Of the steps with that label, the share of which `holds` is true.
template <class Test>
double share_of(const std::vector<Step>& steps, agent::Subtask subtask, const Test& holds) {
  double all = 0, good = 0;
  for (const Step& step : steps) {
    if (step.subtask != subtask) continue;
    all += 1;
    good += holds(step) ? 1 : 0;
  }
  return all > 0 ? good / all : 0;
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
  const auto made = fetched(world);
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  const episodes::EpisodeResult& result = made->result;
  EXPECT_TRUE(result.success_strict) << made->failure << " after " << result.simulated_s;
  EXPECT_EQ(result.side_effects.dropped, 0);
  EXPECT_EQ(result.side_effects.displaced, 0) << "a cup needs no room beside the pack";
}

TEST(AisleOracle, FetchesACan) {
  const auto world = can_world(can_episode(*can_aisle()));
  const auto made = fetched(*world);
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  const episodes::EpisodeResult& result = made->result;
  EXPECT_TRUE(result.success_strict) << made->failure << " after " << result.simulated_s;
  EXPECT_EQ(result.side_effects.dropped, 0);
  EXPECT_EQ(result.side_effects.base_collisions, 0);
  EXPECT_GT(result.spl, 0.2);
  EXPECT_EQ(world->in_basket().size(), 1U);
  using agent::Subtask;
  const std::vector<std::string_view> order{
      "drive", "reach", "grasp", "lift", "drive", "place", "retreat", "none"};
  EXPECT_EQ(order_of(made->steps), order);
  const auto turns_wheels = [](const Step& step) {
    return step.drove_m > 1e-4 || step.turned_rad > 1e-4;
  };
  EXPECT_GT(share_of(made->steps, Subtask::drive, turns_wheels), 0.85);
  for (const Subtask still : {Subtask::reach, Subtask::grasp, Subtask::lift, Subtask::place})
    EXPECT_LT(share_of(made->steps, still, turns_wheels), 0.1) << name_of(still);
  const auto holds = [](const Step& step) { return step.holds; };
  EXPECT_EQ(share_of(made->steps, Subtask::reach, holds), 0);
  EXPECT_EQ(share_of(made->steps, Subtask::lift, holds), 1);
  EXPECT_GT(share_of(made->steps, Subtask::place, holds), 0.7) << "until it lets go";
  EXPECT_EQ(share_of(made->steps, Subtask::retreat, holds), 0);
  // The fingers are set to its width on the way, and close on it while it is grasped.
  double closed_m = 0;
  const Step* before = nullptr;
  for (const Step& step : made->steps) {
    const double by_m = before != nullptr ? before->opening_m - step.opening_m : 0;
    before = &step;
    if (step.subtask == Subtask::grasp) closed_m += by_m;
    if (step.subtask == Subtask::lift || step.subtask == Subtask::place) {
      EXPECT_LT(by_m, 1e-3) << &step - made->steps.data();
    }
  }
  EXPECT_GT(closed_m, 3e-3);
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
