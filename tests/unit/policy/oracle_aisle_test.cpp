// The whole way of one item: driven to, taken off its shelf, let down into the basket; and of the
// executor that moves the robot.
#include "policy/oracle_aisle.h"

#include <gtest/gtest.h>

#include "policy/body_executor.h"
#include "support/can_aisle.h"

namespace marketgen {
namespace {

TEST(AisleOracle, FetchesACan) {
  const auto world = can_world(can_episode(*can_aisle()));
  const std::filesystem::path data = std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data";
  auto oracle = make_aisle_oracle(*world, data, Seed(3));
  ASSERT_TRUE(oracle.ok()) << to_string(oracle.error());
  Observation now = world->observe();
  ASSERT_TRUE((*oracle)->begin({"Collect a can", world->spec().limit_s}, now).ok());
  while (!world->done()) {
    const auto action = (*oracle)->act(now);
    ASSERT_TRUE(action.ok()) << to_string(action.error());
    const auto next = world->step(*action);
    ASSERT_TRUE(next.ok()) << to_string(next.error());
    now = *next;
  }
  const auto result = world->finish();
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_TRUE(result->success_strict) << (*oracle)->failure() << " after " << result->simulated_s;
  EXPECT_EQ(result->side_effects.dropped, 0);
  EXPECT_EQ(result->side_effects.base_collisions, 0);
  EXPECT_GT(result->spl, 0.2);
  EXPECT_EQ(world->in_basket().size(), 1U);
}

TEST(BodyExecutor, MovesTheLiftAndStops) {
  const auto world = can_world(can_episode(*can_aisle()));
  const Robot& robot = world->robot();
  BodyExecutor body(robot, commanded_dofs(robot));
  Observation now = world->observe();
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
  BodyExecutor body(world->robot(), commanded_dofs(world->robot()));
  Observation now = world->observe();
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
