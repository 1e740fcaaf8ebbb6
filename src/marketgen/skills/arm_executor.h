// Carries out what a policy decided: plans collision-free motions of one arm and plays them, one
// control step after another. It knows obstacles as it is told them, and nothing else.
//
// Motions are queued; each is planned from where the last one ends. Base frame of the arm's group,
// SI units.
#pragma once
#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "agent/policy.h"
#include "motion/tool_line.h"
#include "robots/robot.h"
#include "skills/retrace.h"

namespace marketgen::skills {

struct ExecutorOptions {
  double step_s = 0.05;                     // between two actions
  double speed = 0.6;                       // share of the joints' velocity limits on free ways
  double line_speed = 0.25;                 // on straight lines
  double felt_speed = 0.05, felt_m = 0.10;  // at the end of one that is guarded
  double acceleration = 0.35;               // share of the joints' acceleration limits
  double way_margin_m = 0.004, line_margin_m = 0.002;  // kept from obstacles
  int max_samples = 3000;                              // of one search
};

// `way`: on free ways, and for the arm everywhere. `line`: for the hand on straight lines, without
// what it may touch there.
struct Surroundings {
  motion::Obstacles way, line;
};

struct ReachRequest {
  Pose base_from_tip;    // where the tip is to end
  Vec3 approach;         // of the straight line to there, tip frame
  double opening_m = 0;  // of the gripper meanwhile; 0 presses
  double force_n = 20;
  std::vector<motion::AttachedObject> attached = {};  // on the free way
  bool stops_before = false;  // where the straight line begins; that it can be gone is certain
  double max_force_n = 0;     // as guard() has it; then the end of the straight line is gone slowly
};

class ArmExecutor {
 public:
  // Plans for the group "arm". Errors: of make_arm_model and make_arm_ik. The robot must outlive
  // it.
  static Result<ArmExecutor> make(const robots::Robot& robot, const ExecutorOptions& options = {});

  void start(const agent::Observation& now);  // forgets what is queued; stands where the arm is

  // What is queued from now on is for this.
  void set_subtask(agent::Subtask subtask) { subtask_ = subtask; }
  // What the last step of next() was for.
  agent::Subtask subtask() const { return played_for_; }

  // ---- Each queues a motion. Errors: as plan_reach and tool_line; nothing is queued then. ----
  Result<void> reach(const Surroundings& around, const ReachRequest& request, Seed seed);
  // The tip straight to a pose.
  Result<void> straight(const Surroundings& around,
                        const Pose& base_from_tip,
                        double opening_m,
                        double force_n);
  // The tip down, 10 cm or as far of that as goes.
  Result<void> let_down(const Surroundings& around, double force_n);
  void wait(double seconds, double opening_m, double force_n);
  // What is queued last ends, and all behind it with it, where more than `max_force_n` presses on
  // the arm; the arm goes back a tenth of a second of its way. 0: until it stops for its own sake.
  void guard(double max_force_n) { queue_.back().max_force_n = max_force_n; }

  // How far apart the pads are while they press on something: fingers are looked at there.
  void hold(double opening_m) { held_m_ = opening_m; }

  bool idle() const { return queue_.empty() && !retrace_.goes_back(); }
  // Of the next control step; stands still when idle. A protective stop breaks off what is queued:
  // after it the arm goes back a second of its way, and is idle.
  agent::Action next(const agent::Observation& now);
  // Whether what was queued last was broken off so. Says it once.
  bool take_stop() { return std::exchange(was_stopped_, false); }
  // Whether what was queued last ended at a guard. Says it once.
  bool take_touch() { return std::exchange(was_touched_, false); }
  // Whether the gripper is told to press.
  bool presses() const { return opening_m_ <= 0; }

  Pose tip() const;  // base_from_tip, where the queued motions end
  const motion::Configuration& posture() const { return end_; }
  // The greatest joint difference from where the queued motions end to the nearest posture that
  // brings the tip there; empty when none does.
  std::optional<double> effort_to(const Pose& base_from_tip) const;

 private:
  struct Motion {
    motion::JointTrajectory trajectory;  // empty: stands still
    double duration_s = 0, opening_m = 0, force_n = 0;
    agent::Subtask subtask = agent::Subtask::none;
    double max_force_n = 0;
  };
  ArmExecutor() = default;
  std::vector<double> state(double opening_m) const;
  Result<std::vector<motion::MotionLimits>> limits(double speed) const;
  Result<motion::ArmChecker> line_checker(const std::vector<double>& state,
                                          const motion::CollisionWorld& way,
                                          const motion::CollisionWorld& line) const;
  double opening_for(double asked_m) const;
  Result<motion::JointTrajectory> timed_line(const motion::JointPath& line,
                                             const ReachRequest& request) const;
  void queue(motion::JointTrajectory trajectory, double opening_m, double force_n);
  bool is_at_guard(const agent::Observation& now) const;
  agent::Subtask subtask_at(const agent::Observation& now) const;
  void break_off();
  void go_back();

  const robots::Robot* robot_ = nullptr;
  std::shared_ptr<const motion::ArmModel> model_;
  std::vector<int> hand_;  // links that the group's last joint moves
  ExecutorOptions options_;
  std::deque<Motion> queue_;
  double played_s_ = 0;              // of the first motion in the queue
  motion::Configuration now_, end_;  // commanded last; at the end of the queue
  double opening_m_ = 0, force_n_ = 0;
  double held_m_ = 0;
  agent::Subtask subtask_ = agent::Subtask::none;  // of what is queued
  agent::Subtask played_for_ = agent::Subtask::none;
  Retrace retrace_;
  bool was_stopped_ = false, was_touched_ = false;
};

}  // namespace marketgen::skills
