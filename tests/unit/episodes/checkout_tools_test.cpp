// Checkout Unloading with a gripper and a suction cup: which goods each takes, that the cup takes
// and lets go as it is told, and that what it holds is known to be held.
#include <gtest/gtest.h>

#include <algorithm>

#include "episodes/checkout/checkout_refusal.h"
#include "grasping/grasp_study.h"
#include "motion/grasp_candidates.h"
#include "robots/self_collision.h"
#include "support/cup_pack.h"

namespace marketgen {
namespace {

episodes::CheckoutRefusal refusal_of(const catalog::Product& product) {
  return taken_from(episodes::cup_refusal(product, counter_cup(), 0.5));
}

TEST(CheckoutTools, TheGripperComesFirst) {
  const auto gripper = taken_from(episodes::load_checkout_station(data_rows()));
  EXPECT_EQ(gripper.tools().id, "gripper");
  const episodes::CheckoutWorld world = world_with("suction");
  EXPECT_EQ(world.station().tools().id, "suction");
  ASSERT_EQ(world.robot().tools.size(), 1U);
  EXPECT_EQ(world.robot().tools.front().kind, robots::ToolKind::suction);
  EXPECT_EQ(world.robot().find_group("arm")->tip, world.robot().tools.front().frame);
  EXPECT_GE(world.robot().find_link("hand"), 0) << "the wrist camera is on it";
}

TEST(CheckoutTools, TheArmWithACupIsFreeAsItBegins) {
  const episodes::CheckoutWorld world = world_with("suction");
  const auto pairs = robots::pairs_that_may_touch(world.robot());
  const auto q = episodes::ready_state(world.station(), world.robot());
  EXPECT_FALSE(robots::first_contact(world.robot(), robots::link_poses(world.robot(), q), pairs)
                   .has_value());
}

TEST(CheckoutTools, OtherToolsThanTheStationsAreErrors) {
  const auto unknown =
      episodes::load_checkout_station(data_rows(), episodes::checkout_station, "suctoin");
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.error().code, "robot.unknown");
  EXPECT_NE(unknown.error().message.find("suction"), std::string::npos);
  episodes::CheckoutWorld world = world_with("suction");
  episodes::EpisodeSpec spec = pool_file().episodes.front();
  spec.lane.reset();
  EXPECT_EQ(world.reset(spec, pool_file().header.products).error().code, "robot.unknown")
      << "an episode for a gripper";
  spec.tools = "suction";
  EXPECT_TRUE(world.reset(spec, pool_file().header.products).ok());
}

TEST(CheckoutTools, TheCupTakesWhatIsTooWideOrTooFlatForFingers) {
  catalog::Product pack = box_pack();
  pack.size_mm = {150, 30, 200};
  EXPECT_EQ(episodes::checkout_refusal(pack), episodes::CheckoutRefusal::too_wide);
  EXPECT_EQ(refusal_of(pack), episodes::CheckoutRefusal::none);
}

TEST(CheckoutTools, WhatTheCupRefusesSaysWhy) {
  catalog::Product pack = box_pack();
  pack.mass_kg = 2;
  EXPECT_EQ(refusal_of(pack), episodes::CheckoutRefusal::too_heavy);
  pack.mass_kg = 0.3;
  pack.size_mm = {20, 20, 100};
  EXPECT_EQ(refusal_of(pack), episodes::CheckoutRefusal::no_seal) << "narrower than the lip";
  pack.size_mm = {400, 200, 500};
  EXPECT_EQ(refusal_of(pack), episodes::CheckoutRefusal::too_large);
  pack = box_pack();
  pack.rigidity = catalog::Rigidity::soft;
  EXPECT_EQ(refusal_of(pack), episodes::CheckoutRefusal::soft);
}

// Both are bread in film: a dense block, and slices that are full of air.
TEST(CheckoutTools, TheCupTakesSoftPacksThatAreFirm) {
  const auto row = [](std::string_view sku) {
    return *std::ranges::find(committed_catalog().products, sku, &catalog::Product::sku);
  };
  EXPECT_EQ(refusal_of(row("bakery-pumpernickel-375g")), episodes::CheckoutRefusal::none);
  EXPECT_EQ(refusal_of(row("bakery-toast-bread-wheat-500g")), episodes::CheckoutRefusal::soft);
}

TEST(CheckoutTools, AHandKnowsWhatItTakesOfTheProductsItWasMadeFor) {
  catalog::Product wide = box_pack(), heavy = box_pack();
  heavy.sku = "heavy";
  heavy.mass_kg = 2;
  const auto& frictions = committed_catalog().frictions;
  const auto with_cup =
      taken_from(episodes::checkout_hand(data_rows(), frictions, {wide, heavy}, "suction"));
  EXPECT_EQ(with_cup.tools, "suction");
  EXPECT_TRUE(with_cup.takes(wide));
  EXPECT_FALSE(with_cup.takes(heavy));
  const auto with_fingers =
      taken_from(episodes::checkout_hand(data_rows(), frictions, {wide}, "gripper"));
  EXPECT_EQ(with_fingers.tools, "") << "episodes of before have none";
  EXPECT_FALSE(with_fingers.takes(wide));
}

// ---- In physics: a pack that begins right under the lip, high over the counter. ----

agent::Observation acted_at_counter(episodes::CheckoutWorld& world, double opening_m, int steps) {
  agent::Action action = episodes::still_action(world.observe());
  action.tools.front().opening_m = opening_m;
  agent::Observation seen;
  for (int i = 0; i < steps; ++i)
    seen = taken_from(world.step(action));
  return seen;
}

TEST(CheckoutTools, TheCupHoldsAPackAndLetsGoAtTheStop) {
  episodes::CheckoutWorld world = world_with("suction");
  const catalog::Product pack = box_pack();
  const auto reset = world.reset(under_the_lip(world, pack), {pack});
  ASSERT_TRUE(reset.ok()) << to_string(reset.error());
  EXPECT_EQ(world.observe().openings_m.front(), agent::cup_off_m);
  const double before = world.item_pose(0).position.z;
  const agent::Observation seen = acted_at_counter(world, 0, 20);
  EXPECT_EQ(seen.sealed, (std::vector<std::uint8_t>{1}));
  EXPECT_EQ(seen.openings_m.front(), 0);
  EXPECT_EQ(world.watched(0).held_by, 0);
  EXPECT_NEAR(world.item_pose(0).position.z, before, 0.01);
  const auto kept = world.save();
  ASSERT_TRUE(world.restore(kept).ok());
  EXPECT_EQ(world.watched(0).held_by, 0);
  ASSERT_TRUE(world.finish().ok());
  EXPECT_LT(world.item_pose(0).position.z, before - 0.05) << "it fell";
  EXPECT_EQ(world.watched(0).held_by, -1);
}

TEST(CheckoutTools, ACupThatIsOffHoldsNothing) {
  episodes::CheckoutWorld world = world_with("suction");
  const catalog::Product pack = box_pack();
  ASSERT_TRUE(world.reset(under_the_lip(world, pack), {pack}).ok());
  const double before = world.item_pose(0).position.z;
  const agent::Observation seen = acted_at_counter(world, agent::cup_off_m, 10);
  EXPECT_EQ(seen.sealed, (std::vector<std::uint8_t>{0}));
  EXPECT_LT(world.item_pose(0).position.z, before - 0.05);
}

TEST(CheckoutTools, WhatTheCupTookItHoldsInATwinToo) {
  episodes::CheckoutWorld world = world_with("suction");
  const catalog::Product pack = box_pack();
  ASSERT_TRUE(world.reset(under_the_lip(world, pack), {pack}).ok());
  acted_at_counter(world, 0, 5);
  const auto twin = taken_from(world.twin());
  ASSERT_TRUE(twin->restore(world.save()).ok());
  acted_at_counter(world, 0, 10);
  acted_at_counter(*twin, 0, 10);
  EXPECT_EQ(world.state_hash(), twin->state_hash());
  EXPECT_EQ(twin->watched(0).held_by, 0);
}

}  // namespace
}  // namespace marketgen
