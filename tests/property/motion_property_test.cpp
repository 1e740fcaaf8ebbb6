// Random motions: times keep every limit whatever the path, paths through random obstacles stay
// clear of them between the postures that the planner looked at, joint values for a tip's pose
// bring it there, and a base drives through random rooms without a part of the robot over an
// obstacle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "motion/plan_arm.h"
#include "motion/plan_drive.h"
#include "support/collision_reference.h"
#include "support/committed_robot.h"
#include "support/number_of_cases.h"

namespace marketgen {
namespace {

Stream motion_stream(const char* name, std::size_t number) {
  return Seed(21).child(name, number).stream();
}

double log_uniform(Stream& draw, double low, double high) {
  return std::exp(draw.uniform(std::log(low), std::log(high)));
}

// ---- Times along any path ----

// Far from any robot's, and far from one another's.
std::vector<motion::MotionLimits> random_limits(Stream& draw, std::size_t joints) {
  std::vector<motion::MotionLimits> limits;
  for (std::size_t j = 0; j < joints; ++j)
    limits.push_back(
        {log_uniform(draw, 0.02, 20), log_uniform(draw, 0.02, 200), log_uniform(draw, 0.1, 1e6)});
  return limits;
}

// Steps of very different lengths, joints that rest, and configurations that repeat.
motion::JointPath random_path(Stream& draw, std::size_t joints, int corners) {
  motion::JointPath path(1, motion::Configuration(joints));
  for (double& q : path.front())
    q = draw.uniform(-3, 3);
  while (static_cast<int>(path.size()) < corners) {
    motion::Configuration next = path.back();
    const double reach = draw.chance(0.1) ? 0 : log_uniform(draw, 1e-5, 3);
    for (double& q : next)
      q += draw.chance(0.2) ? 0 : draw.uniform(-reach, reach);
    path.push_back(std::move(next));
  }
  return path;
}

// Evenly along a smooth motion, as a tool's line is.
motion::JointPath random_curve(Stream& draw, std::size_t joints, int knots) {
  motion::JointPath curve(static_cast<std::size_t>(knots), motion::Configuration(joints));
  for (std::size_t j = 0; j < joints; ++j) {
    const double reach = log_uniform(draw, 1e-3, 2), start = draw.uniform(-3, 3);
    const double turns = draw.uniform(0, 0.4);
    for (std::size_t k = 0; k < curve.size(); ++k)
      curve[k][j] = reach * std::sin(start + turns * static_cast<double>(k));
  }
  return curve;
}

// Largest share that is used of any limit of any joint: by what the trajectory says and by what its
// positions do between two moments.
double largest_use(const motion::JointTrajectory& timed,
                   const std::vector<motion::MotionLimits>& limits) {
  constexpr int steps = 3000;
  const double dt = timed.duration_s() / steps;
  if (dt == 0) return 0;
  constexpr double rounding = 1e-13;  // of positions of a few radians
  double use = 0;
  motion::TrajectoryState before = timed.at(0);
  for (int k = 1; k <= steps; ++k) {
    const motion::TrajectoryState now = timed.at(k * dt);
    for (std::size_t j = 0; j < limits.size(); ++j) {
      const auto& [velocity, acceleration, jerk] = limits[j];
      const double moved = std::abs(now.position[j] - before.position[j]) - rounding;
      const double gained = std::abs(now.velocity[j] - before.velocity[j]) - rounding * velocity;
      const double turned =
          std::abs(now.acceleration[j] - before.acceleration[j]) - rounding * acceleration;
      use = std::max({use,
                      moved / (velocity * dt),
                      gained / (acceleration * dt),
                      turned / (jerk * dt),
                      std::abs(now.velocity[j]) / velocity,
                      std::abs(now.acceleration[j]) / acceleration});
    }
    before = now;
  }
  return use;
}

void expect_rest_at(const motion::TrajectoryState& state, const motion::Configuration& q) {
  EXPECT_EQ(state.position, q);
  for (std::size_t j = 0; j < q.size(); ++j) {
    EXPECT_EQ(state.velocity[j], 0);
    EXPECT_EQ(state.acceleration[j], 0);
  }
}

void expect_ends(const motion::JointTrajectory& timed, const motion::JointPath& path) {
  expect_rest_at(timed.at(-1), path.front());
  EXPECT_EQ(timed.at(0).position, path.front());
  expect_rest_at(timed.at(timed.duration_s() + 1), path.back());
  for (std::size_t j = 0; j < path.back().size(); ++j)
    EXPECT_NEAR(timed.at(timed.duration_s()).position[j], path.back()[j], 1e-9);
}

TEST(MotionProperty, TimesKeepEveryLimitAndBothEnds) {
  const std::size_t paths = number_of_cases("MARKETGEN_PROPERTY_PATHS", 300);
  for (std::size_t i = 0; i < paths; ++i) {
    SCOPED_TRACE(i);
    Stream draw = motion_stream("times", i);
    const auto joints = static_cast<std::size_t>(draw.integer(1, 8));
    const std::vector<motion::MotionLimits> limits = random_limits(draw, joints);
    const motion::JointPath corners = random_path(draw, joints, draw.integer(1, 6));
    const auto straight = motion::timed_path(corners, limits);
    ASSERT_TRUE(straight.ok()) << to_string(straight.error());
    EXPECT_LE(largest_use(*straight, limits), 1 + 1e-6);
    expect_ends(*straight, corners);
    const int count = draw.integer(2, 30);
    const motion::JointPath knots =
        i % 2 == 0 ? random_path(draw, joints, count) : random_curve(draw, joints, count);
    const auto curve = motion::timed_curve(knots, limits);
    ASSERT_TRUE(curve.ok()) << to_string(curve.error());
    EXPECT_LE(largest_use(*curve, limits), 1 + 1e-6);
    expect_ends(*curve, knots);
  }
}

// ---- Ways past any obstacles ----

Pose random_pose(Stream& draw, Vec3 position) {
  Quaternion turn;
  for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
    turn = turn * rotation_about(axis, draw.uniform(-std::numbers::pi, std::numbers::pi));
  return {position, turn};
}

Vec3 random_vector(Stream& draw, double low, double high) {
  return {draw.uniform(low, high), draw.uniform(low, high), draw.uniform(low, high)};
}

struct NearObstacle {
  motion::Obstacles planned;  // one obstacle
  motion::Obstacles judged;   // the same; a convex piece as points of its faces
  Vec3 middle;
  double radius_m = 0;  // about the middle, of all of it
};

std::vector<Vec3f> points_of_faces(const motion::ConvexObstacle& convex) {
  constexpr int fineness = 12;
  std::vector<Vec3f> points;
  for (const auto& t : convex_hull(convex.points).triangles) {
    const Vec3 a = to_double(convex.points[t[0]]), b = to_double(convex.points[t[1]]),
               c = to_double(convex.points[t[2]]);
    for (int i = 0; i <= fineness; ++i) {
      for (int j = 0; i + j <= fineness; ++j)
        points.push_back(to_float(
            convex.pose * (a + (b - a) * (1.0 * i / fineness) + (c - a) * (1.0 * j / fineness))));
    }
  }
  return points;
}

NearObstacle random_obstacle(Stream& draw, int kind) {
  const double around = draw.uniform(-std::numbers::pi, std::numbers::pi);
  const double away = draw.uniform(0.35, 0.75);
  const Pose pose = random_pose(
      draw, {away * std::cos(around), away * std::sin(around), draw.uniform(0.05, 0.9)});
  NearObstacle obstacle{{}, {}, pose.position, 0.2};
  std::vector<Vec3f> points;
  for (int p = 0; p < 12; ++p)
    points.push_back(to_float(random_vector(draw, -0.1, 0.1)));
  motion::Obstacles& planned = obstacle.planned;
  if (kind == 0) planned.boxes.push_back({pose, random_vector(draw, 0.002, 0.11)});
  if (kind == 1)
    planned.cylinders.push_back({pose, log_uniform(draw, 0.002, 0.1), draw.uniform(0.002, 0.15)});
  if (kind == 2) planned.convex.push_back({pose, points});
  if (kind == 3) {
    for (Vec3f& point : points)
      point = to_float(pose * to_double(point));
    planned.clouds.push_back({points, log_uniform(draw, 0.002, 0.02)});
  }
  obstacle.judged = planned;
  if (kind == 2) {
    obstacle.judged.clouds.push_back({points_of_faces(planned.convex[0]), 0});
    obstacle.judged.convex.clear();
  }
  return obstacle;
}

// So many of each kind, within the arm's reach.
std::vector<NearObstacle> random_obstacles(Stream& draw, int each) {
  std::vector<NearObstacle> made;
  for (int i = 0; i < 4 * each; ++i)
    made.push_back(random_obstacle(draw, i % 4));
  return made;
}

motion::Obstacles all_of(const std::vector<NearObstacle>& obstacles) {
  motion::Obstacles all;
  for (const NearObstacle& o : obstacles) {
    std::ranges::copy(o.planned.boxes, std::back_inserter(all.boxes));
    std::ranges::copy(o.planned.cylinders, std::back_inserter(all.cylinders));
    std::ranges::copy(o.planned.convex, std::back_inserter(all.convex));
    std::ranges::copy(o.planned.clouds, std::back_inserter(all.clouds));
  }
  return all;
}

// Whether a sphere of a link that the arm moves is in an obstacle, in double precision.
bool touches_any(const motion::ArmChecker& checker,
                 const motion::Configuration& q,
                 const std::vector<NearObstacle>& obstacles) {
  const robots::Robot& robot = *checker.model().robot;
  const std::vector<Pose> poses = robots::link_poses(robot, checker.state_with(q));
  for (std::size_t link = 1; link < poses.size(); ++link) {
    for (const robots::Sphere& sphere : robot.links[link].spheres) {
      const Vec3 center = poses[link] * sphere.center;
      for (const NearObstacle& o : obstacles) {
        if (length(center - o.middle) < sphere.radius + o.radius_m &&
            hits_reference(o.judged, center, sphere.radius))
          return true;
      }
    }
  }
  return false;
}

// Of a path, looked at in steps of `step_m` of travel.
int touches_along(const motion::ArmChecker& checker,
                  const motion::JointPath& path,
                  const std::vector<NearObstacle>& obstacles,
                  double step_m) {
  int touches = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const motion::Configuration &a = path[i], &b = path[i + 1];
    const int steps = 1 + static_cast<int>(checker.travel_m(a, b) / step_m);
    motion::Configuration q(a.size());
    for (int k = 0; k <= steps; ++k) {
      for (std::size_t j = 0; j < q.size(); ++j)
        q[j] = a[j] + (b[j] - a[j]) * k / steps;
      touches += touches_any(checker, q, obstacles) ? 1 : 0;
    }
  }
  return touches;
}

motion::Configuration random_posture(const motion::ArmModel& model, Stream& draw) {
  motion::Configuration q;
  for (std::size_t j = 0; j < model.lower.size(); ++j)
    q.push_back(draw.uniform(model.lower[j], model.upper[j]));
  return q;
}

// A quarter of the steps that the planner takes.
TEST(SlowMotionProperty, PathsAreClearBetweenThePosturesThatWereTested) {
  const robots::Robot panda = committed_robot("panda");
  const motion::ArmModel model = motion::make_arm_model(panda, "arm").value();
  const std::vector<double> ready = robots::with_followers(
      panda, robots::with_posture(*panda.find_posture("ready"), robots::neutral_state(panda)));
  const std::size_t problems = number_of_cases("MARKETGEN_PROPERTY_ARM_PLANS", 100);
  std::size_t planned = 0, bent = 0;
  for (std::size_t i = 0; i < problems; ++i) {
    Stream draw = motion_stream("obstacles", i);
    const std::vector<NearObstacle> obstacles = random_obstacles(draw, 2);
    const auto world = motion::CollisionWorld::make(all_of(obstacles));
    ASSERT_TRUE(world.ok()) << to_string(world.error());
    const auto checker = motion::ArmChecker::make(model, ready, {}, *world);
    ASSERT_TRUE(checker.ok()) << to_string(checker.error());
    const motion::Configuration start = random_posture(model, draw),
                                goal = random_posture(model, draw);
    const auto plan = motion::plan_arm(*checker, start, {goal}, Seed(i));
    if (!plan.ok()) continue;  // an end is in an obstacle, or nothing was found
    ++planned;
    bent += plan->path.size() > 2 ? 1 : 0;
    EXPECT_EQ(plan->path.front(), start);
    EXPECT_EQ(plan->path.back(), goal);
    EXPECT_EQ(touches_along(*checker, plan->path, obstacles, checker->margin_m() / 2), 0) << i;
  }
  EXPECT_GT(6 * planned, problems);
  EXPECT_GT(3 * bent, planned) << "straight ways prove little";
}

// ---- Joint values for a tip's pose ----

Pose base_from_tip(const motion::ArmModel& model, const motion::Configuration& q) {
  const robots::Robot& robot = *model.robot;
  std::vector<double> state = robots::neutral_state(robot);
  for (std::size_t j = 0; j < q.size(); ++j)
    state[static_cast<std::size_t>(model.group.dofs[j])] = q[j];
  const Pose base = robots::link_poses(robot, state)[static_cast<std::size_t>(model.group.base)];
  return inverse(base) * robots::frame_pose(robot, state, model.group.tip);
}

TEST(MotionProperty, EveryGoalOfAPoseReachesItNearestFirst) {
  int asked = 0;
  for (const auto& [id, group_name] : {std::pair<const char*, const char*>{"panda", "arm"},
                                       {"realman-rm75", "left_arm"},
                                       {"realman-rm65", "right_arm"}}) {
    SCOPED_TRACE(id);
    const robots::Robot robot = committed_robot(id);
    const motion::ArmModel model = motion::make_arm_model(robot, group_name).value();
    for (std::size_t i = 0; i < 100; ++i) {
      Stream draw = motion_stream(id, i);
      const motion::Configuration posture = random_posture(model, draw);
      const Pose tip = base_from_tip(model, posture);
      const auto goals = motion::arm_goals(robot, model.group, tip, posture, 48);
      if (!goals.ok()) continue;  // a redundancy that was not tried
      ++asked;
      double before = 0;
      for (const motion::Configuration& q : *goals) {
        EXPECT_LT(largest_difference(base_from_tip(model, q), tip), 1e-7) << i;
        double away = 0;
        for (std::size_t j = 0; j < q.size(); ++j) {
          EXPECT_GE(q[j], model.lower[j]);
          EXPECT_LE(q[j], model.upper[j]);
          away = std::max(away, std::abs(q[j] - posture[j]));
        }
        EXPECT_GE(away, before) << i;
        before = away;
      }
    }
  }
  EXPECT_GT(asked, 250);
}

// ---- Drives through any room ----

struct Room {
  int width_mm = 0, depth_mm = 0;
  std::vector<RectMm> obstacles;
};

Room random_room(Stream& draw) {
  Room room{draw.integer(4000, 9000), draw.integer(4000, 9000), {}};
  for (int k = draw.integer(4, 14); k > 0; --k) {
    const int x = draw.integer(0, room.width_mm - 300), y = draw.integer(0, room.depth_mm - 300);
    room.obstacles.push_back({x,
                              y,
                              std::min(x + draw.integer(100, 2500), room.width_mm),
                              std::min(y + draw.integer(100, 1200), room.depth_mm)});
  }
  return room;
}

// From a point to a rectangle, 0 inside of it.
double to_rectangle_m(const RectMm& r, Vec3 p) {
  const double x = p.x * 1e3, y = p.y * 1e3;
  return 1e-3 *
         std::hypot(std::max({r.x0 - x, x - r.x1, 0.0}), std::max({r.y0 - y, y - r.y1, 0.0}));
}

// The capsules of a robot in the frame of its base.
std::vector<robots::Capsule> capsules_of(const robots::Robot& robot,
                                         const std::vector<double>& state) {
  const std::vector<Pose> poses = robots::link_poses(robot, state);
  std::vector<robots::Capsule> all;
  for (std::size_t link = 0; link < poses.size(); ++link) {
    for (const robots::Capsule& c : robot.links[link].capsules)
      all.push_back({poses[link] * c.a, poses[link] * c.b, c.radius});
  }
  return all;
}

// Least that any capsule keeps from any wall or obstacle; capsules are looked at in eighths.
double min_gap_m(const std::vector<robots::Capsule>& capsules,
                 double axle_x,
                 const motion::BaseState& at,
                 const Room& room) {
  const Pose world_from_base =
      Pose{{at.position.x, at.position.y, 0}, rotation_about({0, 0, 1}, at.heading)} *
      Pose{{-axle_x, 0, 0}, {}};
  double least = HUGE_VAL;
  for (const robots::Capsule& c : capsules) {
    for (int k = 0; k <= 8; ++k) {
      const Vec3 p = world_from_base * (c.a + (c.b - c.a) * (k / 8.0));
      least = std::min({least,
                        p.x - c.radius,
                        p.y - c.radius,
                        room.width_mm * 1e-3 - p.x - c.radius,
                        room.depth_mm * 1e-3 - p.y - c.radius});
      for (const RectMm& r : room.obstacles)
        least = std::min(least, to_rectangle_m(r, p) - c.radius);
    }
  }
  return least;
}

motion::FloorPlace random_place(Stream& draw, const Room& room) {
  return {{draw.uniform(0, room.width_mm * 1e-3), draw.uniform(0, room.depth_mm * 1e-3)},
          draw.uniform(-std::numbers::pi, std::numbers::pi)};
}

TEST(MotionProperty, DrivesKeepEveryPartOfTheRobotOffWallsAndObstacles) {
  constexpr double rounding_m = 1e-3;  // floors and clearances are whole millimetres
  const std::size_t rooms = number_of_cases("MARKETGEN_PROPERTY_ROOMS", 150);
  std::size_t driven = 0, turned_off = 0;
  for (const char* id : {"realman-rm65", "realman-rm75"}) {
    const robots::Robot robot = committed_robot(id);
    const std::vector<double> state = robots::with_followers(
        robot, robots::with_posture(*robot.find_posture("stow"), robots::neutral_state(robot)));
    const std::vector<robots::Capsule> capsules = capsules_of(robot, state);
    const motion::BaseEnvelope envelope = motion::base_envelope(robot, state).value();
    for (std::size_t i = 0; i < rooms; ++i) {
      SCOPED_TRACE(i);
      Stream draw = motion_stream("rooms", i);
      const Room room = random_room(draw);
      const PolygonMm floor{
          {0, 0}, {room.width_mm, 0}, {room.width_mm, room.depth_mm}, {0, room.depth_mm}};
      const auto graph = navigation::VisibilityGraph::make(
          floor, room.obstacles, static_cast<int>(std::lround(envelope.radius_m * 1e3)));
      ASSERT_TRUE(graph.ok()) << to_string(graph.error());
      const motion::FloorPlace from = random_place(draw, room), to = random_place(draw, room);
      auto plan = motion::plan_drive(*graph, robot, state, from, to);
      if (!plan.ok()) {
        EXPECT_TRUE(plan.error().code == "motion.base_blocked" ||
                    plan.error().code == "motion.unreachable")
            << to_string(plan.error());
        continue;
      }
      ++driven;
      turned_off += plan->path.points.size() > 2 ? 1 : 0;
      double least = min_gap_m(capsules, robot.drive->axle_x, plan->follower.state(), room);
      for (int step = 0; step < 30'000 && !plan->follower.done(); ++step) {
        const motion::BaseState& at = plan->follower.step(0.02);
        least = std::min(least, min_gap_m(capsules, robot.drive->axle_x, at, room));
      }
      EXPECT_GE(least, -rounding_m);
      ASSERT_TRUE(plan->follower.done());
      const motion::BaseState& end = plan->follower.state();
      EXPECT_LE(std::hypot(end.position.x - to.position.x, end.position.y - to.position.y),
                rounding_m);
      EXPECT_LE(std::abs(std::remainder(end.heading - to.heading, 2 * std::numbers::pi)), 1e-6);
    }
  }
  EXPECT_GT(driven, rooms / 4);
  EXPECT_GT(3 * turned_off, driven) << "straight ways prove little";
}

}  // namespace
}  // namespace marketgen
