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
  skills::TurnedBox let_go(const skills::DropPlan& plan) const {
    return skills::turned_box(
        can,
        inverse(store->basket.base_from_floor) * plan.base_from_tip * question.tip_from_product);
  }
};

motion::Configuration end_of(const motion::JointTrajectory& way) {
  return way.at(way.duration_s()).position;
}

TEST(DropPlan, LetsACanDownAndComesHome) {
  const CanInHand hand;
  const auto plan = skills::plan_drop(hand.robot(), hand.store->basket, hand.question, Seed(2));
  ASSERT_TRUE(plan.ok()) << to_string(plan.error());
  const skills::TurnedBox box = hand.let_go(*plan);
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
  const Vec3 size = hand.store->basket.size;
  Pose middle = hand.store->basket.base_from_floor;
  middle.position.z += 0.03;
  hand.question.inside = {skills::carried_box({middle.position, {size.x / 2, size.y / 2, 0.03}})};
  const auto plan = skills::plan_drop(hand.robot(), hand.store->basket, hand.question, Seed(2));
  ASSERT_TRUE(plan.ok()) << to_string(plan.error());
  const skills::TurnedBox box = hand.let_go(*plan);
  EXPECT_GT(box.middle.z - box.half.z, 0.06);
  EXPECT_LT(box.middle.z - box.half.z, 0.11);
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
