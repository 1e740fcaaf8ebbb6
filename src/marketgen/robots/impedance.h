// Cartesian impedance: a frame that yields to forces like a damped spring.
#pragma once
#include <span>

#include <Eigen/Core>

#include "robots/robot.h"

namespace marketgen::robots {

// As in libfranka's example of Cartesian impedance: damping is critical for a unit mass.
struct Impedance {
  double stiffness_n_m = 400;
  double turning_stiffness_n_m = 30;  // N m/rad
  double damping_ratio = 1;           // of the frame, over 0
  double posture_stiffness =
      10;  // draws the joints to `posture` where the frame feels none, N m/rad
};

// Joint efforts beyond gravity that draw `frame` to `base_from_goal`, and `dofs`, as far as the
// frame does not feel it, to `posture`. Other entries are 0. `q`, `qd` and `posture` hold every
// degree of freedom. Preconditions: sizes match, `frame` exists.
Eigen::VectorXd impedance_efforts(const Robot& robot,
                                  int frame,
                                  std::span<const int> dofs,
                                  std::span<const double> q,
                                  std::span<const double> qd,
                                  const Pose& base_from_goal,
                                  std::span<const double> posture,
                                  const Impedance& impedance = {});

}  // namespace marketgen::robots
