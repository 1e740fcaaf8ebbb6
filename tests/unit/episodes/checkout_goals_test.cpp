// Goals of Checkout Unloading on states made by hand.
#include "episodes/checkout_goals.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

const AreaRow area{{0, 0}, {0.4, 0.4}, {}};

// A box of 6 x 6 x 10 cm that stands with its middle over the point.
ItemState standing_box(double x, double y, const std::string& sku = "tea") {
  ItemState item;
  item.sku = sku;
  item.pose.position = {x, y, 0};
  item.center_of_mass = {0, 0, 0.05};
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      item.volume.push_back({i * 0.012, j * 0.012, 0.05});
  item.rested_s = 2;
  return item;
}

EpisodeOutcome judged(const std::vector<ItemState>& items, double tilt_deg = 0) {
  return judge_checkout(area, {{"tea", 1}, {"rice", 1}}, items, tilt_deg);
}

TEST(CheckoutGoals, AnItemAtRestInTheAreaIsInPlace) {
  EXPECT_TRUE(is_in_place(over_area(area), standing_box(0.2, 0.2)));
}

TEST(CheckoutGoals, HalfOutIsOutWhenItsMiddleIs) {
  EXPECT_TRUE(is_in_place(over_area(area), standing_box(0.39, 0.2)));  // 3 of 5 columns inside
  EXPECT_FALSE(is_in_place(over_area(area), standing_box(0.41, 0.2)));
  ItemState leaning = standing_box(0.39, 0.2);  // its middle inside, most of its volume out
  for (Vec3& point : leaning.volume)
    point.x += 0.03;
  EXPECT_FALSE(is_in_place(over_area(area), leaning));
}

TEST(CheckoutGoals, MovingTouchedAndThrownItemsAreNotInPlace) {
  ItemState moving = standing_box(0.2, 0.2), touched = moving, thrown = moving;
  moving.rested_s = 0.5;
  touched.touched = true;
  thrown.impact_m_s = 1.2;
  EXPECT_FALSE(is_in_place(over_area(area), moving));
  EXPECT_FALSE(is_in_place(over_area(area), touched));
  EXPECT_FALSE(is_in_place(over_area(area), thrown));
}

TEST(CheckoutGoals, UnderTheCounterIsNotInPlace) {
  ItemState fallen = standing_box(0.2, 0.2);
  fallen.pose.position.z = -0.88;
  EXPECT_FALSE(is_in_place(over_area(area), fallen));
}

TEST(CheckoutGoals, EachGoalCountsOnce) {
  const EpisodeOutcome outcome = judged({standing_box(0.2, 0.2), standing_box(0.9, 0.2, "rice")});
  EXPECT_EQ(outcome.asked, 2);
  EXPECT_EQ(outcome.hits, 1);
  EXPECT_EQ(outcome.goals[0].reached, 1);
  EXPECT_EQ(outcome.goals[1].reached, 0);
  EXPECT_EQ(outcome.wrong, 0);
}

TEST(CheckoutGoals, AWrongItemCancelsAHit) {
  const EpisodeOutcome outcome = judged(
      {standing_box(0.1, 0.1), standing_box(0.2, 0.2, "rice"), standing_box(0.3, 0.3, "soap")});
  EXPECT_EQ(outcome.wrong, 1);
  EXPECT_EQ(outcome.hits, 1);
}

TEST(CheckoutGoals, MoreThanWereAskedForIsWrong) {
  const EpisodeOutcome outcome = judged({standing_box(0.1, 0.1), standing_box(0.3, 0.3)});
  EXPECT_EQ(outcome.wrong, 1);
  EXPECT_EQ(outcome.hits, 0);
}

TEST(CheckoutGoals, ATiltedBasketIsVoid) {
  const std::vector<ItemState> items{standing_box(0.1, 0.1), standing_box(0.3, 0.3, "rice")};
  EXPECT_EQ(judged(items, 14).hits, 2);
  const EpisodeOutcome tilted = judged(items, 16);
  EXPECT_TRUE(tilted.is_void);
  EXPECT_EQ(tilted.hits, 0);
}

}  // namespace
}  // namespace marketgen
