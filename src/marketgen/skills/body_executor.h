// Carries out what a policy decided for a robot that drives: ways of its base, its lift and its
// arms, one after another, one control step at a time. It knows nothing of what stands around.
#pragma once
#include <deque>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "agent/policy.h"
#include "motion/base_follower.h"
#include "motion/joint_trajectory.h"
#include "robots/robot.h"
#include "skills/retrace.h"

namespace marketgen::skills {

class BodyExecutor {
 public:
  // `commanded`: the degrees of freedom of an action's positions. The robot must outlive it.
  BodyExecutor(const robots::Robot& robot, std::vector<int> commanded);

  void start(const agent::Observation& now);  // forgets what is queued

  // What is queued from now on is for this.
  void set_subtask(agent::Subtask subtask) { subtask_ = subtask; }
  // What the last step of next() was for.
  agent::Subtask subtask() const { return played_for_; }

  // ---- Each queues a motion. ----
  void follow(motion::BaseFollower follower);
  // Error motion.bad_limits. Backwards where it is negative.
  Result<void> drive_straight(double distance_m, double speed_m_s);
  void play(const std::vector<int>& dofs, motion::JointTrajectory trajectory);
  // The same, until more than so much presses on the arm that those joints move; nothing else of
  // what is queued is broken off then. What is queued behind it begins where the arm is then, and
  // must not move it (grips, waits).
  void feel(const std::vector<int>& dofs, motion::JointTrajectory trajectory, double max_force_n);
  // One joint alone, at a share of its limits. Errors: motion.bad_limits.
  Result<void> move_joint(int dof, double to, double speed_share);
  void grip(int tool, agent::ToolCommand command);  // from then on
  void wait(double seconds);

  bool idle() const { return queue_.empty() && !retrace_.goes_back(); }
  // A protective stop breaks off what is queued: after it the robot goes back a second of its way,
  // and is idle.
  agent::Action next(const agent::Observation& now);
  // Whether what was queued last was broken off so. Says it once.
  bool take_stop() { return std::exchange(was_stopped_, false); }
  // Whether people kept the base from its way for some seconds: what was queued is broken off, and
  // the base stands. Says it once.
  bool take_held_up() { return std::exchange(was_held_up_, false); }
  // Of the way that was felt last, the share of its time that was gone: 1 at its end.
  double felt_share() const { return felt_share_; }
  // As its tool is told to be.
  const agent::ToolCommand& told(int tool) const { return tools_[static_cast<std::size_t>(tool)]; }

 private:
  struct Motion {
    std::optional<motion::BaseFollower> base;
    motion::JointTrajectory trajectory = {};  // of `dofs`; of the base's way when there are none
    std::vector<std::size_t> columns = {};    // in an action's positions
    double duration_s = 0;
    std::optional<std::pair<std::size_t, agent::ToolCommand>> grip = {};
    bool straight = false;
    double settling_s = 0;  // since the base's way was over
    agent::Subtask subtask = agent::Subtask::none;
    double max_force_n = 0;          // of one that is felt
    std::optional<std::size_t> arm;  // the one that feels it, in external_force_n
  };
  struct BaseError {
    double along = 0, across = 0, turn = 0;
  };
  void play_step(Motion& motion, const agent::Observation& now, agent::Action& action);
  bool waits_too_long(const Motion& motion, const agent::Observation& now);
  BaseError error_of(const motion::BaseFollower& wanted, const agent::Observation& now) const;
  void steer(const motion::BaseFollower& wanted,
             const agent::Observation& now,
             agent::Action& action) const;
  bool is_over(Motion& motion, const agent::Observation& now) const;
  void end_touch(const agent::Observation& now);
  void end_motion();
  agent::Subtask subtask_of_first() const {
    return queue_.empty() ? agent::Subtask::none : queue_.front().subtask;
  }
  std::size_t column_of(int dof) const;
  void push(Motion motion);
  void go_back(agent::Action& action);

  const robots::Robot* robot_;
  std::vector<int> commanded_;
  std::deque<Motion> queue_;
  double played_s_ = 0;  // of the first motion
  std::vector<double> position_;
  std::vector<double> queued_position_;  // at the end of the queue
  std::vector<agent::ToolCommand> tools_;
  agent::Subtask subtask_ = agent::Subtask::none;  // of what is queued
  agent::Subtask played_for_ = agent::Subtask::none;
  Retrace retrace_;
  bool was_stopped_ = false, was_held_up_ = false;
  double held_up_s_ = 0;
  double felt_share_ = 0;
};

}  // namespace marketgen::skills
