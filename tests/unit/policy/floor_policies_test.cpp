// The policies that know nothing: the one that stops, and what the one that lifts the highest thing
// takes for that.
#include "policy/floor_policies.h"

#include <gtest/gtest.h>

#include "policy/highest_first.h"

namespace marketgen {
namespace {

TEST(StopPolicy, HasDoneAtOnceAndMovesNothing) {
  policy::StopPolicy policy;
  agent::Observation now;
  now.position = {0.1, -0.2};
  now.openings_m = {0.03};
  ASSERT_TRUE(policy.begin({}, now).ok());
  const agent::Action action = policy.act(now).value();
  EXPECT_TRUE(action.stop);
  EXPECT_EQ(action.position, now.position);
  ASSERT_EQ(action.tools.size(), 1U);
  EXPECT_EQ(action.tools[0].opening_m, 0.03);
}

agent::Workplace basket_at(Vec3 place) {
  agent::Workplace workplace;
  workplace.base_from_basket.position = place;
  return workplace;
}

TEST(HighestFirst, TakesWhatIsAboutTheHighestPoint) {
  const agent::Workplace place = basket_at({0.5, 0, 0.003});
  const std::vector<Vec3f> points{{0.50F, 0.00F, 0.10F},   // the top
                                  {0.52F, 0.00F, 0.09F},   // beside it
                                  {0.50F, 0.03F, 0.06F},   // too far below
                                  {0.58F, 0.00F, 0.09F}};  // too far aside
  const std::vector<Vec3f> patch = policy::highest_patch(points, place, {});
  ASSERT_EQ(patch.size(), 2U);
  EXPECT_EQ(patch[0].z, 0.10F);
  EXPECT_EQ(patch[1].z, 0.09F);
  const std::vector<Vec3f> next = policy::highest_patch(points, place, {{0.50, 0.01, 0.10}});
  ASSERT_EQ(next.size(), 1U) << "what was tried in vain is left alone";
  EXPECT_EQ(next[0].x, 0.58F);
}

TEST(HighestFirst, AnEmptyBasketHasNothing) {
  const agent::Workplace place = basket_at({0.5, 0, 0.003});
  EXPECT_TRUE(policy::highest_patch({}, place, {}).empty());
  EXPECT_TRUE(policy::highest_patch({{0.5F, 0, 0.01F}}, place, {}).empty()) << "its floor";
}

}  // namespace
}  // namespace marketgen
