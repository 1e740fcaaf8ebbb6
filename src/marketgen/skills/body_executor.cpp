#include "skills/body_executor.h"

#include <algorithm>
#include <cmath>

#include "skills/people_about.h"

namespace marketgen::skills {
namespace {

constexpr double body_step_s = 0.05;
// Of the errors along, across and about, per second: Kanayama et al., "A stable tracking control
// method for an autonomous mobile robot", ICRA 1990.
constexpr double along_gain = 2, across_gain = 8, turn_gain = 3;
constexpr double straight_m_s2 = 0.3;  // of short ways to and from a shelf
constexpr double straight_jerk_m_s3 = 3;
constexpr double jerk_time_s = 0.05;

// A drive is over when the base stands where it was to go, or no nearer after a while: across its
// heading it cannot be moved without going to and fro.
constexpr double near_m = 0.002, near_rad = 0.002, max_settling_s = 1.0;

// So long it waits for people in its way.
constexpr double patience_with_people_s = 3;

double wrapped(double angle) {
  return std::remainder(angle, 2 * M_PI);
}

// The number of the contact limit that feels what presses on the link of this joint.
std::optional<std::size_t> limit_of_dof(const robots::Robot& robot, int dof) {
  const int link = robot.dofs[static_cast<std::size_t>(dof)] + 1;
  for (std::size_t limit = 0; limit < robot.contact_limits.size(); ++limit) {
    const std::vector<int> links = robots::links_from(robot, robot.contact_limits[limit].link);
    if (std::ranges::find(links, link) != links.end()) return limit;
  }
  return std::nullopt;
}

}  // namespace

BodyExecutor::BodyExecutor(const robots::Robot& robot, std::vector<int> commanded)
    : robot_(&robot), commanded_(std::move(commanded)) {}

void BodyExecutor::start(const agent::Observation& now) {
  queue_.clear();
  retrace_.start();
  was_stopped_ = was_held_up_ = false;
  held_up_s_ = 0;
  felt_share_ = 0;
  played_s_ = 0;
  position_ = queued_position_ = now.position;
  subtask_ = played_for_ = agent::Subtask::none;
  tools_.clear();
  for (const double opening : now.openings_m)
    tools_.push_back({opening});
}

std::size_t BodyExecutor::column_of(int dof) const {
  return static_cast<std::size_t>(std::ranges::find(commanded_, dof) - commanded_.begin());
}

void BodyExecutor::push(Motion motion) {
  was_stopped_ = was_held_up_ = false;
  motion.subtask = subtask_;
  queue_.push_back(std::move(motion));
}

void BodyExecutor::follow(motion::BaseFollower follower) {
  Motion motion;
  motion.base = std::move(follower);
  push(std::move(motion));
}

Result<void> BodyExecutor::drive_straight(double distance_m, double speed_m_s) {
  Motion motion;
  motion.straight = true;
  MARKETGEN_TRY(
      motion.trajectory,
      motion::timed_path({{0.0}, {distance_m}}, {{speed_m_s, straight_m_s2, straight_jerk_m_s3}}));
  motion.duration_s = motion.trajectory.duration_s();
  push(std::move(motion));
  return {};
}

void BodyExecutor::play(const std::vector<int>& dofs, motion::JointTrajectory trajectory) {
  Motion motion;
  for (const int dof : dofs)
    motion.columns.push_back(column_of(dof));
  motion.duration_s = trajectory.duration_s();
  const std::vector<double> end = trajectory.at(motion.duration_s).position;
  for (std::size_t i = 0; i < end.size(); ++i)
    queued_position_[motion.columns[i]] = end[i];
  motion.trajectory = std::move(trajectory);
  push(std::move(motion));
}

void BodyExecutor::feel(const std::vector<int>& dofs,
                        motion::JointTrajectory trajectory,
                        double max_force_n) {
  play(dofs, std::move(trajectory));
  felt_share_ = 0;
  queue_.back().max_force_n = max_force_n;
  if (!dofs.empty()) queue_.back().arm = limit_of_dof(*robot_, dofs.back());
}

Result<void> BodyExecutor::move_joint(int dof, double to, double speed_share) {
  const robots::Joint& joint = robot_->joint_of_dof(static_cast<std::size_t>(dof));
  const double speed = joint.velocity * speed_share, quickly = joint.acceleration * speed_share;
  const motion::MotionLimits limits{speed, quickly, quickly / jerk_time_s};
  const double from = queued_position_[column_of(dof)];
  MARKETGEN_TRY(motion::JointTrajectory way,
                motion::timed_path({{from}, {std::clamp(to, joint.lower, joint.upper)}}, {limits}));
  play({dof}, std::move(way));
  return {};
}

void BodyExecutor::grip(int tool, agent::ToolCommand command) {
  Motion motion;
  motion.grip = {static_cast<std::size_t>(tool), command};
  push(std::move(motion));
}

void BodyExecutor::wait(double seconds) {
  Motion motion;
  motion.duration_s = seconds;
  push(std::move(motion));
}

// From where the base is to where the follower is now.
BodyExecutor::BaseError BodyExecutor::error_of(const motion::BaseFollower& wanted,
                                               const agent::Observation& now) const {
  const motion::BaseState& to = wanted.state();
  const double axle = robot_->drive ? robot_->drive->axle_x : 0;
  const double heading = now.base.heading;
  const double dx = to.position.x - (now.base.x_m + axle * std::cos(heading)),
               dy = to.position.y - (now.base.y_m + axle * std::sin(heading));
  return {dx * std::cos(heading) + dy * std::sin(heading),
          dy * std::cos(heading) - dx * std::sin(heading),
          wrapped(to.heading - heading)};
}

void BodyExecutor::steer(const motion::BaseFollower& wanted,
                         const agent::Observation& now,
                         agent::Action& action) const {
  const motion::BaseState& to = wanted.state();
  const BaseError off = error_of(wanted, now);
  action.drive_m_s = to.speed * std::cos(off.turn) + along_gain * off.along;
  action.turn_rad_s = to.turn_rate + to.speed * across_gain * off.across + turn_gain * off.turn;
}

bool BodyExecutor::is_over(Motion& motion, const agent::Observation& now) const {
  if (!motion.base) return played_s_ >= motion.duration_s;
  if (!motion.base->done()) return false;
  const BaseError off = error_of(*motion.base, now);
  motion.settling_s += body_step_s;
  return motion.settling_s > max_settling_s ||
         (std::abs(off.along) < near_m && std::abs(off.turn) < near_rad);
}

void BodyExecutor::play_step(Motion& motion, const agent::Observation& now, agent::Action& action) {
  played_s_ += body_step_s;
  if (motion.base) {
    motion.base->step(body_step_s, people_about(now));
    steer(*motion.base, now, action);
  } else if (motion.straight && held_up_s_ > 0) {
    played_s_ -= body_step_s;  // stands until they have gone
  } else if (motion.straight) {
    action.drive_m_s = motion.trajectory.at(std::min(played_s_, motion.duration_s)).velocity[0];
    if (played_s_ >= motion.duration_s) action.drive_m_s = 0;
  } else if (!motion.columns.empty()) {
    const std::vector<double> q = motion.trajectory.at(played_s_).position;
    for (std::size_t i = 0; i < q.size(); ++i)
      position_[motion.columns[i]] = q[i];
  }
}

// A way that is felt ends here, where enough presses on its arm.
void BodyExecutor::end_touch(const agent::Observation& now) {
  if (queue_.empty() || now.stopped || !queue_.front().arm || now.external_force_n.empty()) return;
  const Motion& motion = queue_.front();
  if (now.external_force_n[*motion.arm] <= motion.max_force_n) return;
  felt_share_ = std::min(1.0, played_s_ / motion.duration_s);
  queued_position_ = position_;
  queue_.pop_front();
  played_s_ = 0;
}

void BodyExecutor::go_back(agent::Action& action) {
  if (const auto step = retrace_.back()) {
    position_ = step->position;
    action.drive_m_s = step->drive_m_s;
    action.turn_rad_s = step->turn_rad_s;
  }
  queued_position_ = position_;
}

// Of the base's ways. A straight one to or from a shelf ends where it is then; what is queued
// behind it goes on.
bool BodyExecutor::waits_too_long(const Motion& motion, const agent::Observation& now) {
  const bool back = motion.straight && motion.trajectory.at(motion.duration_s).position[0] < 0;
  const bool waits = motion.base ? motion.base->waits() : motion.straight && is_in_way(now, back);
  held_up_s_ = waits ? held_up_s_ + body_step_s : 0;
  return held_up_s_ > patience_with_people_s;
}

void BodyExecutor::end_motion() {
  if (queue_.front().arm) felt_share_ = 1;
  if (was_held_up_) {
    queue_.clear();
    queued_position_ = position_;
  } else {
    queue_.pop_front();
  }
  played_s_ = held_up_s_ = 0;
}

agent::Action BodyExecutor::next(const agent::Observation& now) {
  agent::Action action;
  if (retrace_.begins(now)) {
    queue_.clear();
    played_s_ = 0;
    was_stopped_ = true;
  }
  const bool goes_back = retrace_.goes_back();
  if (!goes_back) end_touch(now);
  if (goes_back && !now.stopped) go_back(action);
  while (!queue_.empty() && queue_.front().grip) {
    const auto& [tool, command] = *queue_.front().grip;
    tools_[tool] = command;
    queue_.pop_front();
  }
  played_for_ = now.stopped || goes_back ? agent::Subtask::recover : subtask_of_first();
  if (!queue_.empty() && !now.stopped) {
    Motion& motion = queue_.front();
    const bool gives_up = waits_too_long(motion, now);
    was_held_up_ = gives_up && motion.base;
    if (!gives_up) play_step(motion, now, action);
    if (motion.base || motion.trajectory.joints() > 0)
      retrace_.tell({position_, action.drive_m_s, action.turn_rad_s});
    if (gives_up || is_over(motion, now)) end_motion();
  }
  action.position = position_;
  action.tools = tools_;
  return action;
}

}  // namespace marketgen::skills
