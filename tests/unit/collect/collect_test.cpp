// Collections carried out in physics: a can comes off its shelf, what is too wide is refused with
// the reason, and a grasp without force loses the can.
#include "collect/collect_run.h"

#include <gtest/gtest.h>

#include "support/committed_catalog.h"
#include "support/committed_robot.h"
#include "support/hand_made_scene.h"

namespace marketgen {
namespace {

constexpr std::uint32_t cereal = 0, can = 1;

// Four cans side by side on the upper board, 40 mm apart.
HandMadeScene cans_on_a_board() {
  HandMadeScene shop;
  for (int i = 0; i < 4; ++i)
    shop.add(can,
             {2.8F + 0.106F * static_cast<float>(i),
              HandMadeScene::shelf_y_m - 0.12F,
              HandMadeScene::upper_board_m});
  return shop;
}

robots::GraspTool gripper_of(const robots::Robot& robot) {
  return robots::load_grasp_tool(committed_rows, collect::gripper_row(robot).value()).value();
}

TEST(Collect, ADualArmTakesACanOffItsShelf) {
  const HandMadeScene shop = cans_on_a_board();
  const robots::Robot robot = committed_robot("realman-rm75");
  EXPECT_EQ(collect::gripper_row(robot).value(), "parallel-gripper");
  const auto plan = collect::plan_collect(shop.scene, 1, robot, gripper_of(robot), Seed(1));
  ASSERT_TRUE(plan.ok()) << to_string(plan.error());
  int watched = 0;
  collect::CollectPhase last = collect::CollectPhase::reach;
  const collect::CollectWatch watch =
      [&](const physics::World&, const physics::RobotActor&, collect::CollectPhase phase) {
        EXPECT_GE(static_cast<int>(phase), static_cast<int>(last));
        last = phase, ++watched;
        return Result<void>{};
      };
  const auto result =
      collect::run_collect(shop.scene, robot, *plan, committed_catalog().frictions, watch);
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_TRUE(result->held);
  EXPECT_LT(result->slip_m, 3e-3);
  EXPECT_NEAR(result->raised_m, collect::CollectOptions{}.lift_m, 6e-3);
  EXPECT_EQ(result->neighbours_toppled, 0);
  EXPECT_GT(watched, 10);
  EXPECT_EQ(last, collect::CollectPhase::hold);
  // The same again, bit for bit; and with fingers that do not press it stays where it is.
  const auto again = collect::run_collect(shop.scene, robot, *plan, committed_catalog().frictions);
  EXPECT_EQ(again->slip_m, result->slip_m);
  EXPECT_EQ(again->time_s, result->time_s);
  collect::CollectPlan weak = *plan;
  weak.grasp.grasp.force_n = 0.2;
  const auto lost = collect::run_collect(shop.scene, robot, weak, committed_catalog().frictions);
  ASSERT_TRUE(lost.ok());
  EXPECT_FALSE(lost->held);
}

TEST(Collect, WhatCannotBeTakenIsRefusedWithTheReason) {
  HandMadeScene shop;
  shop.add(cereal, {3, HandMadeScene::shelf_y_m - 0.12F, HandMadeScene::upper_board_m});
  const robots::Robot robot = committed_robot("realman-rm75");
  const robots::GraspTool tool = gripper_of(robot);
  const auto code = [&](std::uint32_t row, const robots::Robot& by) {
    const auto plan = collect::plan_collect(shop.scene, row, by, tool, Seed(1));
    return plan.ok() ? "ok" : plan.error().code;
  };
  EXPECT_EQ(code(0, robot), "motion.no_grasp");
  EXPECT_EQ(code(7, robot), "collect.no_product");
  EXPECT_EQ(code(0, committed_robot("suction-cup")), "robot.unknown");
}

}  // namespace
}  // namespace marketgen
