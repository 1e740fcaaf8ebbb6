// Straight lines of the tool: the tip keeps to the line between the postures too, no joint jumps,
// what blocks a line is named, and a reach ends at the grasp without touching the shelf.
#include "motion/tool_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/committed_robot.h"
#include "support/shelf_problems.h"

namespace marketgen {
namespace {

struct Desk {
  robots::Robot robot;
  motion::ArmModel model;
  std::vector<double> state;

  motion::Configuration start() const {
    motion::Configuration q;
    for (const int dof : model.group.dofs)
      q.push_back(state[static_cast<std::size_t>(dof)]);
    return q;
  }
  Pose base_from_tip(const motion::ArmChecker& checker, const motion::Configuration& q) const {
    const std::vector<double> all = checker.state_with(q);
    return inverse(robots::link_poses(robot, all)[static_cast<std::size_t>(model.group.base)]) *
           robots::frame_pose(robot, all, model.group.tip);
  }
};

std::unique_ptr<Desk> desk_of(const std::string& id, const char* group, const char* posture) {
  auto desk = std::make_unique<Desk>();
  desk->robot = committed_robot(id);
  desk->model = motion::make_arm_model(desk->robot, group).value();
  desk->state =
      robots::with_posture(*desk->robot.find_posture(posture), robots::neutral_state(desk->robot));
  if (id == "panda")
    desk->state[static_cast<std::size_t>(desk->robot.find_dof("finger_joint1"))] = 0.04;
  desk->state = robots::with_followers(desk->robot, desk->state);
  return desk;
}

const Desk& panda_desk() {
  static const std::unique_ptr<Desk> desk = desk_of("panda", "arm", "ready");
  return *desk;
}

double off_line(Vec3 a, Vec3 b, Vec3 p) {
  const Vec3 along = normalized(b - a);
  return length((p - a) - along * dot(p - a, along));
}

// How far the tip is off the line along a trajectory.
double farthest_off(const Desk& desk,
                    const motion::ArmChecker& checker,
                    const motion::JointTrajectory& way,
                    double from_s,
                    Vec3 a,
                    Vec3 b) {
  double worst = 0;
  for (double t = from_s; t <= way.duration_s(); t += 0.01)
    worst =
        std::max(worst, off_line(a, b, desk.base_from_tip(checker, way.at(t).position).position));
  return worst;
}

TEST(ToolLine, TheTipKeepsToTheLineBetweenThePosturesToo) {
  const auto world = motion::CollisionWorld::make({});
  const auto realman = desk_of("realman-rm75", "left_arm", "stow");
  for (const Desk* desk : {&panda_desk(), static_cast<const Desk*>(realman.get())}) {
    const auto checker = motion::ArmChecker::make(desk->model, desk->state, {}, *world);
    ASSERT_TRUE(checker.ok()) << to_string(checker.error());
    const Pose from = desk->base_from_tip(*checker, desk->start());
    int followed = 0;
    for (const Vec3 move : {Vec3{0.1, 0, 0}, Vec3{0, 0.08, -0.05}, Vec3{-0.05, 0.02, 0.06}}) {
      const Pose to{from.position + move, rotation_about({0, 0, 1}, 0.2) * from.rotation};
      const auto line = motion::tool_line(*checker, desk->start(), to);
      if (!line.ok()) continue;
      ++followed;
      EXPECT_LT(largest_difference(desk->base_from_tip(*checker, line->back()), to), 1e-8);
      EXPECT_GE(line->size(), 5U);
      const auto limits = motion::motion_limits(desk->model).value();
      const auto times = motion::timed_curve(*line, limits).value();
      EXPECT_LT(farthest_off(*desk, *checker, times, 0, from.position, to.position), 1e-3);
      for (std::size_t i = 0; i + 1 < line->size(); ++i) {
        for (std::size_t j = 0; j < (*line)[i].size(); ++j)
          EXPECT_LT(std::abs((*line)[i + 1][j] - (*line)[i][j]), 0.3);
      }
    }
    EXPECT_GE(followed, 2) << desk->robot.name;
  }
}

TEST(ToolLine, WhatBlocksItIsNamed) {
  const Desk& desk = panda_desk();
  const auto nothing = motion::CollisionWorld::make({});
  const auto open = motion::ArmChecker::make(desk.model, desk.state, {}, *nothing);
  const Pose from = desk.base_from_tip(*open, desk.start());
  Pose to = from;
  to.position = to.position - Vec3{0, 0, 0.3};
  EXPECT_TRUE(motion::tool_line(*open, desk.start(), to).ok());
  motion::Obstacles table;
  table.boxes.push_back({{to.position, {}}, {0.08, 0.08, 0.05}});
  const auto world = motion::CollisionWorld::make(table);
  const auto checker = motion::ArmChecker::make(desk.model, desk.state, {}, *world);
  const auto blocked = motion::tool_line(*checker, desk.start(), to);
  ASSERT_FALSE(blocked.ok());
  EXPECT_EQ(blocked.error().code, "motion.line_blocked");
  EXPECT_NE(blocked.error().message.find("with boxes/0"), std::string::npos);
  to.position = from.position + Vec3{1, 0, 0};
  const auto far = motion::tool_line(*open, desk.start(), to);
  ASSERT_FALSE(far.ok());
  EXPECT_EQ(far.error().code, "robot.unreachable");
}

// From the ready posture to a product's front between two boards, and out again with it in hand.
TEST(ToolLine, ReachesIntoAShelfAndLeavesItWithoutTouching) {
  const Desk& desk = panda_desk();
  int reached = 0, left = 0;
  for (std::uint64_t index = 0; index < 20; index += 2) {
    const ShelfProblem problem = shelf_problem(desk.model, desk.state, index);
    if (problem.goal.empty()) continue;
    const auto world = motion::CollisionWorld::make(problem.obstacles);
    const auto checker = motion::ArmChecker::make(desk.model, desk.state, {}, *world);
    ASSERT_TRUE(checker.ok());
    motion::ReachQuestion question{
        problem.start, desk.base_from_tip(*checker, problem.goal), {0, 0, 0.1}};
    const auto plan = motion::plan_reach(*checker, *checker, question, Seed(1));
    if (!plan.ok()) continue;
    ++reached;
    EXPECT_EQ(plan->way.front(), problem.start);
    EXPECT_EQ(plan->way.back(), plan->line.front());
    const Pose end = desk.base_from_tip(*checker, plan->trajectory.at(1e9).position);
    EXPECT_LT(largest_difference(end, question.base_from_grasp), 1e-8);
    for (double t = 0; t <= plan->trajectory.duration_s(); t += 0.02)
      EXPECT_TRUE(checker->free(plan->trajectory.at(t).position)) << index << " at " << t << " s";
    const Pose begin = desk.base_from_tip(*checker, plan->line.front());
    const motion::LeaveQuestion back{plan->line.back(), begin, {problem.start}};
    const auto out = motion::plan_leave(*checker, *checker, back, Seed(1));
    ASSERT_TRUE(out.ok()) << to_string(out.error());
    ++left;
    EXPECT_EQ(out->way.back(), problem.start);
    for (double t = 0; t <= out->trajectory.duration_s(); t += 0.02)
      EXPECT_TRUE(checker->free(out->trajectory.at(t).position)) << index << " at " << t << " s";
  }
  EXPECT_GE(reached, 5);
  EXPECT_EQ(left, reached);
}

TEST(ToolLine, BadQuestionsAreErrorsThatSayWhy) {
  const Desk& desk = panda_desk();
  const auto world = motion::CollisionWorld::make({});
  const auto checker = motion::ArmChecker::make(desk.model, desk.state, {}, *world);
  const Pose here = desk.base_from_tip(*checker, desk.start());
  const auto code = [&](const motion::Configuration& start,
                        const Pose& to,
                        const motion::ToolLineOptions& o = {}) {
    const auto line = motion::tool_line(*checker, start, to, o);
    return line.ok() ? "ok" : line.error().code;
  };
  EXPECT_EQ(code(desk.start(), here), "ok");
  EXPECT_EQ(code({0, 1}, here), "motion.bad_configuration");
  Pose bad = here;
  bad.position.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code(desk.start(), bad), "motion.bad_configuration");
  bad = here, bad.rotation.w += 1;
  EXPECT_EQ(code(desk.start(), bad), "motion.bad_configuration");
  motion::ToolLineOptions options;
  options.step_m = 0;
  EXPECT_EQ(code(desk.start(), here, options), "motion.bad_limits");
  motion::ReachQuestion question{
      desk.start(), here, {0, 0, std::numeric_limits<double>::infinity()}};
  EXPECT_EQ(motion::plan_reach(*checker, *checker, question, Seed(1)).error().code,
            "motion.bad_configuration");
}

}  // namespace
}  // namespace marketgen
