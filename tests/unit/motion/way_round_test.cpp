// On from where people hold a base up.
#include "motion/way_round.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/committed_robot.h"

namespace marketgen {
namespace {

constexpr int clearance_mm = 450, room_mm = 1300;

std::vector<double> stow_of(const robots::Robot& robot) {
  return robots::with_followers(
      robot, robots::with_posture(*robot.find_posture("stow"), robots::neutral_state(robot)));
}

navigation::VisibilityGraph graph_of(const std::vector<RectMm>& walls) {
  const PolygonMm hall{{0, 0}, {8000, 0}, {8000, 6000}, {0, 6000}};
  return navigation::VisibilityGraph::make(hall, walls, clearance_mm).value();
}

// A corridor of 1.6 m that leads to the right from a hall and ends there.
const std::vector<RectMm> corridor{{3000, 0, 8000, 2200}, {3000, 3800, 8000, 6000}};

motion::MovingDisc person_at(double x, double y) {
  return {{x, y}, 0.64, 0};
}

TEST(WayRound, RoundThemWhereThereIsRoom) {
  const robots::Robot& robot = committed_robot("realman-rm75");
  const std::vector<motion::MovingDisc> people{person_at(4, 3)};
  const auto way = motion::plan_way_round(
      graph_of({}), robot, stow_of(robot), {{2, 3}, 0}, {{6.5, 3}, 0}, people);
  ASSERT_TRUE(way.ok()) << to_string(way.error());
  EXPECT_FALSE(way->aside);
  EXPECT_EQ(way->wait_s, 0.0);
  motion::BaseFollower on = way->on;
  for (int step = 0; step < 4000 && !on.done(); ++step) {
    on.step(0.05, people);
    EXPECT_FALSE(on.waits());
  }
  EXPECT_TRUE(on.done());
}

TEST(WayRound, OutOfADeadEndForWhoIsInIt) {
  const robots::Robot& robot = committed_robot("realman-rm75");
  const auto graph = graph_of(corridor);
  const std::vector<motion::MovingDisc> people{person_at(6, 3)};
  const auto way =
      motion::plan_way_round(graph, robot, stow_of(robot), {{4.6, 3}, 0}, {{7, 3}, 0}, people);
  ASSERT_TRUE(way.ok()) << to_string(way.error());
  ASSERT_TRUE(way->aside);
  EXPECT_GT(way->wait_s, 1.0);
  motion::BaseFollower aside = *way->aside;
  for (int step = 0; step < 4000 && !aside.done(); ++step)
    aside.step(0.05, people);
  ASSERT_TRUE(aside.done());
  const Vec2 at = aside.state().position;
  EXPECT_LT(at.x, 3.0) << "out of the corridor";
  EXPECT_GT(std::abs(at.y - 3), 0.5) << "and beside its mouth, not before it";
  EXPECT_GT(way->on.state().position.x, at.x - 0.01);
}

TEST(WayRound, WaitsForWhoCanGoAwayByThemselves) {
  const robots::Robot& robot = committed_robot("realman-rm75");
  const std::vector<motion::MovingDisc> people{person_at(6.5, 3)};
  const auto way = motion::plan_way_round(
      graph_of({}), robot, stow_of(robot), {{2, 3}, 0}, {{6.5, 3}, 0}, people);
  ASSERT_TRUE(way.ok()) << to_string(way.error());
  EXPECT_FALSE(way->aside) << "somebody stands where it wants to be, and is free to go";
  EXPECT_GT(way->wait_s, 1.0);
}

// Who stands where it wants to be and does not go away may see no way past it where it stands.
TEST(WayRound, AfterItWaitedInVainItGoesAway) {
  const robots::Robot& robot = committed_robot("realman-rm75");
  const std::vector<motion::MovingDisc> people{person_at(6.5, 3)};
  const auto way = motion::plan_way_round(
      graph_of({}), robot, stow_of(robot), {{5, 3}, 0}, {{6.5, 3}, 0}, people, true);
  ASSERT_TRUE(way.ok()) << to_string(way.error());
  ASSERT_TRUE(way->aside);
  EXPECT_GT(way->wait_s, 1.0);
  motion::BaseFollower aside = *way->aside;
  for (int step = 0; step < 4000 && !aside.done(); ++step)
    aside.step(0.05, people);
  ASSERT_TRUE(aside.done());
  const Vec2 at = aside.state().position;
  EXPECT_GE(std::hypot(at.x - 6.5, at.y - 3), 2.99);
}

// A bay of 1.5 m in a corner, somebody in it, the robot before its mouth: a little nearer to them
// would let them out, too, but it cannot get there.
TEST(WayRound, OutOfTheMouthOfABay) {
  const robots::Robot& robot = committed_robot("realman-rm75");
  const PolygonMm hall{{550, 0}, {8000, 0}, {8000, 6950}, {550, 6950}};
  const auto graph =
      navigation::VisibilityGraph::make(hall, {{2050, 5850, 8000, 6950}}, clearance_mm).value();
  const std::vector<motion::MovingDisc> people{person_at(1.177, 5.954)};
  for (const bool waited : {false, true}) {
    const auto way = motion::plan_way_round(
        graph, robot, stow_of(robot), {{1.87, 5.13}, 0.8}, {{1.3, 6.2}, 1.6}, people, waited);
    ASSERT_TRUE(way.ok()) << to_string(way.error());
    if (!waited && !way->aside) continue;
    ASSERT_TRUE(way->aside);
    motion::BaseFollower aside = *way->aside;
    for (int step = 0; step < 4000 && !aside.done(); ++step)
      aside.step(0.05, people);
    ASSERT_TRUE(aside.done());
    const Vec2 at = aside.state().position;
    EXPECT_GT(std::hypot(at.x - 1.177, at.y - 5.954), waited ? 1.5 : 1.05);
  }
}

TEST(WayRound, NobodyIsShutInWithoutPeople) {
  const auto graph = graph_of(corridor);
  EXPECT_FALSE(motion::passing_place(graph.space(), {4600, 3000}, {}, room_mm));
}

}  // namespace
}  // namespace marketgen
