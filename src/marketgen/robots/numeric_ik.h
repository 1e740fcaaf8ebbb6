// Inverse kinematics of any frame by damped least squares: users' robots, and base + lift + arm
// together.
#pragma once
#include <vector>

#include "base/seed.h"
#include "robots/robot.h"

namespace marketgen {

struct NumericIkOptions {
  int restarts = 20;        // after the seed itself
  int steps = 60;           // of each start
  double tolerance = 1e-9;  // m and rad, of the largest error component
  double unlimited_span =
      1;  // restarts move joints without limits this far from the seed, rad or m
};

// Moves the degrees of freedom `dofs` of `seed` until `frame` is at `base_from_frame`; the others
// stay. The result is within the limits. The first start is `seed`, the others are drawn from
// `random`: the same arguments give the same answer (Levenberg-Marquardt; Sugihara 2011). Errors:
// robot.bad_state for a seed of the wrong length or not finite; robot.unreachable with the error
// that was left at the best try.
Result<std::vector<double>> solve_numeric(const Robot& robot,
                                          int frame,
                                          const std::vector<int>& dofs,
                                          const Pose& base_from_frame,
                                          const std::vector<double>& seed,
                                          const Seed& random,
                                          const NumericIkOptions& options = {});

}  // namespace marketgen
