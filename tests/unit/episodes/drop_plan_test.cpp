// The way of a held item into the basket that its robot carries.
#include "skills/drop_plan.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "episodes/aisle/studied_grasps.h"
#include "support/can_aisle.h"
#include "support/committed_robot.h"

namespace marketgen {
namespace {

// A can in the left hand of a robot that stands in the middle of the room, arms as it drives.
struct CanInHand {
  std::shared_ptr<const episodes::AisleStore> store = can_aisle();
  assets::ProductBody can;
  skills::DropQuestion question;

  CanInHand() {
    const catalog::Product& product =
        *std::ranges::find(store->scene.catalog, "can-cola", &catalog::Product::sku);
    can = assets::make_product_body(product).value();
    const auto grasps = episodes::studied_grasps(
                            product,
                            robots::load_grasp_tool(committed_rows, "parallel-gripper").value(),
                            committed_catalog().frictions,
                            {})
                            .value();
    question.state = store->driving;
    question.world_from_base = {{2.0, 1.6, 0}, {}};
    question.group = "left_arm";
    for (std::size_t t = 0; t < robot().tools.size(); ++t)
      if (robot().tools[t].frame == robot().find_group("left_arm")->tip)
        question.tool = static_cast<int>(t);
    question.held = &can;
    question.tip_from_product = inverse(grasps.front().grasp.product_from_tool);
    for (const int dof : arm())
      question.stow.push_back(store->driving[static_cast<std::size_t>(dof)]);
  }

  const robots::Robot& robot() const { return store->robot; }
  const std::vector<int>& arm() const { return robot().find_group(question.group)->dofs; }
  Pose tip_at(const motion::Configuration& q) const {
    std::vector<double> state = question.state;
    for (std::size_t j = 0; j < q.size(); ++j)
      state[static_cast<std::size_t>(arm()[j])] = q[j];
    const int frame = robot().tools[static_cast<std::size_t>(question.tool)].frame;
    return robots::frame_pose(robot(), state, frame);
  }
  // The can where it is let go, in the basket's frame.
  skills::TurnedBox let_go(const Pose& base_from_tip) const {
    return skills::turned_box(
        can, inverse(store->basket.base_from_floor) * base_from_tip * question.tip_from_product);
  }
  // 6 cm high, over all of the basket's floor.
  skills::CarriedItem layer() const {
    const Vec3 size = store->basket.size;
    Pose middle = store->basket.base_from_floor;
    middle.position.z += 0.03;
    return skills::carried_box({middle.position, {size.x / 2, size.y / 2, 0.03}});
  }
};

motion::Configuration end_of(const motion::JointTrajectory& way) {
  return way.at(way.duration_s()).position;
}

TEST(DropPlan, LetsACanDownAndComesHome) {
  const CanInHand hand;
  const auto plan = skills::plan_drop(hand.robot(), hand.store->basket, hand.question, Seed(2));
  ASSERT_TRUE(plan.ok()) << to_string(plan.error());
  const skills::TurnedBox box = hand.let_go(plan->base_from_tip);
  const Vec3 size = hand.store->basket.size;
  EXPECT_LT(std::abs(box.middle.x) + box.half.x, size.x / 2);
  EXPECT_LT(std::abs(box.middle.y) + box.half.y, size.y / 2);
  EXPECT_GT(box.middle.z - box.half.z, 0);
  EXPECT_LT(box.middle.z - box.half.z, 0.05);
  const Pose tip = hand.tip_at(end_of(plan->way));
  EXPECT_LT(length(tip.position - plan->base_from_tip.position), 1e-3);
  EXPECT_EQ(plan->retreat.at(0).position, end_of(plan->way));
  const motion::Configuration home = end_of(plan->home);
  for (std::size_t j = 0; j < home.size(); ++j)
    EXPECT_NEAR(home[j], hand.question.stow[j], 1e-9);
  // The same again, bit for bit.
  const auto again = skills::plan_drop(hand.robot(), hand.store->basket, hand.question, Seed(2));
  EXPECT_EQ(again->way.at(1.0).position, plan->way.at(1.0).position);
}

TEST(DropPlan, WhatLiesThereIsUnderIt) {
  CanInHand hand;
  hand.question.inside = {hand.layer()};
  const auto plan = skills::plan_drop(hand.robot(), hand.store->basket, hand.question, Seed(2));
  ASSERT_TRUE(plan.ok()) << to_string(plan.error());
  const skills::TurnedBox box = hand.let_go(plan->base_from_tip);
  EXPECT_GT(box.middle.z - box.half.z, 0.06);
  EXPECT_LT(box.middle.z - box.half.z, 0.11);
}

// What was left there may have rolled away: the way goes on to the floor, and begins over the rim.
TEST(DropPlan, AWayThatIsFeltGoesDownToTheFloor) {
  for (const bool filled : {false, true}) {
    SCOPED_TRACE(filled);
    CanInHand hand;
    if (filled) hand.question.inside = {hand.layer()};
    const auto plan =
        skills::plan_felt_drop(hand.robot(), hand.store->basket, hand.question, Seed(2));
    ASSERT_TRUE(plan.ok()) << to_string(plan.error());
    const skills::TurnedBox end = hand.let_go(plan->base_from_tip);
    EXPECT_GT(end.middle.z - end.half.z, 0.004);
    EXPECT_LT(end.middle.z - end.half.z, 0.008);
    const skills::TurnedBox begin = hand.let_go(hand.tip_at(end_of(plan->way)));
    EXPECT_GT(begin.middle.z - begin.half.z, hand.store->basket.size.z);
    EXPECT_EQ(plan->down.at(0).position, end_of(plan->way));
    EXPECT_LT(length(hand.tip_at(end_of(plan->down)).position - plan->base_from_tip.position),
              2e-3);
    // Half of the way down it has come upon something, and is left there.
    const motion::Configuration q = plan->down.at(plan->down.duration_s() / 2).position;
    for (std::size_t j = 0; j < q.size(); ++j)
      hand.question.state[static_cast<std::size_t>(hand.arm()[j])] = q[j];
    const auto exit =
        skills::plan_basket_exit(hand.robot(), hand.store->basket, hand.question, Seed(3));
    ASSERT_TRUE(exit.ok()) << to_string(exit.error());
    for (std::size_t j = 0; j < q.size(); ++j) {
      EXPECT_NEAR(exit->retreat.at(0).position[j], q[j], 1e-9);
      EXPECT_NEAR(end_of(exit->home)[j], hand.question.stow[j], 1e-9);
    }
    EXPECT_GT(hand.tip_at(end_of(exit->retreat)).position.z, hand.tip_at(q).position.z + 0.03);
    const auto rise = skills::plan_rise(hand.robot(), hand.store->basket, hand.question, 0.08);
    ASSERT_TRUE(rise.ok()) << to_string(rise.error());
    EXPECT_NEAR(hand.tip_at(end_of(*rise)).position.z, hand.tip_at(q).position.z + 0.08, 1e-3);
  }
}

TEST(DropPlan, ABasketThatIsTooSmallIsAnError) {
  const CanInHand hand;
  skills::CarriedBasket small = hand.store->basket;
  small.size.x = small.size.y = 0.04;
  const auto plan = skills::plan_drop(hand.robot(), small, hand.question, Seed(2));
  ASSERT_FALSE(plan.ok());
  EXPECT_EQ(plan.error().code, "collect.no_drop");
}

}  // namespace
}  // namespace marketgen
