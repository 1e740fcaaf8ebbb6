// A joint path with times: every joint within its velocity, acceleration and jerk limits.
//
// Two forms. A path of straight pieces (what the planner returns) rests for an instant at every
// corner, so the robot goes exactly along the pieces that were checked. A dense row of
// configurations (a tool's straight line) becomes one C2 cubic spline, run through without a stop.
// Ruckig's library times neither: paths through given points are a service of its makers.
#pragma once
#include <vector>

#include "base/result.h"
#include "motion/rrt_connect.h"
#include "motion/s_curve.h"

namespace marketgen::motion {

struct TrajectoryState {
  std::vector<double> position, velocity, acceleration;
};

class JointTrajectory {
 public:
  double duration_s() const;
  TrajectoryState at(double time_s) const;  // before 0 and after the end: at rest there
  std::size_t joints() const { return joints_; }
  void append(const JointTrajectory& next);  // which starts where this one ends

 private:
  friend Result<JointTrajectory> timed_path(const JointPath&, const std::vector<MotionLimits>&);
  friend Result<JointTrajectory> timed_curve(const JointPath&, const std::vector<MotionLimits>&);

  // A spline over the parameter 0 .. knots - 1 and how the parameter moves.
  struct Piece {
    JointPath knots;
    JointPath bends;  // second derivatives at the knots
    SCurve motion;
    double start_s = 0;
  };
  void add(JointPath knots, const std::vector<MotionLimits>& limits);

  std::size_t joints_ = 0;
  std::vector<Piece> pieces_;
};

// `limits`: one a joint. Straight pieces, at rest in the corners; each is as quick as its slowest
// joint allows. Errors: motion.bad_limits (not positive and finite), motion.bad_configuration
// (empty path, sizes that differ, NaN).
Result<JointTrajectory> timed_path(const JointPath& path, const std::vector<MotionLimits>& limits);

// One smooth motion through every configuration; those are meant to lie evenly along the motion.
// Errors: as timed_path.
Result<JointTrajectory> timed_curve(const JointPath& knots,
                                    const std::vector<MotionLimits>& limits);

}  // namespace marketgen::motion
