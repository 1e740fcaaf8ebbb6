// From one posture of an arm to another: a path that touches nothing, with times.
//
// RRT-Connect, shortcuts, then straight pieces from rest to rest within each joint's velocity,
// acceleration and jerk. The search takes coarse steps; the path it returns was tested in steps of
// twice the checker's margin, between which no posture can touch the world. A search ends after a
// number of samples, never after a time: the same question has the same answer on every machine
// and for any number of threads.
#pragma once
#include <vector>

#include "base/result.h"
#include "base/seed.h"
#include "motion/arm_checker.h"
#include "motion/joint_trajectory.h"

namespace marketgen::motion {

struct ArmPlanOptions {
  RrtOptions search;
  double coarse_step_m = 0.03;  // farthest that a point of the arm moves between two tests
  int shortcuts = 25;           // random chords that are tried
  double speed = 1;             // share of each velocity limit that is used, over 0 to 1
  double acceleration = 1;      // the same of each acceleration limit
  double jerk_time_s = 0.05;    // to full acceleration, of joints whose row has no jerk limit
};

struct ArmPlan {
  JointPath path;  // start, corners, end; of the group's joints
  JointTrajectory trajectory;
};

// Limits of the group's joints from the robot's row. Error: motion.bad_limits names a joint that
// has no velocity or acceleration, or an option that is not positive.
Result<std::vector<MotionLimits>> motion_limits(const ArmModel& model,
                                                const ArmPlanOptions& options = {});

// To the first of `goals` that is reached. Errors: motion.bad_configuration (count, NaN, outside
// the limits), motion.start_in_collision and motion.goal_in_collision with what touches what,
// motion.no_path when the samples are used up, motion.bad_limits.
Result<ArmPlan> plan_arm(const ArmChecker& checker,
                         const Configuration& start,
                         const std::vector<Configuration>& goals,
                         Seed seed,
                         const ArmPlanOptions& options = {});

// The path alone; the part of plan_arm() that searches.
Result<JointPath> plan_arm_path(const ArmChecker& checker,
                                const Configuration& start,
                                const std::vector<Configuration>& goals,
                                Seed seed,
                                const ArmPlanOptions& options = {});

// For one question: makes the checker too. `state` holds every degree of freedom, the arm's start
// among them. Errors: those of make_arm_model, ArmChecker::make and above.
struct ArmQuestion {
  std::string group = "arm";
  std::vector<double> state;
  std::vector<Configuration> goals;
  Pose world_from_base;
  ArmCheckOptions check;
};
Result<ArmPlan> plan_arm(const robots::Robot& robot,
                         const ArmQuestion& question,
                         const CollisionWorld& world,
                         Seed seed,
                         const ArmPlanOptions& options = {});

// Every solution of the group's analytic inverse kinematics for a tip pose in the group's base
// link, over `sweep` values of the redundancy, nearest to `near` first (largest joint difference).
// Errors: those of make_arm_ik; robot.unreachable.
Result<std::vector<Configuration>> arm_goals(const robots::Robot& robot,
                                             const robots::JointGroup& group,
                                             const Pose& base_from_tip,
                                             const Configuration& near,
                                             int sweep = 16);

}  // namespace marketgen::motion
