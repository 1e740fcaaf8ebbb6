#include "motion/tool_line.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "robots/numeric_ik.h"
#include "robots/rotation.h"

namespace marketgen::motion {
namespace {

constexpr int max_steps = 10'000;  // of one line: 100 m

bool in_range(double value, double most) {
  return value > 0 && value <= most;
}

Result<void> check_options(const ToolLineOptions& o) {
  if (in_range(o.step_m, 1) && in_range(o.step_rad, 1) && in_range(o.farthest_rad, 10) &&
      in_range(o.speed, 1))
    return {};
  return Error{"motion.bad_limits",
               "options of the tool's line",
               "step_m, step_rad and speed are over 0 to 1, farthest_rad is over 0 to 10"};
}

Error bad_question(const std::string& what) {
  return {"motion.bad_configuration", "tool's line", what};
}

// A line of the tip in the frame of the robot's root.
struct Line {
  Pose from;
  Vec3 move, turn;  // turn: axis times angle

  Pose at(double share) const {
    const double angle = length(turn);
    return {
        from.position + move * share,
        rotation_about(angle > 0 ? turn / angle : Vec3{0, 0, 1}, angle * share) * from.rotation};
  }
};

Result<void> check_question(const ArmModel& model, const Configuration& start, const Pose& to) {
  if (model.group.tip < 0)
    return Error{"robot.unknown", model.group.name, "the group moves no tip: no line to follow"};
  if (start.size() != model.lower.size())
    return bad_question(fmt::format(
        "the start has {} joint values, the group {} joints", start.size(), model.lower.size()));
  for (const double q : start) {
    if (!std::isfinite(q)) return bad_question("a joint value of the start is not a number");
  }
  const Quaternion& r = to.rotation;
  const double norm = r.w * r.w + r.x * r.x + r.y * r.y + r.z * r.z;
  if (!is_finite(to.position) || !(std::abs(norm - 1) < 1e-6))
    return bad_question("the pose to go to is not finite, or its rotation is no unit quaternion");
  return {};
}

// Where a search for a line ended: whole, or stopped at a share of it.
struct Walk {
  JointPath path;
  double share = 0;
  Error error;
};

Error out_of_reach(const ArmModel& model, double share) {
  return {"robot.unreachable",
          model.group.name,
          fmt::format("the tool's line can be followed for {:.0f} % of its length; move the base, "
                      "or come from another side",
                      100 * share)};
}

Walk walk(const ArmChecker& checker,
          const Line& line,
          const Configuration& start,
          const ToolLineOptions& options) {
  const ArmModel& model = checker.model();
  const double steps = std::ceil(
      std::max({length(line.move) / options.step_m, length(line.turn) / options.step_rad, 1.0}));
  Walk walk{{start}, 0, out_of_reach(model, 0)};
  if (!(steps <= max_steps)) return walk;
  std::vector<double> state = checker.state_with(start);
  robots::NumericIkOptions descent;
  descent.restarts = 0;
  for (int i = 1; i <= static_cast<int>(steps); ++i) {
    const double share = i / steps;
    const auto next = robots::solve_numeric(
        *model.robot, model.group.tip, model.group.dofs, line.at(share), state, Seed(0), descent);
    if (!next.ok()) return walk;
    const Configuration q = robots::values_of(model.group, *next);
    double farthest = 0;
    for (std::size_t j = 0; j < q.size(); ++j)
      farthest = std::max(farthest, std::abs(q[j] - walk.path.back()[j]));
    if (farthest > options.farthest_rad) return walk;
    if (!checker.motion_free(walk.path.back(), q, 2 * checker.margin_m())) {
      walk.error = {"motion.line_blocked",
                    fmt::format("{:.0f} % of the tool's line", 100 * share),
                    checker.collision(q)};
      return walk;
    }
    walk.path.push_back(q);
    walk.share = share;
    walk.error = out_of_reach(model, share);
    state = *next;
  }
  return walk;
}

Walk walk_to(const ArmChecker& checker,
             const Configuration& start,
             const Pose& base_from_tip,
             const ToolLineOptions& options) {
  const ArmModel& model = checker.model();
  const std::vector<double> state = checker.state_with(start);
  const Pose root_from_base =
      robots::link_poses(*model.robot, state)[static_cast<std::size_t>(model.group.base)];
  const Pose from = robots::frame_pose(*model.robot, state, model.group.tip);
  const Pose to = root_from_base * base_from_tip;
  const Line line{from,
                  to.position - from.position,
                  robots::rotation_vector(to.rotation * inverse(from.rotation))};
  if (!checker.free(start)) {
    return {{},
            -1,
            {"motion.start_in_collision", "start of the tool's line", checker.collision(start)}};
  }
  return walk(checker, line, start, options);
}

Result<JointTrajectory> timed_line(const ArmModel& model,
                                   const JointPath& line,
                                   ArmPlanOptions options,
                                   double speed) {
  options.speed *= speed;
  MARKETGEN_TRY(const auto limits, motion_limits(model, options));
  return timed_curve(line, limits);
}

// The line from joint values that the way must be able to end with.
Walk line_from(const ArmChecker& way,
               const ArmChecker& line,
               const Configuration& begin,
               const Pose& base_from_grasp,
               const ToolLineOptions& options) {
  if (way.free(begin)) return walk_to(line, begin, base_from_grasp, options);
  return {{}, -1, {"motion.goal_in_collision", "start of the tool's line", way.collision(begin)}};
}

Result<ReachPlan> timed_reach(const ArmModel& model,
                              ReachPlan plan,
                              const ArmPlanOptions& options,
                              const ToolLineOptions& line_options) {
  MARKETGEN_TRY(const auto limits, motion_limits(model, options));
  MARKETGEN_TRY(plan.trajectory, timed_path(plan.way, limits));
  MARKETGEN_TRY(const auto last, timed_line(model, plan.line, options, line_options.speed));
  plan.trajectory.append(last);
  return plan;
}

}  // namespace

Result<JointPath> tool_line(const ArmChecker& checker,
                            const Configuration& start,
                            const Pose& base_from_tip,
                            const ToolLineOptions& options) {
  MARKETGEN_CHECK(check_options(options));
  MARKETGEN_CHECK(check_question(checker.model(), start, base_from_tip));
  Walk walk = walk_to(checker, start, base_from_tip, options);
  if (walk.share < 1) return walk.error;
  return std::move(walk.path);
}

Result<ReachPlan> plan_reach(const ArmChecker& way,
                             const ArmChecker& line,
                             const ReachQuestion& question,
                             Seed seed,
                             const ArmPlanOptions& options,
                             const ToolLineOptions& line_options) {
  const ArmModel& model = way.model();
  MARKETGEN_CHECK(check_options(line_options));
  MARKETGEN_CHECK(check_question(model, question.start, question.base_from_grasp));
  if (!is_finite(question.approach)) return bad_question("the approach is not finite");
  Pose begin = question.base_from_grasp;
  begin.position = begin.position - rotate(begin.rotation, question.approach);
  MARKETGEN_TRY(const auto values, arm_goals(*model.robot, model.group, begin, question.start));
  Walk best;
  best.share = -2;
  for (const Configuration& q : values) {
    Walk tried = line_from(way, line, q, question.base_from_grasp, line_options);
    if (tried.share == 1) {
      auto path = plan_arm_path(way, question.start, {q}, seed, options);
      if (path.ok())
        return timed_reach(
            model, {*std::move(path), std::move(tried.path), {}}, options, line_options);
      if (path.error().code != "motion.no_path") return path.error();
      tried.error = path.error();
    }
    if (tried.share > best.share) best = std::move(tried);
  }
  return best.error;
}

Result<LeavePlan> plan_leave(const ArmChecker& line,
                             const ArmChecker& way,
                             const LeaveQuestion& question,
                             Seed seed,
                             const ArmPlanOptions& options,
                             const ToolLineOptions& line_options) {
  LeavePlan plan;
  MARKETGEN_TRY(plan.line, tool_line(line, question.grasp, question.base_from_clear, line_options));
  MARKETGEN_TRY(const ArmPlan rest, plan_arm(way, plan.line.back(), question.goals, seed, options));
  plan.way = rest.path;
  MARKETGEN_TRY(plan.trajectory, timed_line(line.model(), plan.line, options, line_options.speed));
  plan.trajectory.append(rest.trajectory);
  return plan;
}

}  // namespace marketgen::motion
