#include "plan/egress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "plan/bsp.h"
#include "plan/floor_places.h"

namespace marketgen {
namespace {

plan::Shell hall(int width_mm, int depth_mm) {
  plan::Shell shell;
  shell.width_mm = width_mm;
  shell.depth_mm = depth_mm;
  shell.openings = {{"entrance", plan::OpeningKind::entrance, plan::Wall::south, 0.2, 1600},
                    {"exit", plan::OpeningKind::exit, plan::Wall::south, 0.8, 1600},
                    {"dock", plan::OpeningKind::service, plan::Wall::north, 0.5, 1500}};
  return shell;
}

plan::Shell with(plan::Shell shell, const std::vector<plan::Opening>& more) {
  shell.openings.insert(shell.openings.end(), more.begin(), more.end());
  return shell;
}

TEST(Egress, CountsPeopleAndTheDoorsTheyNeed) {
  const plan::WaysOut ways = plan::ways_out(hall(20000, 10000));
  EXPECT_NEAR(ways.people, 200 / 5.574, 1e-9);
  EXPECT_EQ(ways.doors, 2) << "goods come in by the dock, people do not leave by it";
  EXPECT_EQ(ways.width_mm, 3200);
  EXPECT_NEAR(ways.needed_width_mm(), 200 / 5.574 * 5.08, 1e-9);
  EXPECT_EQ(plan::doors_for(49), 1);
  EXPECT_EQ(plan::doors_for(50), 2);
  EXPECT_EQ(plan::doors_for(501), 3);
  EXPECT_EQ(plan::doors_for(1001), 4);
}

TEST(Egress, AShopWithEnoughDoorsLacksNone) {
  EXPECT_TRUE(plan::lacking_exits(hall(50000, 55000)).empty());  // 493 people
}

TEST(Egress, AHallGetsWhatItLacks) {
  const plan::Shell shell = hall(60000, 50000);  // 538 people: three doors
  const std::vector<plan::Opening> exits = plan::lacking_exits(shell);
  ASSERT_EQ(exits.size(), 1U);
  EXPECT_EQ(exits[0].id, "emergency");
  EXPECT_EQ(exits[0].kind, plan::OpeningKind::emergency);
  // Farthest from doors at 12 and 48 m is the middle of the back wall, where the dock is: 27 m is
  // the nearest place west of it.
  EXPECT_EQ(exits[0].wall, plan::Wall::north);
  EXPECT_NEAR(exits[0].center * 60, 27, 0.5);
  const plan::WaysOut large =
      plan::ways_out(with(hall(125000, 80000), plan::lacking_exits(hall(125000, 80000))));
  EXPECT_GE(large.doors, 4);
  EXPECT_GE(large.width_mm, large.needed_width_mm()) << "1,794 people need 9.1 m of doors";
}

TEST(Egress, ExitsStandInWallsAndClearOfColumnsAndOtherDoors) {
  plan::Shell shell = hall(80000, 60000);
  shell.outline_mm =
      PolygonMm{{0, 0}, {80000, 0}, {80000, 60000}, {30000, 60000}, {30000, 40000}, {0, 40000}};
  shell.columns = {{79000, 59000, 400}, {79000, 1000, 400}};
  const std::vector<plan::Opening> exits = plan::lacking_exits(shell);
  ASSERT_FALSE(exits.empty());
  for (const plan::Opening& exit : exits) {
    const PointMm inside = plan::point_inside(plan::shell_rect(shell), exit, 1000);
    EXPECT_TRUE(contains(*shell.outline_mm, inside)) << exit.id;
    for (const plan::Column& column : shell.columns)
      EXPECT_FALSE(plan::footprint_of(column).grown(600).contains(inside)) << exit.id;
    for (const plan::Opening& other : shell.openings) {
      if (other.wall != exit.wall) continue;
      const bool east = exit.wall == plan::Wall::north || exit.wall == plan::Wall::south;
      const double apart = std::abs(other.center - exit.center) * (east ? 80000 : 60000);
      EXPECT_GT(apart, (other.width_mm + exit.width_mm) / 2) << exit.id;
    }
  }
}

TEST(Egress, NoExitWhereNoWallHasRoom) {
  plan::Shell shell = hall(60000, 60000);
  for (const plan::Wall wall :
       {plan::Wall::north, plan::Wall::east, plan::Wall::south, plan::Wall::west})
    shell.openings.push_back(
        {"window-" + std::string(name_of(wall)), plan::OpeningKind::window, wall, 0.5, 58000});
  EXPECT_TRUE(plan::lacking_exits(shell).empty());
}

}  // namespace
}  // namespace marketgen
