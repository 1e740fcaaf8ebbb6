// Which of the finds is taken next.
#include "policy/shelf_finds.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

policy::ShelfFind find_at(std::size_t goal, double x_m, double score) {
  return {goal, {{x_m, 0, 1}, {}}, score};
}

TEST(ShelfFinds, TheNearestOfThoseAboutAsGoodAsTheBestIsNext) {
  policy::ShelfFinds finds;
  finds.remember(find_at(0, 5, 0.70), {5, 0});
  finds.remember(find_at(0, 2, 0.68), {2, 0});
  finds.remember(find_at(0, 1, 0.50), {1, 0});
  std::vector<policy::ShelfGoal> goals(1);
  EXPECT_EQ(finds.next(goals, {}, 0), 1U);
  EXPECT_EQ(finds.next(goals, {}, 0.69), 0U);
  EXPECT_FALSE(finds.next(goals, {}, 0.8));
  goals[0].fetched = goals[0].wanted;
  EXPECT_FALSE(finds.next(goals, {}, 0)) << "it is there";
}

TEST(ShelfFinds, OnePlaceIsOneFindAndWhatIsRefusedIsNotFoundAgain) {
  policy::ShelfFinds finds;
  const std::vector<policy::ShelfGoal> goals(2);
  finds.remember(find_at(0, 1, 0.5), {1, 0});
  finds.remember(find_at(0, 1.02, 0.6), {1, 0});
  EXPECT_DOUBLE_EQ(finds[0].place.score, 0.6) << "the better look";
  finds.refuse(0);
  EXPECT_FALSE(finds.next(goals, {}, 0));
  EXPECT_FALSE(finds.remember(find_at(0, 1.01, 0.9), {1, 0}));
  EXPECT_TRUE(finds.remember(find_at(1, 1.01, 0.9), {1, 0})) << "of another goal";
}

TEST(ShelfFinds, FarFromItsCategoryAFindIsWorthLess) {
  policy::ShelfFinds finds;
  EXPECT_NEAR(finds.remember(find_at(0, 3, 0.5), {3, 0}).value(), 0.5, 1e-12);
  EXPECT_LT(finds.remember(find_at(1, 3, 0.5), {8, 0}).value(), 0.45);
}

}  // namespace
}  // namespace marketgen
