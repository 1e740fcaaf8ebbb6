// What is kept of earlier looks when a robot looks again from elsewhere.
#include "policy/aisle_sight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "robots/robot.h"
#include "support/committed_robot.h"
#include "support/drawn_boxes.h"

namespace marketgen {
namespace {

constexpr robots::BasePlace here{10, 0, 0};
constexpr double wall_m = 1.0;
constexpr float store_wall_x = 11;

// A wall ahead of the robot, as wide and high as the picture, and no further.
policy::ShelfSight sight_of_a_wall() {
  const std::vector<DrawnBox> boxes{
      {{{wall_m + 0.01, 0, -1}, {}}, {0.02, 4, 4}, plain({90, 90, 90})}};
  const Pose eye{{0, 0, 1}, rotation_with_axes({0, -1, 0}, {1, 0, 0})};
  policy::ShelfSight sight(here);
  sight.add(drawn_view(boxes, eye, 80, 60, 60));
  return sight;
}

TEST(ShelfSight, WhatIsSeenAnewReplacesWhatWasSeenBefore) {
  const robots::Robot robot = committed_robot("realman-rm75");
  const Vec3f where_it_was{store_wall_x - 0.02F, 0.1F, 1.1F};  // the base is now known otherwise
  const Vec3f hidden{store_wall_x + 0.4F, 0, 1}, beside{store_wall_x, 3, 1};
  const std::vector<Vec3f> points = sight_of_a_wall().points_beside(
      {where_it_was, hidden, beside}, robot, robots::neutral_state(robot));
  const auto has = [&](Vec3f point) {
    return std::ranges::any_of(points,
                               [&](const Vec3f& each) { return length(each - point) < 1e-4F; });
  };
  EXPECT_FALSE(has(where_it_was));
  EXPECT_TRUE(has(hidden)) << "nothing new is known of what stands behind";
  EXPECT_TRUE(has(beside)) << "outside of the picture";
  EXPECT_GT(points.size(), 100U) << "the wall itself";
  EXPECT_EQ(points.size(),
            sight_of_a_wall().points(robot, robots::neutral_state(robot)).size() + 2);
}

// A pack on a shelf before the robot is seen, or the place where it was; behind a board or out of
// the picture nothing is said of it.
TEST(ShelfSight, ShowsWhatNothingHides) {
  const Vec3 size{0.06, 0.06, 0.12};
  const auto look =
      perception::ProductLook::make("tin", drawn_pictures(size, plain({200, 40, 30})));
  ASSERT_TRUE(look.ok()) << to_string(look.error());
  const Quaternion facing = rotation_about({0, 0, 1}, -std::numbers::pi / 2);
  const policy::ShelfFind there{0, {{10.9, 0, 0.95}, facing}, 0.5};
  const policy::ShelfFind aside{0, {{10.9, 3, 0.95}, facing}, 0.5};
  const DrawnBox wall{{{1.1, 0, -1}, {}}, {0.02, 4, 4}, plain({90, 90, 90})};
  const DrawnBox tin{{{0.9, 0, 0.95}, facing}, size, plain({200, 40, 30})};
  const DrawnBox arm{{{0.5, 0, 0.8}, {}}, {0.02, 0.4, 0.4}, plain({20, 20, 20})};
  const auto sight_of = [](const std::vector<DrawnBox>& boxes) {
    policy::ShelfSight sight(here);
    sight.add(
        drawn_view(boxes, {{0, 0, 1}, rotation_with_axes({0, -1, 0}, {1, 0, 0})}, 320, 240, 240));
    return sight;
  };
  EXPECT_TRUE(sight_of({wall, tin}).shows(there, *look));
  EXPECT_TRUE(sight_of({wall}).shows(there, *look)) << "it is seen not to be there";
  EXPECT_FALSE(sight_of({wall, tin, arm}).shows(there, *look));
  EXPECT_FALSE(sight_of({wall, tin}).shows(aside, *look));
}

}  // namespace
}  // namespace marketgen
