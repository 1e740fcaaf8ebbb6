// Progress rises on the way from nothing to the goal, and never falls by what the way needs.
#include "environments/goal_progress.h"

#include <gtest/gtest.h>

namespace marketgen {
namespace {

constexpr environments::ProgressScale scale{0.15, 0.25};
const environments::EnvironmentPlace area{{0.5, -0.5, 0}, {0.3, 0.4, 0}, {}};

environments::EnvironmentItem item_at(Vec3 at) {
  environments::EnvironmentItem item;
  item.sku = "box";
  item.middle = at;
  item.pose.position = at;
  item.wanted = true;
  return item;
}

double progress(const environments::EnvironmentItem& item, Vec3 tool) {
  return environments::goal_progress({{"box", 1}}, {item}, area, {{tool, {}}}, scale);
}

TEST(GoalProgress, RisesOnTheWay) {
  environments::EnvironmentItem item = item_at({0.5, 0.2, 0.05});
  std::vector<double> seen{progress(item, {0.3, 0.2, 0.5})};
  seen.push_back(progress(item, {0.45, 0.2, 0.2}));  // nearer
  seen.push_back(progress(item, item.middle));       // there
  item.held = item.touched = true;
  seen.push_back(progress(item, item.middle));
  item = item_at({0.5, -0.2, 0.2});
  item.held = item.touched = true;
  seen.push_back(progress(item, item.middle));  // carried
  item = item_at({0.5, -0.4, 0.05});
  item.in_region = item.touched = true;
  seen.push_back(progress(item, item.middle));  // on the area
  item.touched = false;
  seen.push_back(progress(item, {0.5, -0.4, 0.3}));  // let go
  item.rested_s = 0.5;
  seen.push_back(progress(item, {0.5, -0.4, 0.3}));
  item.in_place = true;
  seen.push_back(progress(item, {0.5, 0, 0.5}));
  for (std::size_t i = 1; i < seen.size(); ++i)
    EXPECT_GT(seen[i], seen[i - 1]) << i;
  EXPECT_GE(seen.front(), 0);
  EXPECT_DOUBLE_EQ(seen.back(), 1);
}

TEST(GoalProgress, IsTheMeanOverWhatIsAskedFor) {
  environments::EnvironmentItem done = item_at({0.5, -0.5, 0.05}), other = item_at({0.5, 5, 0.05});
  done.in_place = true;
  const std::vector<Pose> far_tool{{{-5, 5, 5}, {}}};
  EXPECT_NEAR(
      environments::goal_progress({{"box", 2}}, {other, done}, area, far_tool, scale), 0.5, 1e-6);
  EXPECT_NEAR(
      environments::goal_progress({{"box", 1}}, {other, done}, area, far_tool, scale), 1, 1e-6);
  EXPECT_EQ(environments::goal_progress({}, {done}, area, far_tool, scale), 0);
}

}  // namespace
}  // namespace marketgen
