// In-Aisle Item Collection with a gripper and a suction cup: the robot is sound, the cup takes and
// lets go as it is told, and what it holds is known to be held.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "robots/numeric_ik.h"
#include "robots/self_collision.h"
#include "support/can_aisle.h"

namespace marketgen {
namespace {

constexpr std::size_t cup = 1;  // the right arm's tool
constexpr double can_top_m = HandMadeScene::upper_board_m + 0.115;

std::shared_ptr<const episodes::AisleStore> store_with(const std::string& tools) {
  auto store = episodes::open_aisle_store(
      std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data", can_aisle()->scene, tools);
  if (!store.ok()) fatal(to_string(store.error()).c_str());
  return std::move(store).value();
}

// The same, but that the robot begins with the right cup looking down 0.6 m ahead of its base, so
// high over the first can's top.
std::shared_ptr<const episodes::AisleStore> store_over_the_can(double apart_m) {
  auto store = std::make_shared<episodes::AisleStore>(*store_with("suction"));
  const robots::Robot& robot = store->robot;
  const robots::JointGroup& arm = *robot.find_group("right_arm");
  const Quaternion down = rotation_about({0, 1, 0}, std::numbers::pi);
  const auto q = robots::solve_numeric(
      robot, arm.tip, arm.dofs, {{0.6, -0.25, can_top_m + apart_m}, down}, store->driving, Seed(3));
  if (!q.ok()) fatal(to_string(q.error()).c_str());
  store->driving = *q;
  return store;
}

std::unique_ptr<episodes::AisleWorld> over_the_can(double apart_m = 0.002) {
  const auto store = store_over_the_can(apart_m);
  episodes::EpisodeSpec spec = can_episode(*store);
  spec.tools = "suction";
  const auto& at = store->scene.products[0].position_m;
  spec.start = {at[0] - 0.25, at[1] - 0.6, 90};  // its right is east
  auto world = std::make_unique<episodes::AisleWorld>(store, committed_catalog().frictions);
  const auto reset = world->reset(spec);
  if (!reset.ok()) fatal(to_string(reset.error()).c_str());
  return world;
}

agent::Observation acted(episodes::AisleWorld& world,
                         double cup_opening_m,
                         int steps,
                         double lift_m_s = 0) {
  const std::vector<int> dofs = episodes::commanded_dofs(world.robot());
  const auto lift = static_cast<std::size_t>(
      std::ranges::find(dofs, world.robot().find_dof("lift")) - dofs.begin());
  agent::Action action = episodes::still_action(world.observe());
  action.tools[cup].opening_m = cup_opening_m;
  agent::Observation seen;
  for (int i = 0; i < steps; ++i) {
    action.position[lift] += lift_m_s * episodes::control_step_s;
    auto stepped = world.step(action);
    if (!stepped.ok()) fatal(to_string(stepped.error()).c_str());
    seen = std::move(stepped).value();
  }
  return seen;
}

TEST(AisleTools, AStoreOpensWithEachToolSet) {
  const auto grippers = store_with(""), with_cup = store_with("suction");
  EXPECT_EQ(grippers->station.tools().id, "gripper");
  EXPECT_EQ(with_cup->station.tools().id, "suction");
  for (const robots::Tool& tool : grippers->robot.tools)
    EXPECT_EQ(tool.kind, robots::ToolKind::gripper);
  ASSERT_EQ(with_cup->robot.tools.size(), 2U);
  EXPECT_EQ(with_cup->robot.tools[0].kind, robots::ToolKind::gripper);
  EXPECT_EQ(with_cup->robot.tools[cup].kind, robots::ToolKind::suction);
  const robots::Robot& robot = with_cup->robot;
  EXPECT_EQ(robot.find_group("right_arm")->tip, robot.tools[cup].frame);
}

TEST(AisleTools, TheRobotWithACupIsFreeAsItDrives) {
  const auto grippers = store_with("gripper"), with_cup = store_with("suction");
  const robots::Robot& robot = with_cup->robot;
  const std::vector<robots::LinkPair> pairs = robots::pairs_that_may_touch(robot);
  std::vector<double> q = with_cup->driving;
  for (int i = 0; i <= 9; ++i) {
    q[static_cast<std::size_t>(robot.find_dof("lift"))] = 0.1 * i;
    EXPECT_FALSE(robots::first_contact(robot, robots::link_poses(robot, q), pairs).has_value())
        << 0.1 * i;
  }
  const auto wide = motion::base_envelope(grippers->robot, grippers->driving),
             wide_too = motion::base_envelope(robot, with_cup->driving);
  ASSERT_TRUE(wide.ok() && wide_too.ok());
  EXPECT_LE(wide_too->radius_m, wide->radius_m + 0.01);
  EXPECT_TRUE(with_cup->standing_place(0).has_value());
}

TEST(AisleTools, OtherToolsThanTheStoresAreErrors) {
  const auto store = store_with("suction");
  episodes::AisleWorld world(store, committed_catalog().frictions);
  episodes::EpisodeSpec spec = can_episode(*store);
  EXPECT_EQ(world.reset(spec).error().code, "robot.unknown") << "an episode for grippers";
  spec.tools = "suction";
  EXPECT_TRUE(world.reset(spec).ok());
  const auto unknown =
      episodes::load_aisle_station(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data", "suctoin");
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.error().code, "robot.unknown");
  EXPECT_NE(unknown.error().message.find("\"suction\""), std::string::npos);
}

TEST(AisleTools, TheCupTakesACanByItsTopAndLetsGo) {
  const auto world = over_the_can();
  const agent::Observation first = world->observe();
  EXPECT_EQ(first.sealed, (std::vector<std::uint8_t>{0, 0}));
  EXPECT_EQ(first.openings_m[cup], agent::cup_off_m);
  acted(*world, agent::cup_off_m, 4);
  EXPECT_TRUE(world->watch().items().empty()) << "off, it touches nothing";

  const agent::Observation taken = acted(*world, 0, 2);
  EXPECT_EQ(taken.sealed, (std::vector<std::uint8_t>{0, 1}));
  EXPECT_EQ(taken.openings_m[cup], 0);
  ASSERT_TRUE(world->watch().items().contains(0));
  EXPECT_EQ(world->watch().items().at(0).held_by, static_cast<int>(cup));
  EXPECT_EQ(world->sealed_products()[cup], 0U);

  EXPECT_EQ(acted(*world, 0, 40, 0.03).sealed[cup], 1);  // 6 cm up
  EXPECT_GT(world->world().product_pose(0).position.z, HandMadeScene::upper_board_m + 0.04);
  EXPECT_EQ(world->watch().items().at(0).held_by, static_cast<int>(cup));
  EXPECT_EQ(world->watch().effects().hard_contacts, 0);

  const agent::Observation left = acted(*world, agent::cup_off_m, 20);
  EXPECT_EQ(left.sealed[cup], 0);
  const episodes::EpisodeWatch::Item& can = world->watch().items().at(0);
  EXPECT_EQ(can.held_by, -1);
  EXPECT_EQ(can.touched_by, -1);
  EXPECT_TRUE(can.was_held);
  EXPECT_LT(world->world().product_pose(0).position.z, HandMadeScene::upper_board_m + 0.03);
}

TEST(AisleTools, ACupTooHighTakesNothing) {
  const auto world = over_the_can(0.008);
  EXPECT_EQ(acted(*world, 0, 4).sealed[cup], 0);
  EXPECT_TRUE(world->watch().items().empty());
}

TEST(AisleTools, AtTheEndTheCupLetsGo) {
  const auto world = over_the_can();
  acted(*world, 0, 4);
  ASSERT_TRUE(world->sealed_products()[cup].has_value());
  ASSERT_TRUE(world->finish().ok());
  EXPECT_FALSE(world->sealed_products()[cup].has_value());
}

TEST(AisleTools, WhatIsCarriedOffAndLetGoHasStrayed) {
  const auto left = over_the_can(), carried = over_the_can();
  acted(*left, 0, 10);
  EXPECT_EQ(left->finish()->side_effects.strayed, 0);
  acted(*carried, 0, 4);
  acted(*carried, 0, 40, 0.03);
  agent::Action back = episodes::still_action(carried->observe());
  back.tools[cup].opening_m = 0;
  back.drive_m_s = -0.2;
  for (int i = 0; i < 40; ++i)
    ASSERT_TRUE(carried->step(back).ok());
  ASSERT_TRUE(carried->sealed_products()[cup].has_value());
  EXPECT_GE(carried->finish()->side_effects.strayed, 1);
}

TEST(AisleTools, RepeatsBitForBit) {
  const auto once = over_the_can(), again = over_the_can();
  for (const auto* world : {&once, &again})
    acted(**world, 0, 10, 0.03);
  EXPECT_EQ(once->state_hash(), again->state_hash());
}

}  // namespace
}  // namespace marketgen
