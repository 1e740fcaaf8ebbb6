// Baskets as they are drawn, and the world that they are put in: at rest, repeatable, watched.
#include "episodes/checkout/checkout_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "episodes/check_episodes.h"
#include "support/drawn_checkout.h"

namespace marketgen {
namespace {

template <class T>
T value_of(Result<T> result) {
  if (!result.ok()) fatal(to_string(result.error()).c_str());
  return std::move(result).value();
}

episodes::EpisodeSpec drawn_in_corner(std::uint64_t seed, int index = 0) {
  return value_of(episodes::sample_checkout(data_rows(),
                                            checkout_goods_rows(),
                                            committed_catalog().frictions,
                                            {"corner", "scene", "plan"},
                                            Seed(seed),
                                            index));
}

episodes::CheckoutWorld world_of(const episodes::EpisodeSpec& spec) {
  episodes::CheckoutWorld world =
      value_of(episodes::CheckoutWorld::create(data_rows(), committed_catalog().frictions));
  const auto reset = world.reset(spec, checkout_goods_rows());
  if (!reset.ok()) fatal(to_string(reset.error()).c_str());
  return world;
}

agent::Action waiting(const episodes::CheckoutWorld& world) {
  return episodes::still_action(world.observe());
}

// To and fro over the basket.
std::vector<agent::Action> swaying(const episodes::CheckoutWorld& world, int steps) {
  std::vector<agent::Action> actions;
  for (int i = 0; i < steps; ++i) {
    actions.push_back(waiting(world));
    actions.back().position[0] += 0.3 * std::sin(i * 0.1);
    actions.back().position[1] += 0.02 * i;
    actions.back().tools.front().opening_m = i % 7 == 0 ? 0 : 0.06;
  }
  return actions;
}

void perform(episodes::CheckoutWorld& world, std::span<const agent::Action> actions) {
  for (const agent::Action& action : actions)
    value_of(world.step(action));
}

TEST(SampleCheckout, ItemsLieAtRestInTheBasketAndApart) {
  for (int index = 0; index < 3; ++index) {
    const episodes::EpisodeSpec spec = drawn_in_corner(7, index);
    episodes::CheckoutWorld world = world_of(spec);
    EXPECT_GE(spec.goals.size(), 2U);
    EXPECT_LE(spec.goals.size(), 4U);
    EXPECT_GE(spec.items.size(), spec.goals.size() + 4);
    std::vector<Vec3> before;
    for (std::size_t i = 0; i < world.item_count(); ++i)
      before.push_back(world.item_pose(i).position);
    perform(world, std::vector<agent::Action>(1, waiting(world)));
    EXPECT_LE(world.deepest_overlap_m(), 0.002);
    perform(world, std::vector<agent::Action>(19, waiting(world)));
    const physics::OpenContainer basket = world.station().container();
    for (std::size_t i = 0; i < world.item_count(); ++i) {
      const Pose pose = inverse(world.basket_pose()) * world.item_pose(i);
      const Vec3 middle = pose * to_double(world.goods(i).body.center_of_mass);
      EXPECT_LT(std::abs(middle.x), basket.top_x_m / 2) << spec.items[i].sku;
      EXPECT_LT(std::abs(middle.y), basket.top_y_m / 2) << spec.items[i].sku;
      EXPECT_LT(length(world.item_pose(i).position - before[i]), 0.003) << spec.items[i].sku;
      EXPECT_LT(world.watched(i).speed_m_s, 0.02) << spec.items[i].sku;
    }
    EXPECT_LE(world.deepest_overlap_m(), 0.002);
  }
}

TEST(SampleCheckout, TheSameSeedGivesTheSameBytes) {
  const episodes::EpisodeFile one{{}, {drawn_in_corner(3)}}, again{{}, {drawn_in_corner(3)}},
      other{{}, {drawn_in_corner(4)}};
  EXPECT_EQ(episodes::write_episodes(one), episodes::write_episodes(again));
  EXPECT_NE(episodes::write_episodes(one), episodes::write_episodes(other));
}

// A quarter has two of a goal, half something that is easily taken for one: of 24 about 6 and 12.
TEST(SlowSampleCheckout, CountsAndLookAlikesAreThereAsOftenAsIsSaid) {
  int with_two = 0, with_alike = 0;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    const episodes::EpisodeSpec spec = drawn_in_corner(100 + seed);
    with_two += std::ranges::count(spec.goals, 2, &episodes::EpisodeGoal::count) > 0 ? 1 : 0;
    with_alike += spec.look_alikes ? 1 : 0;
    EXPECT_LE(spec.items.size(), 12U);
    for (const episodes::EpisodeGoal& goal : spec.goals) {
      EXPECT_EQ(std::ranges::count(spec.items, goal.sku, &episodes::EpisodeItem::sku), goal.count);
      EXPECT_TRUE(goal.text && spec.instruction.find(*goal.text) != std::string::npos);
      EXPECT_EQ(spec.instruction.find(goal.sku), std::string::npos);
    }
    EXPECT_TRUE(episodes::check_episode(spec, spec.id).ok());
  }
  std::printf("of 24: %d with two of a goal, %d with look-alikes\n", with_two, with_alike);
  EXPECT_GE(with_two, 2);
  EXPECT_LE(with_two, 12);
  EXPECT_GE(with_alike, 7);
  EXPECT_LE(with_alike, 18);
}

TEST(SampleCheckout, TooFewKindsOfGoodsIsAnError) {
  const std::vector<catalog::Product> few(checkout_goods_rows().begin(),
                                          checkout_goods_rows().begin() + 1);
  const auto made = episodes::sample_checkout(
      data_rows(), few, committed_catalog().frictions, {"kiosk", "scene", "plan"}, Seed(1), 0);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, "episode.impossible");
}

TEST(CheckoutWorld, TheSameActionsGiveTheSameState) {
  const episodes::EpisodeSpec spec = drawn_in_corner(7);
  episodes::CheckoutWorld one = world_of(spec), again = world_of(spec);
  EXPECT_EQ(one.state_hash(), again.state_hash());
  const std::vector<agent::Action> actions = swaying(one, 40);
  perform(one, actions);
  perform(again, actions);
  EXPECT_EQ(one.state_hash(), again.state_hash());
  ASSERT_TRUE(again.reset(spec, checkout_goods_rows()).ok());  // a world may be used again
  perform(again, actions);
  EXPECT_EQ(one.state_hash(), again.state_hash());
}

TEST(CheckoutWorld, GoingOnFromASavedMomentGivesTheSameState) {
  episodes::CheckoutWorld world = world_of(drawn_in_corner(7));
  const std::vector<agent::Action> actions = swaying(world, 40);
  perform(world, std::span(actions).first(20));
  const std::string moment = world.save();
  perform(world, std::span(actions).subspan(20));
  const std::string end = world.state_hash();
  ASSERT_TRUE(world.restore(moment).ok());
  EXPECT_EQ(world.steps(), 20);
  perform(world, std::span(actions).subspan(20));
  EXPECT_EQ(world.state_hash(), end);
  episodes::CheckoutWorld other = world_of(drawn_in_corner(7));
  ASSERT_TRUE(other.restore(moment).ok());
  EXPECT_EQ(other.save(), moment);
  perform(other, std::span(actions).subspan(20));
  EXPECT_EQ(other.state_hash(), end);
}

TEST(CheckoutWorld, ATwinGoesOnAsTheWorldItselfWould) {
  episodes::CheckoutWorld world = world_of(drawn_in_corner(7));
  const std::vector<agent::Action> actions = swaying(world, 20);
  perform(world, std::span(actions).first(10));
  const std::string before = world.state_hash();
  const auto twin = world.twin();
  ASSERT_TRUE(twin.ok()) << to_string(twin.error());
  ASSERT_TRUE((*twin)->restore(world.save()).ok());
  perform(**twin, std::span(actions).subspan(10));
  EXPECT_EQ(world.state_hash(), before) << "the world itself stays as it is";
  perform(world, std::span(actions).subspan(10));
  EXPECT_EQ((*twin)->state_hash(), world.state_hash());
}

TEST(CheckoutWorld, MomentsOfOtherEpisodesAndHalvesOfOnesAreErrors) {
  episodes::CheckoutWorld world = world_of(drawn_in_corner(7));
  const std::string whole = world.save(), before = world.state_hash();
  const std::string other = world_of(drawn_in_corner(8)).save();
  for (const std::string& moment :
       {std::string(), other, whole.substr(0, whole.size() / 2), whole + "x"}) {
    const auto restored = world.restore(moment);
    ASSERT_FALSE(restored.ok());
    EXPECT_EQ(restored.error().code, "physics.bad_command");
    EXPECT_EQ(world.state_hash(), before);
  }
}

TEST(CheckoutWorld, NothingDoneReachesNothing) {
  episodes::CheckoutWorld world = world_of(drawn_in_corner(7));
  agent::Action stop = waiting(world);
  stop.stop = true;
  value_of(world.step(stop));
  EXPECT_TRUE(world.done());
  const episodes::EpisodeResult result = value_of(world.finish());
  EXPECT_EQ(result.success_partial, 0);
  EXPECT_FALSE(result.success_strict);
  EXPECT_EQ(result.side_effects.hard_contacts, 0);
  EXPECT_EQ(result.side_effects.displaced, 0);
  EXPECT_EQ(result.side_effects.strayed, 0);
  EXPECT_NEAR(result.simulated_s, 2, 0.1);
}

// In the far corner of the counter nobody has use for it; beside the basket it may be set aside.
TEST(CheckoutWorld, WhatLiesInNoAreaHasStrayed) {
  for (const auto& [x, y, strayed] : {std::tuple{0.79, 0.85, 1}, std::tuple{0.40, 0.60, 0}}) {
    episodes::EpisodeSpec spec = drawn_in_corner(7);
    const auto other = std::ranges::find_if(spec.items, [&](const episodes::EpisodeItem& item) {
      return std::ranges::count(spec.goals, item.sku, &episodes::EpisodeGoal::sku) == 0;
    });
    ASSERT_NE(other, spec.items.end());
    const Vec3 basket = world_of(spec).basket_pose().position;
    *other = {other->sku, {x - basket.x, y - basket.y, 0.001 - basket.z}};
    episodes::CheckoutWorld world = world_of(spec);
    EXPECT_EQ(value_of(world.finish()).side_effects.strayed, strayed) << x << " " << y;
  }
}

TEST(CheckoutWorld, PressingOnTheCounterIsAHardContact) {
  episodes::CheckoutWorld world = world_of(drawn_in_corner(7));
  agent::Action down = waiting(world);
  for (int i = 0; i < 60; ++i) {
    down.position[0] = -0.8;  // away from the basket
    down.position[1] += 0.025;
    value_of(world.step(down));
  }
  EXPECT_GT(world.watch().effects().hard_contacts, 0);
  EXPECT_GT(world.watch().effects().hardest_n, 50);
}

TEST(CheckoutWorld, RefusesBadActions) {
  episodes::CheckoutWorld world = world_of(drawn_in_corner(7));
  const std::string before = world.state_hash();
  agent::Action nan = waiting(world), short_one = nan, late = nan;
  nan.position[2] = std::numeric_limits<double>::quiet_NaN();
  short_one.position.pop_back();
  for (const agent::Action& bad : {nan, short_one}) {
    const auto stepped = world.step(bad);
    ASSERT_FALSE(stepped.ok());
    EXPECT_EQ(stepped.error().code, "episode.bad_action");
  }
  EXPECT_EQ(world.state_hash(), before);
  late.stop = true;
  value_of(world.step(late));
  ASSERT_FALSE(world.step(late).ok());
}

TEST(CheckoutWorld, UnknownGoodsAndOtherRobotsAreErrors) {
  episodes::CheckoutWorld world =
      value_of(episodes::CheckoutWorld::create(data_rows(), committed_catalog().frictions));
  episodes::EpisodeSpec spec = drawn_in_corner(7);
  const auto reset = world.reset(spec, {});
  ASSERT_FALSE(reset.ok());
  EXPECT_EQ(reset.error().code, "catalog.unknown_sku");
  spec.robot = "realman-rm75";
  EXPECT_EQ(world.reset(spec, checkout_goods_rows()).error().code, "robot.unknown");
}

// The arm leans on the counter until it is stopped, and goes on when it is told away from it.
TEST(CheckoutWorld, AnArmThatPressesTooHardIsStoppedAndGoesOnAfterThePause) {
  episodes::CheckoutWorld world = world_of(drawn_in_corner(5));
  constexpr std::size_t shoulder = 1;
  agent::Action lean = waiting(world);
  const std::vector<double> upright = lean.position;
  lean.position[0] -= 1;  // beside the basket
  double told_n = 0;
  for (int i = 0; i < 400 && !world.observe().stopped; ++i) {
    EXPECT_TRUE(i > 40 || world.observe().external_force_n.at(0) == 0) << "nothing is there";
    if (i > 40) lean.position[shoulder] += 0.02;
    ASSERT_TRUE(world.step(lean).ok());
    told_n = std::max(told_n, world.observe().external_force_n.at(0));
  }
  ASSERT_TRUE(world.observe().stopped);
  EXPECT_GT(told_n, 10);
  EXPECT_LE(told_n, world.controller().max_force_n());
  EXPECT_EQ(world.controller().stops(), 1);
  EXPECT_GT(world.controller().max_force_n(), world.robot().contact_limits.at(0).force);
  const std::vector<double> at_stop = world.observe().position;
  agent::Action away = lean;
  away.position[shoulder] = upright[shoulder];
  for (int i = 0; i < 8; ++i)  // 0.4 of the 0.5 s
    ASSERT_TRUE(world.step(away).ok());
  const std::vector<double> still = world.observe().position;
  for (std::size_t j = 0; j < still.size(); ++j)
    EXPECT_NEAR(still[j], at_stop[j], 0.05) << j;
  for (int i = 0; i < 60; ++i)
    ASSERT_TRUE(world.step(away).ok());
  EXPECT_FALSE(world.observe().stopped);
  EXPECT_NEAR(world.observe().position[shoulder], upright[shoulder], 0.02);
  const auto result = world.finish();
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->side_effects.protective_stops, 1);
  EXPECT_FALSE(episodes::is_clean(result->side_effects));
}

}  // namespace
}  // namespace marketgen
