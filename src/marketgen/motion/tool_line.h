// Straight lines of a tool: the last stretch to a grasp, and the way out again.
//
// On a line the tip moves straight and turns evenly; the arm's other freedom follows by small steps
// of damped least squares, so that no joint jumps. Two checkers, because what is to be grasped is
// an obstacle on the way to it and none on the line: `way` holds it, `line` does not, and on the
// way out both may carry it (ArmCheckOptions::attached).
#pragma once
#include "motion/plan_arm.h"

namespace marketgen::motion {

struct ToolLineOptions {
  double step_m = 0.01;       // of the tip between two postures of the line
  double step_rad = 0.05;     // of its turn
  double farthest_rad = 0.3;  // most that a joint moves between two postures, rad or m
  double speed = 0.3;         // share of each velocity limit that is used on the line, over 0 to 1
};

// Postures, evenly along the line, that bring the tip of the checker's group from where it is at
// `start` to `base_from_tip` (the group's base link); `start` is the first. Every motion between
// two is free. Errors: motion.bad_configuration; motion.bad_limits (options); robot.unreachable
// with the share of the line that was reached; motion.line_blocked with what touches what;
// motion.start_in_collision.
Result<JointPath> tool_line(const ArmChecker& checker,
                            const Configuration& start,
                            const Pose& base_from_tip,
                            const ToolLineOptions& options = {});

struct ReachQuestion {
  Configuration start;
  Pose base_from_grasp;      // where the tip is to end; the group's base link
  Vec3 approach{0, 0, 0.1};  // from where the line begins to the grasp, in the tip's frame; m
};

struct ReachPlan {
  JointPath way;               // from the start to where the line begins
  JointPath line;              // from there to the grasp
  JointTrajectory trajectory;  // of both, at rest between them
};

// A way to where the line begins, then the line. Joint values for that place are tried from the
// nearest to the start on; those whose line is blocked are passed over. Errors: those of
// tool_line() and plan_arm(); of several values that failed, the one that came farthest.
Result<ReachPlan> plan_reach(const ArmChecker& way,
                             const ArmChecker& line,
                             const ReachQuestion& question,
                             Seed seed,
                             const ArmPlanOptions& options = {},
                             const ToolLineOptions& line_options = {});

// The way back: from `grasp` by a straight line to `base_from_clear`, then to the first of `goals`
// that is reached. Errors as above.
struct LeaveQuestion {
  Configuration grasp;
  Pose base_from_clear;
  std::vector<Configuration> goals;
};
struct LeavePlan {
  JointPath line, way;
  JointTrajectory trajectory;
};
Result<LeavePlan> plan_leave(const ArmChecker& line,
                             const ArmChecker& way,
                             const LeaveQuestion& question,
                             Seed seed,
                             const ArmPlanOptions& options = {},
                             const ToolLineOptions& line_options = {});

}  // namespace marketgen::motion
