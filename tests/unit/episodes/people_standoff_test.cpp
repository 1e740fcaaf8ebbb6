// People before a robot that does not move: nobody stands there for long, nobody is met, and they
// turn no faster than people do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "unit/episodes/riverside_people.h"

namespace marketgen {
namespace {

using episodes::FloorDisc;
using episodes::PeopleAround;
using people_test::apart;
using people_test::bodies_m;
using people_test::dt;
using people_test::gap_to;
using people_test::min_apart;
using people_test::people_of;
using people_test::riverside;

constexpr double max_standoff_s = 20;
constexpr double robot_radius_m = 0.4;

// Where a robot may stand in the aisles, drawn; away from those who are there now.
std::optional<FloorDisc> robot_in_aisle(const PeopleAround& people, Stream& draw) {
  const navigation::FreeSpace& floor = riverside()->ways.space();
  const RectMm around = bounds_of(plan::floor_of(riverside()->scene.layout.shell));
  for (int tries = 0; tries < 200; ++tries) {
    const PointMm at{draw.integer(around.x0, around.x1), draw.integer(around.y0, around.y1)};
    if (!floor.on_floor(at) || !floor.free(at)) continue;
    const FloorDisc robot{{at[0] * 1e-3, at[1] * 1e-3}, robot_radius_m};
    bool clear = true;
    for (std::size_t i = 0; i < people.count(); ++i)
      clear = clear && gap_to(robot, people.place(i)) > episodes::stop_before_robot_m;
    if (clear) return robot;
  }
  return {};
}

struct Standoffs {
  double max_near_s = 0;  // that somebody stood within asks_for_room_m of the robot
  double max_stopped_s = 0, nearest_m = 1e9, min_apart_m = 1e9;
  int came_near = 0;  // of them
};

Standoffs watch_beside(PeopleAround& people, const FloorDisc& robot, double seconds) {
  Standoffs seen;
  std::vector<double> near_s(people.count(), 0);
  std::vector<bool> came(people.count(), false);
  for (double t = 0; t < seconds; t += dt) {
    people.pass(dt, std::span(&robot, 1));
    seen.min_apart_m = std::min(seen.min_apart_m, min_apart(people));
    for (std::size_t i = 0; i < people.count(); ++i) {
      const double gap = gap_to(robot, people.place(i));
      const bool near = gap < episodes::asks_for_room_m - 0.1;
      came[i] = came[i] || near;
      near_s[i] = near ? near_s[i] + dt : 0;
      seen.nearest_m = std::min(seen.nearest_m, gap);
      seen.max_near_s = std::max(seen.max_near_s, near_s[i]);
      seen.max_stopped_s = std::max(seen.max_stopped_s, people.stopped_s(i));
    }
  }
  seen.came_near = static_cast<int>(std::ranges::count(came, true));
  return seen;
}

// Robots anywhere in the aisles, people of many seeds: whoever comes to stand before the robot gets
// past it or turns round, and keeps from it and from everybody.
TEST(SlowPeopleStandoffs, EndWhereverTheRobotStands) {
  int near = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    PeopleAround people = people_of(10, {-9, -9}, seed);
    Stream draw = Seed(seed).child("robot").stream();
    for (int step = 0; step < 400; ++step)
      people.pass(dt, {});
    for (int place = 0; place < 3; ++place) {
      const auto robot = robot_in_aisle(people, draw);
      ASSERT_TRUE(robot) << seed;
      const Standoffs seen = watch_beside(people, *robot, 90);
      const auto where = testing::Message()
                         << "seed " << seed << ", robot at " << robot->at.x << ", " << robot->at.y;
      EXPECT_LT(seen.max_near_s, max_standoff_s) << where;
      EXPECT_LT(seen.max_stopped_s, max_standoff_s) << where;
      EXPECT_GT(seen.nearest_m, episodes::min_gap_m - 0.01) << where;
      EXPECT_GT(seen.min_apart_m, bodies_m) << where;
      near += seen.came_near;
    }
  }
  EXPECT_GT(near, 100) << "they do come to it";
}

// Everybody and the robot: whoever walks and stands, their bodies turn as people do.
TEST(PeopleStandoffs, NobodySpins) {
  constexpr double max_turn_deg_s = 180;
  double fastest = 0, turned_standing = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    PeopleAround people = people_of(8, {-9, -9}, seed);
    Stream draw = Seed(seed).child("robot").stream();
    std::vector<double> before(people.count());
    std::optional<FloorDisc> robot;
    for (int step = 0; step < 3600; ++step) {
      if (step % 900 == 400) robot = robot_in_aisle(people, draw);
      people.pass(dt, robot ? std::span(&*robot, 1) : std::span<const FloorDisc>{});
      for (std::size_t i = 0; i < people.count(); ++i) {
        const Vec3 ahead = rotate(people.store_from_person(i).rotation, {1, 0, 0});
        const double heading = std::atan2(ahead.y, ahead.x);
        const double turned = std::remainder(heading - before[i], 2 * std::numbers::pi);
        before[i] = heading;
        if (step == 0) continue;
        const double deg_s = std::abs(turned) / dt * 180 / std::numbers::pi;
        EXPECT_LT(deg_s, max_turn_deg_s) << i << " of seed " << seed << " at " << step * dt << " s";
        fastest = std::max(fastest, deg_s);
        if (people.speed_m_s(i) == 0) turned_standing += std::abs(turned);
      }
    }
  }
  EXPECT_GT(fastest, 60) << "they do turn";
  EXPECT_GT(turned_standing, 10);
}

// Who waits before a robot does not fidget: in a minute they turn round a few times at most.
TEST(PeopleStandoffs, WhoIsShutInStandsStill) {
  PeopleAround people = people_of(1);
  const Vec2 at = people.place(0);
  std::vector<FloorDisc> ring;
  for (int i = 0; i < 16; ++i)
    ring.push_back({at + Vec2{std::cos(i * 0.3927), std::sin(i * 0.3927)} * 1.6, 0.4});
  double turned = 0, walked = 0, before = 0;
  for (int step = 0; step < 1200; ++step) {
    const Vec2 was = people.place(0);
    people.pass(dt, ring);
    const Vec3 ahead = rotate(people.store_from_person(0).rotation, {1, 0, 0});
    const double heading = std::atan2(ahead.y, ahead.x);
    if (step > 0) turned += std::abs(std::remainder(heading - before, 2 * std::numbers::pi));
    before = heading;
    walked += apart(was, people.place(0));
  }
  EXPECT_LT(turned, 2 * std::numbers::pi);
  EXPECT_LT(walked, 2.0);
}

}  // namespace
}  // namespace marketgen
