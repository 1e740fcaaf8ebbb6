// Goals of Checkout Unloading on states made by hand.
#include "episodes/checkout/checkout_goals.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

const episodes::AreaRow area{{0, 0}, {0.4, 0.4}, {}};
constexpr double basket_floor_m = 0.003;

episodes::HoldsPoint with_basket_at(double x, double y, double turned = 0) {
  return episodes::over_area(
      area,
      {physics::checkout_basket, {{x, y, basket_floor_m}, rotation_about({0, 0, 1}, turned)}});
}
const episodes::HoldsPoint beside_basket = with_basket_at(-0.5, 0.2);

// A box of 6 x 6 x 10 cm that stands with its middle over the point.
episodes::ItemState standing_box(double x, double y, const std::string& sku = "tea") {
  episodes::ItemState item;
  item.sku = sku;
  item.pose.position = {x, y, 0};
  item.center_of_mass = {0, 0, 0.05};
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      item.volume.push_back({i * 0.012, j * 0.012, 0.05});
  item.rested_s = 2;
  return item;
}

episodes::EpisodeOutcome judged(const std::vector<episodes::ItemState>& items,
                                double tilt_deg = 0) {
  return episodes::judge_checkout(beside_basket, {{"tea", 1}, {"rice", 1}}, items, tilt_deg);
}

TEST(CheckoutGoals, AnItemAtRestInTheAreaIsInPlace) {
  EXPECT_TRUE(episodes::is_in_place(beside_basket, standing_box(0.2, 0.2)));
}

TEST(CheckoutGoals, HalfOutIsOutWhenItsMiddleIs) {
  EXPECT_TRUE(
      episodes::is_in_place(beside_basket, standing_box(0.39, 0.2)));  // 3 of 5 columns inside
  EXPECT_FALSE(episodes::is_in_place(beside_basket, standing_box(0.41, 0.2)));
  episodes::ItemState leaning =
      standing_box(0.39, 0.2);  // its middle inside, most of its volume out
  for (Vec3& point : leaning.volume)
    point.x += 0.03;
  EXPECT_FALSE(episodes::is_in_place(beside_basket, leaning));
}

TEST(CheckoutGoals, MovingTouchedAndThrownItemsAreNotInPlace) {
  episodes::ItemState moving = standing_box(0.2, 0.2), touched = moving, thrown = moving;
  moving.rested_s = 0.5;
  touched.touched = true;
  thrown.impact_m_s = 1.2;
  EXPECT_FALSE(episodes::is_in_place(beside_basket, moving));
  EXPECT_FALSE(episodes::is_in_place(beside_basket, touched));
  EXPECT_FALSE(episodes::is_in_place(beside_basket, thrown));
}

// Of two of a product that both count, the one that came last; of three, the two that came first.
TEST(CheckoutGoals, AGoalIsMetSinceTheLastOfItsItemsCameToRest) {
  std::vector<episodes::ItemState> items{standing_box(0.1, 0.1), standing_box(0.2, 0.2)};
  items[0].rested_s = 9, items[1].rested_s = 4;
  const auto met = [&] {
    return episodes::judge(beside_basket, {{"tea", 2}, {"rice", 1}}, items).goals;
  };
  EXPECT_EQ(met()[0].rested_s, 4);
  EXPECT_EQ(met()[1].rested_s, 0) << "none is there";
  items.push_back(standing_box(0.3, 0.3));
  items[2].rested_s = 2;
  EXPECT_EQ(met()[0].rested_s, 4);
}

TEST(CheckoutGoals, UnderTheCounterIsNotInPlace) {
  episodes::ItemState fallen = standing_box(0.2, 0.2);
  fallen.pose.position.z = -0.88;
  EXPECT_FALSE(episodes::is_in_place(beside_basket, fallen));
}

// A basket that was pushed onto the area takes what it holds along.
TEST(CheckoutGoals, WhatIsStillInTheBasketIsNotUnloaded) {
  episodes::ItemState tea = standing_box(0.2, 0.2);
  tea.pose.position.z = basket_floor_m;
  EXPECT_FALSE(episodes::is_in_place(with_basket_at(0.2, 0.2), tea));
  EXPECT_FALSE(episodes::is_in_place(with_basket_at(0.2, 0.2, 0.4), tea));
  EXPECT_TRUE(episodes::is_in_place(with_basket_at(0.2 - 0.30, 0.2), tea))
      << "it stands beside its wall";
  episodes::ItemState heaped = tea;  // on other goods, its middle above the rim
  heaped.pose.position.z = 0.14;
  EXPECT_FALSE(episodes::is_in_place(with_basket_at(0.2, 0.2), heaped));
  const episodes::EpisodeOutcome outcome = episodes::judge_checkout(
      with_basket_at(0.2, 0.2), {{"tea", 1}}, {tea, standing_box(0.25, 0.25, "soap")}, 0);
  EXPECT_EQ(outcome.hits, 0);
  EXPECT_EQ(outcome.wrong, 0) << "what lies in the basket is not in the area, goal or not";
}

TEST(CheckoutGoals, UnderTheLeaningWallIsOutOfTheBasket) {
  // 0.15 - 0.02 m from its middle at the floor, 0.15 m at the rim
  const auto basket = with_basket_at(0.2, 0.2);
  EXPECT_TRUE(basket({0.2 + 0.14, 0.2, 0.01}));
  EXPECT_FALSE(basket({0.2 + 0.14, 0.2, 0.14}));
}

TEST(CheckoutGoals, EachGoalCountsOnce) {
  const episodes::EpisodeOutcome outcome =
      judged({standing_box(0.2, 0.2), standing_box(0.9, 0.2, "rice")});
  EXPECT_EQ(outcome.asked, 2);
  EXPECT_EQ(outcome.hits, 1);
  EXPECT_EQ(outcome.goals[0].reached, 1);
  EXPECT_EQ(outcome.goals[1].reached, 0);
  EXPECT_EQ(outcome.wrong, 0);
}

TEST(CheckoutGoals, AWrongItemCancelsAHit) {
  const episodes::EpisodeOutcome outcome = judged(
      {standing_box(0.1, 0.1), standing_box(0.2, 0.2, "rice"), standing_box(0.3, 0.3, "soap")});
  EXPECT_EQ(outcome.wrong, 1);
  EXPECT_EQ(outcome.hits, 1);
}

TEST(CheckoutGoals, MoreThanWereAskedForIsWrong) {
  const episodes::EpisodeOutcome outcome = judged({standing_box(0.1, 0.1), standing_box(0.3, 0.3)});
  EXPECT_EQ(outcome.wrong, 1);
  EXPECT_EQ(outcome.hits, 0);
}

TEST(CheckoutGoals, ATiltedBasketIsVoid) {
  const std::vector<episodes::ItemState> items{standing_box(0.1, 0.1),
                                               standing_box(0.3, 0.3, "rice")};
  EXPECT_EQ(judged(items, 14).hits, 2);
  const episodes::EpisodeOutcome tilted = judged(items, 16);
  EXPECT_TRUE(tilted.is_void);
  EXPECT_EQ(tilted.hits, 0);
}

}  // namespace
}  // namespace marketgen
