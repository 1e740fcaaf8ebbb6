#include "robots/impedance.h"

#include <cmath>

#include <Eigen/Cholesky>

#include "robots/dynamics.h"
#include "robots/rotation.h"

namespace marketgen::robots {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

// Least damping of the pseudo-inverse, so that a stretched arm stays tame.
constexpr double damping = 1e-6;

Vector6 wrench_of(const Pose& now, const Pose& goal, const Vector6& velocity, const Impedance& i) {
  const Vec3 move = goal.position - now.position;
  const Vec3 turn = rotation_vector(goal.rotation * inverse(now.rotation));
  Vector6 stiffness;
  stiffness << Eigen::Vector3d::Constant(i.stiffness_n_m),
      Eigen::Vector3d::Constant(i.turning_stiffness_n_m);
  Vector6 error;
  error << move.x, move.y, move.z, turn.x, turn.y, turn.z;
  const Vector6 damper = 2 * i.damping_ratio * stiffness.cwiseSqrt();
  return stiffness.cwiseProduct(error) - damper.cwiseProduct(velocity);
}

}  // namespace

Eigen::VectorXd impedance_efforts(const Robot& robot,
                                  int frame,
                                  std::span<const int> dofs,
                                  std::span<const double> q,
                                  std::span<const double> qd,
                                  const Pose& base_from_goal,
                                  std::span<const double> posture,
                                  const Impedance& impedance) {
  const auto count = static_cast<Eigen::Index>(dofs.size());
  const Jacobian all = frame_jacobian(robot, q, frame);
  Jacobian some(6, count);
  Eigen::VectorXd rates(count), pull(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto dof = static_cast<std::size_t>(dofs[static_cast<std::size_t>(i)]);
    some.col(i) = all.col(static_cast<Eigen::Index>(dof));
    rates[i] = qd[dof];
    pull[i] = impedance.posture_stiffness * (posture[dof] - q[dof]) -
              2 * std::sqrt(impedance.posture_stiffness) * qd[dof];
  }
  const Vector6 wrench =
      wrench_of(frame_pose(robot, q, frame), base_from_goal, some * rates, impedance);
  const Eigen::Matrix<double, 6, 6> damped =
      some * some.transpose() + damping * Eigen::Matrix<double, 6, 6>::Identity();
  const Eigen::VectorXd unfelt = pull - some.transpose() * damped.ldlt().solve(some * pull);
  const std::vector<double> still(q.size(), 0.0);
  const Eigen::VectorXd coriolis = inverse_dynamics(robot, q, qd, still, 0);
  Eigen::VectorXd efforts = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(q.size()));
  const Eigen::VectorXd drawn = some.transpose() * wrench + unfelt;
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto dof = static_cast<Eigen::Index>(dofs[static_cast<std::size_t>(i)]);
    efforts[dof] = drawn[i] + coriolis[dof];
  }
  return efforts;
}

}  // namespace marketgen::robots
