// Arm plans: every path is judged by FCL, which shares no code with the checker: the links'
// capsules against the obstacles and against one another, densely along the trajectory.
#include "motion/plan_arm.h"

#include <gtest/gtest.h>

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <thread>

#include "support/committed_robot.h"
#include "support/shelf_problems.h"

namespace marketgen {
namespace {

const robots::Robot& panda() {
  static const robots::Robot robot = committed_robot("panda");
  return robot;
}
std::vector<double> ready_state() {
  std::vector<double> q =
      robots::with_posture(*panda().find_posture("ready"), robots::neutral_state(panda()));
  q[static_cast<std::size_t>(panda().find_dof("finger_joint1"))] = 0.04;
  return robots::with_followers(panda(), q);
}
const motion::ArmModel& panda_arm() {
  static const motion::ArmModel model = motion::make_arm_model(panda(), "arm").value();
  return model;
}
motion::Configuration ready() {
  const std::vector<double> q = ready_state();
  return {q.begin(), q.begin() + 7};
}

// ---- The judge ----

fcl::Transform3d to_fcl(const Pose& p) {
  const Quaternion& q = p.rotation;
  fcl::Transform3d t = fcl::Transform3d::Identity();
  t.linear() = fcl::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  t.translation() = fcl::Vector3d(p.position.x, p.position.y, p.position.z);
  return t;
}

// A capsule as FCL has it: along Z about its middle.
std::unique_ptr<fcl::CollisionObjectd> to_fcl(const robots::Capsule& capsule, const Pose& pose) {
  const Vec3 a = pose * capsule.a, b = pose * capsule.b, along = b - a;
  fcl::Transform3d t = fcl::Transform3d::Identity();
  const Vec3 middle = (a + b) * 0.5;
  t.translation() = fcl::Vector3d(middle.x, middle.y, middle.z);
  t.linear() = fcl::Quaterniond::FromTwoVectors(fcl::Vector3d(0, 0, 1),
                                                fcl::Vector3d(along.x, along.y, along.z))
                   .toRotationMatrix();
  if (length(along) < 1e-9) {
    t.linear().setIdentity();
    return std::make_unique<fcl::CollisionObjectd>(std::make_shared<fcl::Sphered>(capsule.radius),
                                                   t);
  }
  return std::make_unique<fcl::CollisionObjectd>(
      std::make_shared<fcl::Capsuled>(capsule.radius, length(along)), t);
}

class Judge {
 public:
  Judge(const motion::ArmModel& model, const motion::Obstacles& obstacles) : model_(model) {
    for (const motion::BoxObstacle& b : obstacles.boxes) {
      const Vec3 s = b.half_size * 2.0;
      add(std::make_shared<fcl::Boxd>(s.x, s.y, s.z), b.pose);
    }
    for (const motion::CylinderObstacle& c : obstacles.cylinders)
      add(std::make_shared<fcl::Cylinderd>(c.radius, 2 * c.half_length), c.pose);
    manager_.setup();
  }

  // The robot with what it carries touches nothing. `moved`: first link that is held against the
  // world; `held` moves with `link`.
  bool free(const std::vector<double>& state,
            const std::vector<robots::Sphere>& held = {},
            int link = 0) const {
    const std::vector<Pose> poses = robots::link_poses(*model_.robot, state);
    std::vector<std::vector<std::unique_ptr<fcl::CollisionObjectd>>> bodies(poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
      for (const robots::Capsule& c : model_.robot->links[i].capsules)
        bodies[i].push_back(to_fcl(c, poses[i]));
    }
    for (std::size_t i = 1; i < bodies.size(); ++i) {
      for (const auto& body : bodies[i]) {
        if (touches_world(*body)) return false;
      }
    }
    for (const robots::Sphere& s : held) {
      const robots::Capsule ball{s.center, s.center, s.radius};
      if (touches_world(*to_fcl(ball, poses[static_cast<std::size_t>(link)]))) return false;
    }
    for (const robots::LinkPair& pair : model_.pairs) {
      for (const auto& a : bodies[static_cast<std::size_t>(pair.a)]) {
        for (const auto& b : bodies[static_cast<std::size_t>(pair.b)]) {
          fcl::CollisionResultd result;
          if (fcl::collide(a.get(), b.get(), fcl::CollisionRequestd{}, result) > 0) return false;
        }
      }
    }
    return true;
  }

 private:
  void add(std::shared_ptr<fcl::CollisionGeometryd> shape, const Pose& pose) {
    objects_.push_back(std::make_unique<fcl::CollisionObjectd>(std::move(shape), to_fcl(pose)));
    manager_.registerObject(objects_.back().get());
  }
  bool touches_world(fcl::CollisionObjectd& body) const {
    body.computeAABB();
    fcl::DefaultCollisionData<double> data;
    manager_.collide(&body, &data, fcl::DefaultCollisionFunction<double>);
    return data.result.isCollision();
  }

  const motion::ArmModel& model_;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
};

// ---- The checker against the judge ----

TEST(ArmChecker, IsNeverFreeWhereFclSeesATouchAndLittleTooStrict) {
  int judged_free = 0, checked_free = 0;
  for (std::uint64_t scene = 0; scene < 4; ++scene) {
    const motion::Obstacles obstacles = shelf_scene(scene).obstacles;
    const auto world = motion::CollisionWorld::make(obstacles);
    ASSERT_TRUE(world.ok());
    const auto checker = motion::ArmChecker::make(panda_arm(), ready_state(), {}, *world);
    ASSERT_TRUE(checker.ok()) << to_string(checker.error());
    const Judge judge(panda_arm(), obstacles);
    Stream draw = Seed(scene).child("postures").stream();
    for (int i = 0; i < 250; ++i) {
      motion::Configuration q(7);
      for (std::size_t j = 0; j < 7; ++j)
        q[j] = draw.uniform(panda_arm().lower[j], panda_arm().upper[j]);
      const bool free = checker->free(q);
      const bool judged = judge.free(checker->state_with(q));
      EXPECT_EQ(free, checker->collision(q).empty());
      EXPECT_TRUE(judged || !free) << "scene " << scene << " posture " << i;
      judged_free += judged ? 1 : 0;
      checked_free += free ? 1 : 0;
    }
  }
  EXPECT_GT(judged_free, 100);
  EXPECT_GE(checked_free, 0.85 * judged_free);  // 4 mm margin and 5 mm spheres around capsules
}

TEST(ArmChecker, SaysWhatTouches) {
  motion::Obstacles obstacles;
  obstacles.boxes.push_back({{{0.5, 0, 0.5}, {}}, {0.25, 0.2, 0.02}});
  const auto world = motion::CollisionWorld::make(obstacles);
  const auto checker = motion::ArmChecker::make(panda_arm(), ready_state(), {}, *world);
  ASSERT_TRUE(checker.ok());
  const std::string text = checker->collision(ready());
  EXPECT_NE(text.find("with boxes/0"), std::string::npos) << text;
}

TEST(ArmChecker, TravelBoundsTheMotionOfEveryPoint) {
  const auto world = motion::CollisionWorld::make({});
  const auto checker = motion::ArmChecker::make(panda_arm(), ready_state(), {}, *world);
  ASSERT_TRUE(checker.ok());
  Stream draw = Seed(3).child("travel").stream();
  double closest = 0;
  for (int i = 0; i < 300; ++i) {
    motion::Configuration a(7), b(7);
    for (std::size_t j = 0; j < 7; ++j) {
      a[j] = draw.uniform(panda_arm().lower[j], panda_arm().upper[j]);
      b[j] = i % 8 == static_cast<int>(j) || i % 8 == 7
                 ? draw.uniform(panda_arm().lower[j], panda_arm().upper[j])
                 : a[j];
    }
    const auto from = robots::link_poses(panda(), checker->state_with(a));
    const auto to = robots::link_poses(panda(), checker->state_with(b));
    const double bound = checker->travel_m(a, b);
    for (std::size_t k = 0; k < from.size(); ++k) {
      for (const robots::Capsule& c : panda().links[k].capsules) {
        const double moved = length(from[k] * c.b - to[k] * c.b);
        EXPECT_LE(moved, bound + 1e-9);
        if (bound > 0) closest = std::max(closest, moved / bound);
      }
    }
  }
  EXPECT_GT(closest, 0.3);  // a bound, not just a large number
}

// ---- Plans ----

TEST(PlanArm, EveryShelfProblemIsSolvedAndFclAgreesAlongTheWholeWay) {
  int asked = 0;
  for (std::uint64_t index = 0; asked < 30 && index < 90; ++index) {
    const ShelfProblem problem = shelf_problem(panda_arm(), ready_state(), index);
    if (problem.goal.empty()) continue;
    ++asked;
    const auto world = motion::CollisionWorld::make(problem.obstacles);
    const auto checker = motion::ArmChecker::make(panda_arm(), ready_state(), {}, *world);
    ASSERT_TRUE(checker.ok());
    const auto plan = motion::plan_arm(*checker, problem.start, {problem.goal}, Seed(1));
    ASSERT_TRUE(plan.ok()) << index << ": " << to_string(plan.error());
    EXPECT_EQ(plan->path.front(), problem.start);
    EXPECT_EQ(plan->path.back(), problem.goal);
    const Judge judge(panda_arm(), problem.obstacles);
    int touches = 0;
    for (std::size_t i = 0; i + 1 < plan->path.size(); ++i) {
      const motion::Configuration &a = plan->path[i], &b = plan->path[i + 1];
      const int steps = 1 + static_cast<int>(checker->travel_m(a, b) / 0.01);
      for (int k = 0; k <= steps; ++k) {
        motion::Configuration q(7);
        for (std::size_t j = 0; j < 7; ++j)
          q[j] = a[j] + (b[j] - a[j]) * k / steps;
        touches += judge.free(checker->state_with(q)) ? 0 : 1;
      }
    }
    EXPECT_EQ(touches, 0) << "problem " << index;
    const double whole = plan->trajectory.duration_s();
    for (double t = 0; t <= whole; t += 0.05)
      EXPECT_TRUE(judge.free(checker->state_with(plan->trajectory.at(t).position))) << index;
  }
  EXPECT_GE(asked, 30);
}

TEST(PlanArm, TheTrajectoryKeepsTheLimitsOfTheRobotsRow) {
  const auto world = motion::CollisionWorld::make({});
  const auto checker = motion::ArmChecker::make(panda_arm(), ready_state(), {}, *world);
  ASSERT_TRUE(checker.ok());
  const motion::Configuration goal{1.2, 0.3, -0.5, -1.2, 0.4, 2.0, -0.6};
  const auto plan = motion::plan_arm(*checker, ready(), {goal}, Seed(1));
  ASSERT_TRUE(plan.ok()) << to_string(plan.error());
  constexpr double dt = 1e-4;
  double fastest = 0;
  motion::TrajectoryState before = plan->trajectory.at(0);
  for (double t = dt; t < plan->trajectory.duration_s() + dt; t += dt) {
    const motion::TrajectoryState now = plan->trajectory.at(t);
    for (std::size_t j = 0; j < 7; ++j) {
      const robots::Joint& joint = panda().joint_of_dof(j);
      const double v = std::abs(now.position[j] - before.position[j]) / dt;
      EXPECT_LE(v, joint.velocity * (1 + 1e-6));
      EXPECT_LE(std::abs(now.velocity[j] - before.velocity[j]) / dt,
                joint.acceleration * (1 + 1e-6));
      EXPECT_LE(std::abs(now.acceleration[j] - before.acceleration[j]) / dt,
                joint.jerk * (1 + 1e-6));
      fastest = std::max(fastest, v / joint.velocity);
    }
    before = now;
  }
  EXPECT_GT(fastest, 0.98);
}

TEST(PlanArm, WhatIsHeldIsKeptClearToo) {
  const ShelfProblem problem = shelf_problem(panda_arm(), ready_state(), 0);
  ASSERT_FALSE(problem.goal.empty());
  const auto world = motion::CollisionWorld::make(problem.obstacles);
  const int hand = panda().find_link("hand");
  motion::ArmCheckOptions options;
  motion::AttachedObject bottle{hand, {}, {hand}};
  for (const char* finger : {"finger_left", "finger_right"})
    bottle.may_touch.push_back(panda().find_link(finger));
  for (int k = 0; k < 6; ++k)
    bottle.spheres.push_back({{0.02 * k - 0.05, 0, 0.1034}, 0.025});
  options.attached = {bottle};
  const auto checker = motion::ArmChecker::make(panda_arm(), ready_state(), {}, *world, options);
  ASSERT_TRUE(checker.ok()) << to_string(checker.error());
  const Judge judge(panda_arm(), problem.obstacles);
  Stream draw = Seed(5).child("held").stream();
  int planned = 0;
  for (int i = 0; i < 200 && planned < 5; ++i) {
    motion::Configuration goal(7);
    for (std::size_t j = 0; j < 7; ++j)
      goal[j] = draw.uniform(panda_arm().lower[j], panda_arm().upper[j]);
    if (!checker->free(goal)) continue;
    const auto plan = motion::plan_arm(*checker, ready(), {goal}, Seed(2));
    ASSERT_TRUE(plan.ok()) << to_string(plan.error());
    ++planned;
    for (double t = 0; t <= plan->trajectory.duration_s(); t += 0.02) {
      const motion::Configuration q = plan->trajectory.at(t).position;
      EXPECT_TRUE(judge.free(checker->state_with(q), bottle.spheres, hand));
    }
  }
  EXPECT_EQ(planned, 5);
}

// From the stowed posture to the front of a shelf, either arm, at several heights of the lift, the
// other arm in its place: with hands of the postures that the certificates will ask for.
TEST(PlanArm, TheDualArmReachesAShelfPastItsOtherArm) {
  const robots::Robot robot = committed_robot("realman-rm75");
  motion::Obstacles obstacles;
  for (const double z : {0.15, 0.55, 0.95, 1.35, 1.75})
    obstacles.boxes.push_back({{{0.95, 0, z - 0.02}, {}}, {0.25, 0.8, 0.012}});
  obstacles.boxes.push_back({{{1.22, 0, 1.0}, {}}, {0.012, 0.8, 1.0}});
  const auto world = motion::CollisionWorld::make(obstacles);
  ASSERT_TRUE(world.ok());
  int asked = 0, solved = 0;
  for (const char* group : {"left_arm", "right_arm"}) {
    const motion::ArmModel model = motion::make_arm_model(robot, group).value();
    const double side = group[0] == 'l' ? 0.3 : -0.3;
    for (const double z : {0.75, 1.1, 1.5}) {
      std::vector<double> state =
          robots::with_posture(*robot.find_posture("stow"), robots::neutral_state(robot));
      const auto lift = static_cast<std::size_t>(robot.find_dof("lift"));
      state[lift] =
          std::clamp(z - 0.9, robot.joint_of_dof(lift).lower, robot.joint_of_dof(lift).upper);
      const auto checker = motion::ArmChecker::make(model, state, {}, *world);
      ASSERT_TRUE(checker.ok()) << to_string(checker.error());
      const Pose base =
          robots::link_poses(robot, state)[static_cast<std::size_t>(model.group.base)];
      const Pose tip{{0.74, side, z}, rotation_about({0, 1, 0}, std::numbers::pi / 2)};
      motion::Configuration start;
      for (const int dof : model.group.dofs)
        start.push_back(state[static_cast<std::size_t>(dof)]);
      const auto goals = motion::arm_goals(robot, model.group, inverse(base) * tip, start);
      if (!goals.ok()) continue;
      const auto free =
          std::find_if(goals->begin(), goals->end(), [&](const motion::Configuration& q) {
            return checker->free(q);
          });
      if (free == goals->end()) continue;
      ++asked;
      const auto plan = motion::plan_arm(*checker, start, {*free}, Seed(1));
      if (!plan.ok()) continue;
      ++solved;
      const Judge judge(model, obstacles);
      for (double t = 0; t <= plan->trajectory.duration_s(); t += 0.02)
        EXPECT_TRUE(judge.free(checker->state_with(plan->trajectory.at(t).position)))
            << group << " " << z << " at " << t << " s";
    }
  }
  EXPECT_GE(asked, 4);
  EXPECT_EQ(solved, asked);
}

TEST(PlanArm, SameSeedSamePathOnAnyThread) {
  const ShelfProblem problem = shelf_problem(panda_arm(), ready_state(), 1);
  ASSERT_FALSE(problem.goal.empty());
  const auto world = motion::CollisionWorld::make(problem.obstacles);
  const auto checker = motion::ArmChecker::make(panda_arm(), ready_state(), {}, *world);
  ASSERT_TRUE(checker.ok());
  const auto path = [&](std::uint64_t seed) {
    return motion::plan_arm(*checker, problem.start, {problem.goal}, Seed(seed)).value().path;
  };
  const motion::JointPath once = path(7);
  std::vector<motion::JointPath> others(4);
  std::vector<std::thread> threads;
  for (motion::JointPath& other : others)
    threads.emplace_back([&] { other = path(7); });
  for (std::thread& thread : threads)
    thread.join();
  for (const motion::JointPath& other : others)
    EXPECT_EQ(other, once);
  EXPECT_NE(path(8), once);
}

TEST(PlanArm, BadQuestionsAreErrorsThatSayWhy) {
  motion::Obstacles obstacles;
  obstacles.boxes.push_back({{{0.6, 0, 0.2}, {}}, {0.1, 0.4, 0.2}});
  const auto world = motion::CollisionWorld::make(obstacles);
  motion::ArmQuestion question;
  question.state = ready_state();
  const auto code = [&](const motion::ArmQuestion& asked,
                        const motion::ArmPlanOptions& options = {}) {
    const auto plan = motion::plan_arm(panda(), asked, *world, Seed(1), options);
    return plan.ok() ? "ok" : plan.error().code;
  };
  const motion::Configuration inside{0, 0.6, 0, -1.8, 0, 2.4, 0.785},
      there{1.5, -0.5, 0, -2.0, 0, 1.5, 0};
  question.goals = {inside};
  EXPECT_EQ(code(question), "motion.goal_in_collision");
  question.goals = {there};
  EXPECT_EQ(code(question), "ok");
  question.goals = {there};
  question.goals[0][2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code(question), "motion.bad_configuration");
  question.goals = {{9, 0, 0, -2, 0, 1.5, 0}};
  EXPECT_EQ(code(question), "motion.bad_configuration");
  question.goals = {there};
  question.group = "third_arm";
  EXPECT_EQ(code(question), "robot.unknown");
  question.group = "arm";
  for (std::size_t j = 0; j < 7; ++j)
    question.state[j] = inside[j];
  EXPECT_EQ(code(question), "motion.start_in_collision");
  question.state[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code(question), "robot.bad_state");
  question.state = ready_state();
  motion::ArmPlanOptions options;
  options.speed = 0;
  EXPECT_EQ(code(question, options), "motion.bad_limits");
  question.check.attached = {{0, {{{0, 0, 0}, 0.1}}, {}}};
  EXPECT_EQ(code(question), "motion.bad_configuration");
}

TEST(PlanArm, AGoalOutOfReachOrInAWallIsNamed) {
  // Walls all round the arm, the goal outside them.
  motion::Obstacles obstacles;
  for (const double sign : {-1.0, 1.0}) {
    obstacles.boxes.push_back({{{sign * 0.62, 0, 0.5}, {}}, {0.01, 0.63, 0.9}});
    obstacles.boxes.push_back({{{0, sign * 0.62, 0.5}, {}}, {0.63, 0.01, 0.9}});
  }
  obstacles.boxes.push_back({{{0, 0, 1.25}, {}}, {0.63, 0.63, 0.01}});
  const auto world = motion::CollisionWorld::make(obstacles);
  const auto checker = motion::ArmChecker::make(panda_arm(), ready_state(), {}, *world);
  ASSERT_TRUE(checker.ok());
  ASSERT_EQ(checker->collision(ready()), "");
  const auto unreachable =
      motion::arm_goals(panda(), panda_arm().group, {{2, 0, 0.5}, {}}, ready());
  ASSERT_FALSE(unreachable.ok());
  EXPECT_EQ(unreachable.error().code, "robot.unreachable");
  const motion::Configuration outside{0, 1.2, 0, -0.5, 0, 1.7, 0};
  const auto plan = motion::plan_arm(*checker, ready(), {outside}, Seed(1));
  ASSERT_FALSE(plan.ok());
  EXPECT_EQ(plan.error().code, "motion.goal_in_collision");
  EXPECT_NE(plan.error().message.find("with boxes/"), std::string::npos) << plan.error().message;
}

}  // namespace
}  // namespace marketgen
