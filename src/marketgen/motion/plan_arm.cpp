#include "motion/plan_arm.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "robots/arm_ik.h"

namespace marketgen::motion {
namespace {

bool positive(double value) {
  return value > 0 && std::isfinite(value);
}

bool path_free(const ConfigurationSpace& space, const JointPath& path) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (!space.motion_free(path[i], path[i + 1])) return false;
  }
  return true;
}

// Says what touches what.
Error explained(Error error,
                const ArmChecker& checker,
                const Configuration& start,
                const std::vector<Configuration>& goals) {
  if (error.code == "motion.start_in_collision") error.message = checker.collision(start);
  if (error.code == "motion.goal_in_collision" && !goals.empty())
    error.message = checker.collision(goals.front());
  return error;
}

}  // namespace

Result<std::vector<MotionLimits>> motion_limits(const ArmModel& model,
                                                const ArmPlanOptions& options) {
  const auto share = [](double value) { return positive(value) && value <= 1; };
  if (!share(options.speed) || !share(options.acceleration) || !positive(options.jerk_time_s))
    return Error{"motion.bad_limits",
                 "speed, acceleration and jerk time",
                 "shares are over 0 to 1, the time over 0"};
  std::vector<MotionLimits> limits;
  for (const int dof : model.group.dofs) {
    const robots::Joint& joint = model.robot->joint_of_dof(static_cast<std::size_t>(dof));
    if (!positive(joint.velocity) || !positive(joint.acceleration)) {
      return Error{"motion.bad_limits",
                   joint.name,
                   "the robot's row gives it no velocity or no acceleration"};
    }
    const double acceleration = joint.acceleration * options.acceleration;
    const double jerk = positive(joint.jerk) ? joint.jerk : acceleration / options.jerk_time_s;
    limits.push_back({joint.velocity * options.speed, acceleration, jerk});
  }
  return limits;
}

Result<JointPath> plan_arm_path(const ArmChecker& checker,
                                const Configuration& start,
                                const std::vector<Configuration>& goals,
                                Seed seed,
                                const ArmPlanOptions& options) {
  const ConfigurationSpace fine = checker.space(2 * checker.margin_m());
  const ConfigurationSpace coarse =
      checker.space(std::max(options.coarse_step_m, 2 * checker.margin_m()));
  auto path = rrt_connect(coarse, start, goals, seed, options.search);
  if (!path.ok()) return explained(path.error(), checker, start, goals);
  JointPath shorter = shortcut(coarse, *path, seed, options.shortcuts);
  if (path_free(fine, shorter)) return shorter;
  // Something thin lies between two coarse steps.
  if (!path_free(fine, *path)) {
    path = rrt_connect(fine, start, goals, seed.child("fine"), options.search);
    if (!path.ok()) return explained(path.error(), checker, start, goals);
  }
  return shortcut(fine, *std::move(path), seed, options.shortcuts);
}

Result<ArmPlan> plan_arm(const ArmChecker& checker,
                         const Configuration& start,
                         const std::vector<Configuration>& goals,
                         Seed seed,
                         const ArmPlanOptions& options) {
  MARKETGEN_TRY(const auto limits, motion_limits(checker.model(), options));
  ArmPlan plan;
  MARKETGEN_TRY(plan.path, plan_arm_path(checker, start, goals, seed, options));
  MARKETGEN_TRY(plan.trajectory, timed_path(plan.path, limits));
  return plan;
}

Result<ArmPlan> plan_arm(const robots::Robot& robot,
                         const ArmQuestion& question,
                         const CollisionWorld& world,
                         Seed seed,
                         const ArmPlanOptions& options) {
  MARKETGEN_TRY(const ArmModel model, make_arm_model(robot, question.group));
  MARKETGEN_TRY(
      const ArmChecker checker,
      ArmChecker::make(model, question.state, question.world_from_base, world, question.check));
  const Configuration start = robots::values_of(model.group, question.state);
  return plan_arm(checker, start, question.goals, seed, options);
}

Result<std::vector<Configuration>> arm_goals(const robots::Robot& robot,
                                             const robots::JointGroup& group,
                                             const Pose& base_from_tip,
                                             const Configuration& near,
                                             int sweep) {
  MARKETGEN_TRY(const robots::ArmIk arm, robots::make_arm_ik(robot, group));
  const bool swivels = arm.family == robots::ArmFamily::rm75;
  const double low = swivels ? -3.14159 : arm.lower[6],
               high = swivels ? 3.14159 : arm.upper_limit[6];
  const int values = arm.family == robots::ArmFamily::rm65 ? 1 : std::max(sweep, 1);
  std::vector<std::pair<double, Configuration>> found;
  for (int i = 0; i < values; ++i) {
    const double redundancy = low + (high - low) * (i + 0.5) / values;
    for (const robots::ArmJoints& joints : robots::solve_arm(arm, base_from_tip, redundancy)) {
      const Configuration q(joints.begin(), joints.begin() + arm.joints);
      double away = 0;
      for (std::size_t j = 0; j < q.size() && j < near.size(); ++j)
        away = std::max(away, std::abs(q[j] - near[j]));
      found.emplace_back(away, q);
    }
  }
  if (found.empty())
    return Error{"robot.unreachable", group.name, "no joint values bring the tip to this pose"};
  std::sort(found.begin(), found.end());
  std::vector<Configuration> goals;
  for (auto& [away, q] : found)
    goals.push_back(std::move(q));
  return goals;
}

}  // namespace marketgen::motion
