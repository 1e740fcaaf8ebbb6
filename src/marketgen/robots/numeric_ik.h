// Inverse kinematics of any frame by damped least squares: users' robots, and base + lift + arm
// together.
#pragma once
#include <vector>

#include "base/seed.h"
#include "robots/robot.h"

namespace marketgen::robots {

struct NumericIkOptions {
  int restarts = 20;        // after the seed itself
  int steps = 60;           // of each start
  double tolerance = 1e-9;  // m and rad, of the largest error component
  double unlimited_span =
      1;  // restarts move joints without limits this far from the seed, rad or m
};

struct NearestIk {
  std::vector<double> q;
  double off_m = 0, off_rad = 0;  // of the frame from where it should be; exact: both 0

  bool exact() const { return off_m == 0 && off_rad == 0; }
};

// Moves the degrees of freedom `dofs` of `seed` until `frame` is at `base_from_frame`, or as near
// as the tries came: where a metre off is as bad as a radian. These end within their limits,
// wherever they began; the others stay as they are, whatever their limits: fingers that press on
// one another stand beyond theirs. The first start is `seed`, the others are drawn from `random`:
// the same arguments give the same answer (Levenberg-Marquardt; Sugihara 2011). Errors:
// robot.bad_state for a seed of the wrong length or not finite; robot.unreachable for a pose that
// is not finite.
Result<NearestIk> nearest_numeric(const Robot& robot,
                                  int frame,
                                  const std::vector<int>& dofs,
                                  const Pose& base_from_frame,
                                  const std::vector<double>& seed,
                                  const Seed& random,
                                  const NumericIkOptions& options = {});

// The state of nearest_numeric() where it is exact. Errors: as there; robot.unreachable with the
// error that was left at the best try.
Result<std::vector<double>> solve_numeric(const Robot& robot,
                                          int frame,
                                          const std::vector<int>& dofs,
                                          const Pose& base_from_frame,
                                          const std::vector<double>& seed,
                                          const Seed& random,
                                          const NumericIkOptions& options = {});

}  // namespace marketgen::robots
