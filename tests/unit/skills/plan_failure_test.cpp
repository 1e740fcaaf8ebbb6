// Errors of planners as failure codes, and a hand that is let down as far as that goes.
#include "skills/plan_failure.h"

#include <gtest/gtest.h>

#include "robots/robot_row.h"
#include "skills/arm_executor.h"

namespace marketgen {
namespace {

TEST(PlanFailure, SaysWhatWasMissing) {
  EXPECT_EQ(skills::failure_of_plan({"motion.no_grasp", "", ""}), "NoGrasp");
  EXPECT_EQ(skills::failure_of_plan({"robot.unreachable", "", ""}), "NoIK");
  EXPECT_EQ(skills::failure_of_plan({"motion.goal_in_collision", "", ""}), "NoPath");
  EXPECT_TRUE(skills::is_of_planning({"collect.no_place", "", ""}));
  EXPECT_FALSE(skills::is_of_planning({"catalog.unknown_sku", "", ""}));
}

// Over a counter so far below the tip.
double let_down_over(double counter_below_m) {
  auto robot = robots::load_robot(
      std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data", "panda", {{"tool", "panda-long-hand"}});
  if (!robot.ok()) fatal(to_string(robot.error()).c_str());
  auto arm = skills::ArmExecutor::make(*robot);
  if (!arm.ok()) fatal(to_string(arm.error()).c_str());
  agent::Observation ready;
  ready.position = {0, -0.785, 0, -2.356, 0, 1.571, 0.785};
  ready.velocity.assign(7, 0);
  ready.openings_m = {0.04};
  arm->start(ready);
  const Vec3 tip = arm->tip().position;
  const motion::BoxObstacle counter{{{tip.x, tip.y, tip.z - counter_below_m - 0.05}, {}},
                                    {0.2, 0.2, 0.05}};
  motion::Obstacles table;
  table.boxes = {counter};
  const skills::Surroundings around{table, table};
  const auto down = arm->let_down(around, 10);
  EXPECT_EQ(down.ok(), arm->tip().position.z < tip.z);
  return tip.z - arm->tip().position.z;
}

TEST(ArmExecutor, LetsDownAsFarAsThatGoes) {
  EXPECT_NEAR(let_down_over(0.30), 0.10, 1e-3);
  EXPECT_NEAR(let_down_over(0.08), 0.06, 1e-3);
  EXPECT_NEAR(let_down_over(0.045), 0.03, 1e-3);
  EXPECT_EQ(let_down_over(0.01), 0);
}

}  // namespace
}  // namespace marketgen
