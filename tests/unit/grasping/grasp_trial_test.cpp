// Grasps in physics, and that they can fail: what is slippery, heavy, bent or badly aimed at is
// lost.
#include "grasping/grasp_trial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "support/committed_catalog.h"

namespace marketgen {
namespace {

const catalog::Product& cola() {
  return *committed_catalog().product("beverages-cola-original-330ml");  // 66 mm, 115 mm high
}
const physics::GoodsBody& cola_in(grasping::GraspSetting setting) {
  static std::map<grasping::GraspSetting, physics::SharedGoodsBody> made;
  const auto [found, first] = made.try_emplace(setting);
  if (first) {
    auto body = physics::goods_body(cola(), grasping::use_of(setting));
    if (!body.ok()) fatal(to_string(body.error()).c_str());
    found->second = std::move(body).value();
  }
  return *found->second;
}
const physics::GoodsBody& cola_body() {
  return cola_in(grasping::GraspSetting::free);
}
const robots::GraspTool& tool_row(const std::string& id) {
  static std::map<std::string, robots::GraspTool> tools;
  if (!tools.contains(id)) {
    auto tool = robots::load_grasp_tool(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data", id);
    if (!tool.ok()) fatal(to_string(tool.error()).c_str());
    tools.emplace(id, std::move(tool).value());
  }
  return tools.at(id);
}

// From the front, level, with the pads' middle over the product's axis at that height.
robots::Grasp from_front(const robots::GraspTool& tool, double height_m, double opening_m) {
  const Quaternion ahead = rotation_about({1, 0, 0}, -1.5707963267948966) *
                           rotation_about({0, 0, 1}, 1.5707963267948966);  // Z to +Y, Y to X
  const Vec3 at = Vec3{0, 0, height_m} - rotate(ahead, tool.pad_center);
  return {{at, ahead}, opening_m, tool.force_n};
}

grasping::GraspOutcome outcome_of(const grasping::GraspTrial& trial) {
  const auto outcome = grasping::try_grasp(trial);
  if (!outcome.ok()) fatal(to_string(outcome.error()).c_str());
  return *outcome;
}

// The pads' closing direction is level and across the approach.
TEST(GraspTrials, TheTestsOwnGraspIsLevel) {
  const robots::Grasp grasp = from_front(tool_row("panda-hand"), 0.06, 0.076);
  EXPECT_NEAR(rotate(grasp.product_from_tool.rotation, {0, 0, 1}).y, 1, 1e-12);
  EXPECT_NEAR(std::abs(rotate(grasp.product_from_tool.rotation, {0, 1, 0}).x), 1, 1e-12);
}

TEST(GraspTrials, AGripperCarriesACanAndPutsItDown) {
  for (const char* id : {"panda-hand", "parallel-gripper"}) {
    const robots::GraspTool& tool = tool_row(id);
    const grasping::GraspOutcome outcome =
        outcome_of({cola_body(), tool, from_front(tool, 0.06, 0.076)});
    EXPECT_EQ(name_of(outcome.end), "held") << id << " slip " << outcome.slip_m;
    EXPECT_LE(outcome.slip_m, 0.001) << id;
    EXPECT_NEAR(outcome.squeeze_n, tool.force_n, 0.25 * tool.force_n) << id;
  }
}

TEST(GraspTrials, WithoutFrictionItIsDropped) {
  const robots::GraspTool& hand = tool_row("panda-hand");
  const grasping::GraspOutcome outcome =
      outcome_of({cola_body(), hand, from_front(hand, 0.06, 0.076), 0.01});
  EXPECT_EQ(name_of(outcome.end), "dropped");
}

// 70 N at friction 0.5 bear 7.1 kg at rest.
TEST(GraspTrials, WhatIsTooHeavyIsDropped) {
  const robots::GraspTool& hand = tool_row("panda-hand");
  catalog::Product heavy = cola();
  heavy.mass_kg = 9;
  const physics::SharedGoodsBody body =
      physics::goods_body(heavy, physics::GoodsUse::single).value();
  const grasping::GraspOutcome outcome = outcome_of({*body, hand, from_front(hand, 0.06, 0.076)});
  EXPECT_NE(name_of(outcome.end), "held");
  EXPECT_NE(name_of(outcome.end), "unstable");
}

TEST(GraspTrials, BesideTheCanNothingIsHeld) {
  const robots::GraspTool& hand = tool_row("panda-hand");
  robots::Grasp beside = from_front(hand, 0.06, 0.076);
  beside.product_from_tool.position.y -= 0.08;  // stops in front of it
  EXPECT_EQ(name_of(outcome_of({cola_body(), hand, beside}).end), "missed");
}

TEST(GraspTrials, ThroughTheTableItCollides) {
  const robots::GraspTool& hand = tool_row("panda-hand");
  const grasping::GraspOutcome outcome =
      outcome_of({cola_body(), hand, from_front(hand, 0.015, 0.076)});
  EXPECT_EQ(name_of(outcome.end), "collided");
}

// The cup seals on the end of a can of 200 mm across, not on the side of a 66 mm can; what hangs on
// it must be lighter than it pulls.
TEST(GraspTrials, ACupHoldsWhatItSealsOnAndWhatItsPullBears) {
  const robots::GraspTool& cup = tool_row("suction-cup");
  physics::GoodsBody box = cola_body();
  box.product.size_mm = {100, 80, 100};
  box.product.mass_kg = 0.4;
  box.body = {};
  box.body.pieces.push_back({.shape = assets::PieceShape::box,
                             .center = {0, 0, 0.05F},
                             .half_size = {0.05F, 0.04F, 0.05F}});
  box.body.center_of_mass = {0, 0, 0.05F};
  box.body.inertia_kg_m2 = {0.0006F, 0.0007F, 0.0006F, 0, 0, 0};
  const robots::Grasp front{
      {{0, -0.04, 0.055}, from_front(cup, 0, 0).product_from_tool.rotation}, 0, cup.force_n};
  EXPECT_EQ(name_of(outcome_of({box, cup, front}).end), "held");

  physics::GoodsBody heavy = box;
  heavy.product.mass_kg = 1.4;
  for (float& moment : heavy.body.inertia_kg_m2)
    moment *= 3.5F;
  EXPECT_EQ(name_of(outcome_of({heavy, cup, front}).end), "dropped");

  const robots::Grasp side{{{0, -0.033, 0.06}, front.product_from_tool.rotation}, 0, cup.force_n};
  EXPECT_EQ(name_of(outcome_of({cola_body(), cup, side}).end), "missed");
}

// With a finger's thickness beside it the can comes out clean; with its neighbours 2 to 8 mm away
// an open hand pushes them.
TEST(GraspTrials, NeighboursFeelTheFingers) {
  const robots::GraspTool& hand = tool_row("panda-hand");
  const robots::Grasp grasp = from_front(hand, 0.06, 0.074);
  const grasping::GraspOutcome apart = outcome_of({cola_in(grasping::GraspSetting::spaced),
                                                   hand,
                                                   grasp,
                                                   0.5,
                                                   grasping::GraspSetting::spaced,
                                                   Seed(3)});
  EXPECT_EQ(name_of(apart.end), "held");
  EXPECT_LT(apart.neighbour_n, 5);
  const grasping::GraspOutcome close = outcome_of({cola_in(grasping::GraspSetting::stocked),
                                                   hand,
                                                   grasp,
                                                   0.5,
                                                   grasping::GraspSetting::stocked,
                                                   Seed(3)});
  EXPECT_GT(close.neighbour_n, apart.neighbour_n);
}

// Straight down, closing along the basket's long side, with the pads' middle so far under the top.
robots::Grasp from_above(const robots::GraspTool& tool, double opening_m) {
  const Quaternion down = rotation_about({1, 0, 0}, 3.141592653589793);
  const Vec3 at = Vec3{0, 0, cola().height_m() - 0.025} - rotate(down, tool.pad_center);
  return {{at, down}, opening_m, tool.force_n};
}

TEST(GraspTrials, OutOfABasketFromAbove) {
  const grasping::BasketOfLikes basket{physics::checkout_basket,
                                       {{{0, 0, 0}, {}}, {{0.08, 0.12, 0}, {}}}};
  for (const char* id : {"panda-hand", "parallel-gripper"}) {
    const robots::GraspTool& tool = tool_row(id);
    const grasping::GraspOutcome outcome = outcome_of({cola_in(grasping::GraspSetting::basket),
                                                       tool,
                                                       from_above(tool, 0.076),
                                                       0.5,
                                                       grasping::GraspSetting::basket,
                                                       Seed(1),
                                                       &basket});
    EXPECT_EQ(name_of(outcome.end), "held") << id << " slip " << outcome.slip_m;
    EXPECT_LT(outcome.neighbour_n, 1) << id;
  }
}

// The can stands by the wall behind which the hand would have to be.
TEST(GraspTrials, ThroughTheBasketsWallItCollides) {
  const robots::GraspTool& hand = tool_row("panda-hand");
  const grasping::BasketOfLikes basket{physics::checkout_basket, {{{0, -0.14, 0}, {}}}};
  const grasping::GraspTrial trial{cola_in(grasping::GraspSetting::basket),
                                   hand,
                                   from_front(hand, 0.08, 0.076),
                                   0.5,
                                   grasping::GraspSetting::basket,
                                   Seed(1),
                                   &basket};
  EXPECT_EQ(name_of(outcome_of(trial).end), "collided");
  // Without the wall it is a good grasp.
  EXPECT_EQ(name_of(outcome_of({cola_body(), hand, trial.grasp}).end), "held");
}

TEST(GraspTrials, APackThatDoesNotLieStillInTheBasketIsNotTried) {
  const robots::GraspTool& hand = tool_row("panda-hand");
  const grasping::BasketOfLikes basket{physics::checkout_basket, {{{0, 0, 0.3}, {}}}};  // it falls
  EXPECT_EQ(name_of(outcome_of({cola_in(grasping::GraspSetting::basket),
                                hand,
                                from_above(hand, 0.076),
                                0.5,
                                grasping::GraspSetting::basket,
                                Seed(1),
                                &basket})
                        .end),
            "unstable");
}

TEST(GraspTrials, TheSameSeedIsTheSameToTheBit) {
  const robots::GraspTool& hand = tool_row("panda-hand");
  const grasping::GraspTrial trial{cola_body(), hand, from_front(hand, 0.06, 0.076)};
  const grasping::GraspOutcome once = outcome_of(trial), again = outcome_of(trial);
  EXPECT_EQ(once.slip_m, again.slip_m);
  EXPECT_EQ(once.turned_rad, again.turned_rad);
  EXPECT_EQ(once.squeeze_n, again.squeeze_n);
}

TEST(GraspTrials, WhatCannotBeTriedIsAnError) {
  const robots::GraspTool& hand = tool_row("panda-hand");
  const auto code_of = [&](const physics::GoodsBody& goods, const robots::Grasp& grasp) {
    const auto outcome = grasping::try_grasp({goods, hand, grasp});
    return outcome.ok() ? std::string() : outcome.error().code;
  };
  physics::GoodsBody weightless = cola_body();
  weightless.product.mass_kg = 0;
  EXPECT_EQ(code_of(weightless, from_front(hand, 0.06, 0.07)), "catalog.bad_row");
  EXPECT_EQ(code_of(cola_body(), from_front(hand, 0.06, 0.09)), "motion.bad_configuration");
  robots::Grasp strong = from_front(hand, 0.06, 0.07);
  strong.force_n = 200;
  EXPECT_EQ(code_of(cola_body(), strong), "motion.bad_configuration");

  const auto code_in = [&](const grasping::BasketOfLikes* basket) {
    const auto outcome = grasping::try_grasp({cola_in(grasping::GraspSetting::basket),
                                              hand,
                                              from_above(hand, 0.07),
                                              0.5,
                                              grasping::GraspSetting::basket,
                                              Seed(1),
                                              basket});
    return outcome.ok() ? std::string() : outcome.error().code;
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const grasping::BasketOfLikes empty{physics::checkout_basket, {}},
      nowhere{physics::checkout_basket, {{{nan, 0, 0}, {}}}};
  grasping::BasketOfLikes broken{physics::checkout_basket, {{}}};
  broken.container.top_x_m = nan;
  EXPECT_EQ(code_in(nullptr), "motion.bad_configuration");
  EXPECT_EQ(code_in(&empty), "motion.bad_configuration");
  EXPECT_EQ(code_in(&nowhere), "motion.bad_configuration");
  EXPECT_EQ(code_in(&broken), "physics.bad_command");
}

}  // namespace
}  // namespace marketgen
