// Jacobians and rigid-body dynamics of a Robot.
//
// Vectors have one entry per degree of freedom; frames and units as in robot.h. The base is fixed:
// a moving base has joints of its own. Gravity points along -Z of the base frame. Joints that
// follow others count as free ones. Preconditions: vectors have dof_count() entries. No errors.
#pragma once
#include <span>

#include <Eigen/Core>

#include "base/gravity.h"
#include "robots/robot.h"

namespace marketgen::robots {

using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;

// Velocity of a frame's origin (rows 0-2) and angular velocity (rows 3-5) per joint rate, both in
// the axes of the base frame.
Jacobian frame_jacobian(const Robot& robot, std::span<const double> q, int frame);

// Joint efforts that give the accelerations `qdd` at the state q, qd (recursive Newton-Euler;
// Featherstone, Rigid Body Dynamics Algorithms, 2008, table 5.1). Armature adds armature * qdd.
Eigen::VectorXd inverse_dynamics(const Robot& robot,
                                 std::span<const double> q,
                                 std::span<const double> qd,
                                 std::span<const double> qdd,
                                 double gravity = standard_gravity);

// Efforts that hold the robot still: inverse_dynamics with no motion.
Eigen::VectorXd gravity_efforts(const Robot& robot,
                                std::span<const double> q,
                                double gravity = standard_gravity);

// Joint-space inertia, symmetric, armature on the diagonal (composite rigid bodies; Featherstone
// 2008, table 6.2).
Eigen::MatrixXd mass_matrix(const Robot& robot, std::span<const double> q);

}  // namespace marketgen::robots
