#include "robots/numeric_ik.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "robots/dynamics.h"
#include "robots/rotation.h"

namespace marketgen::robots {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

struct Problem {
  const Robot& robot;
  int frame;
  const std::vector<int>& dofs;
  Pose goal;
};

// What is left to the goal: translation, then rotation vector, base axes.
Vector6 error_of(const Problem& problem, const std::vector<double>& q) {
  const Pose now = frame_pose(problem.robot, q, problem.frame);
  const Vec3 move = problem.goal.position - now.position;
  const Vec3 turn = rotation_vector(problem.goal.rotation * inverse(now.rotation));
  Vector6 error;
  error << move.x, move.y, move.z, turn.x, turn.y, turn.z;
  return error;
}

const Joint& joint_of(const Problem& problem, int dof) {
  return problem.robot.joint_of_dof(static_cast<std::size_t>(dof));
}

bool pushes_out(const Joint& joint, double value, double step) {
  return (step < 0 && value <= joint.lower) || (step > 0 && value >= joint.upper);
}

// The damped step of the degrees of freedom, one per entry of `problem.dofs`. Those that stand at a
// limit and would leave it are taken out, so that the rest does the work.
Eigen::VectorXd step_within_limits(const Problem& problem,
                                   const std::vector<double>& q,
                                   const Vector6& error,
                                   double damping) {
  const Jacobian all = frame_jacobian(problem.robot, q, problem.frame);
  Jacobian some(6, static_cast<Eigen::Index>(problem.dofs.size()));
  for (std::size_t i = 0; i < problem.dofs.size(); ++i)
    some.col(static_cast<Eigen::Index>(i)) = all.col(problem.dofs[i]);
  Eigen::VectorXd step;
  for (bool again = true; again;) {
    const Eigen::Matrix<double, 6, 6> damped =
        some * some.transpose() + damping * Eigen::Matrix<double, 6, 6>::Identity();
    step = some.transpose() * damped.ldlt().solve(error);
    again = false;
    for (std::size_t i = 0; i < problem.dofs.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const double value = q[static_cast<std::size_t>(problem.dofs[i])];
      if (!pushes_out(joint_of(problem, problem.dofs[i]), value, step[column])) continue;
      some.col(column).setZero();
      again = true;
    }
  }
  return step;
}

std::vector<double> stepped(const Problem& problem,
                            std::vector<double> q,
                            const Vector6& error,
                            double damping) {
  const Eigen::VectorXd step = step_within_limits(problem, q, error, damping);
  for (std::size_t i = 0; i < problem.dofs.size(); ++i) {
    const Joint& joint = joint_of(problem, problem.dofs[i]);
    double& value = q[static_cast<std::size_t>(problem.dofs[i])];
    value = std::clamp(value + step[static_cast<Eigen::Index>(i)], joint.lower, joint.upper);
  }
  return q;
}

struct Try {
  std::vector<double> q;
  Vector6 error;

  double worst() const { return error.cwiseAbs().maxCoeff(); }
};

// Damping follows the squared error (Sugihara 2011): large steps far away, quadratic at the end.
Try descend(const Problem& problem, std::vector<double> q, const NumericIkOptions& options) {
  constexpr double min_damping = 1e-10;
  double bias = 1e-2;
  Vector6 error = error_of(problem, q);
  Try best{q, error};
  for (int i = 0; i < options.steps; ++i) {
    if (error.cwiseAbs().maxCoeff() < best.worst()) best = {q, error};
    if (best.worst() <= options.tolerance) return best;
    std::vector<double> next = stepped(problem, q, error, bias * error.squaredNorm() + min_damping);
    const Vector6 left = error_of(problem, next);
    if (left.squaredNorm() < error.squaredNorm()) {
      q = std::move(next), error = left;
      bias = std::max(bias / 4, 1e-6);
    } else {
      bias *= 8;
    }
  }
  return best;
}

std::vector<double> restarted(const Problem& problem,
                              std::vector<double> q,
                              Stream& draw,
                              double span) {
  for (const int dof : problem.dofs) {
    const Joint& joint = joint_of(problem, dof);
    double& value = q[static_cast<std::size_t>(dof)];
    const double low = std::isfinite(joint.lower) ? joint.lower : value - span;
    const double high = std::isfinite(joint.upper) ? joint.upper : value + span;
    value = draw.uniform(low, high);
  }
  return q;
}

Result<void> check_numbers(const Robot& robot, const std::vector<double>& seed, const Pose& goal) {
  if (seed.size() != robot.dof_count() ||
      !std::ranges::all_of(seed, [](double value) { return std::isfinite(value); }))
    return Error{"robot.bad_state",
                 robot.name,
                 fmt::format("the search began from {} joint values; expected {} finite ones",
                             seed.size(),
                             robot.dof_count())};
  const Quaternion& r = goal.rotation;
  if (!std::isfinite(length(goal.position) + r.w + r.x + r.y + r.z))
    return Error{"robot.unreachable", robot.name, "the goal is not finite"};
  return {};
}

std::vector<double> begun_within_limits(const Problem& problem, std::vector<double> q) {
  for (const int dof : problem.dofs) {
    const Joint& joint = joint_of(problem, dof);
    double& value = q[static_cast<std::size_t>(dof)];
    value = std::clamp(value, joint.lower, joint.upper);
  }
  return q;
}

}  // namespace

Result<NearestIk> nearest_numeric(const Robot& robot,
                                  int frame,
                                  const std::vector<int>& dofs,
                                  const Pose& base_from_frame,
                                  const std::vector<double>& seed,
                                  const Seed& random,
                                  const NumericIkOptions& options) {
  MARKETGEN_CHECK(check_numbers(robot, seed, base_from_frame));
  const Problem problem{robot, frame, dofs, base_from_frame};
  const std::vector<double> first = begun_within_limits(problem, seed);
  Stream draw = random.child("numeric_ik").stream();
  Try best = descend(problem, first, options);
  for (int i = 0; i < options.restarts && best.worst() > options.tolerance; ++i) {
    Try other = descend(problem, restarted(problem, first, draw, options.unlimited_span), options);
    if (other.worst() < best.worst()) best = std::move(other);
  }
  if (best.worst() <= options.tolerance) return NearestIk{std::move(best.q)};
  return NearestIk{std::move(best.q), best.error.head<3>().norm(), best.error.tail<3>().norm()};
}

Result<std::vector<double>> solve_numeric(const Robot& robot,
                                          int frame,
                                          const std::vector<int>& dofs,
                                          const Pose& base_from_frame,
                                          const std::vector<double>& seed,
                                          const Seed& random,
                                          const NumericIkOptions& options) {
  MARKETGEN_TRY(NearestIk best,
                nearest_numeric(robot, frame, dofs, base_from_frame, seed, random, options));
  if (best.exact()) return std::move(best.q);
  return Error{
      "robot.unreachable",
      robot.name + ":" + robot.frames[static_cast<std::size_t>(frame)].name,
      fmt::format("the nearest of {} tries stays {:.2g} m and {:.2g} rad off; move the goal "
                  "into reach or free more joints",
                  options.restarts + 1,
                  best.off_m,
                  best.off_rad)};
}

}  // namespace marketgen::robots
