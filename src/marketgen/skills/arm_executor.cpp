#include "skills/arm_executor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robots/arm_ik.h"

namespace marketgen::skills {
namespace {

constexpr std::array let_down_m{0.10, 0.06, 0.03};
constexpr int touch_back_steps = 2;  // of 0.05 s

// What the last joint of the group moves.
std::vector<int> hand_of(const robots::Robot& robot, const robots::JointGroup& group) {
  if (group.dofs.empty()) return {};
  return robots::links_from(robot,
                            robot.joint_of_dof(static_cast<std::size_t>(group.dofs.back())).link);
}

}  // namespace

Result<ArmExecutor> ArmExecutor::make(const robots::Robot& robot, const ExecutorOptions& options) {
  ArmExecutor made;
  made.robot_ = &robot;
  made.options_ = options;
  MARKETGEN_TRY(motion::ArmModel model, motion::make_arm_model(robot, "arm"));
  if (const auto ik = robots::make_arm_ik(robot, model.group); !ik.ok()) return ik.error();
  made.model_ = std::make_shared<const motion::ArmModel>(std::move(model));
  made.hand_ = hand_of(robot, made.model_->group);
  return made;
}

void ArmExecutor::start(const agent::Observation& now) {
  queue_.clear();
  retrace_.start();
  was_stopped_ = was_touched_ = false;
  played_s_ = held_m_ = 0;
  now_ = end_ = now.position;
  opening_m_ = now.openings_m.front();
  subtask_ = played_for_ = agent::Subtask::none;
}

std::vector<double> ArmExecutor::state(double opening_m) const {
  std::vector<double> q = robots::neutral_state(*robot_);
  for (std::size_t j = 0; j < end_.size(); ++j)
    q[static_cast<std::size_t>(model_->group.dofs[j])] =
        std::clamp(end_[j], model_->lower[j], model_->upper[j]);
  if (const robots::JointGroup* fingers = robot_->find_group("fingers")) {
    for (const int dof : fingers->dofs) {
      const robots::Joint& joint = robot_->joint_of_dof(static_cast<std::size_t>(dof));
      q[static_cast<std::size_t>(dof)] = std::clamp(opening_m / 2, joint.lower, joint.upper);
    }
  }
  return robots::with_followers(*robot_, std::move(q));
}

Result<std::vector<motion::MotionLimits>> ArmExecutor::limits(double speed) const {
  motion::ArmPlanOptions arm;
  arm.speed = speed;
  MARKETGEN_TRY(std::vector<motion::MotionLimits> limits, motion::motion_limits(*model_, arm));
  for (motion::MotionLimits& limit : limits)
    limit.acceleration *= options_.acceleration;
  return limits;
}

Result<motion::ArmChecker> ArmExecutor::line_checker(const std::vector<double>& state,
                                                     const motion::CollisionWorld& way,
                                                     const motion::CollisionWorld& line) const {
  return motion::ArmChecker::make(
      *model_,
      state,
      {},
      way,
      {.margin_m = options_.line_margin_m, .at_work = hand_, .their_world = &line});
}

double ArmExecutor::opening_for(double asked_m) const {
  if (asked_m > 0) return asked_m;
  return opening_m_ > 0 ? opening_m_ : held_m_;
}

void ArmExecutor::queue(motion::JointTrajectory trajectory, double opening_m, double force_n) {
  const double duration = trajectory.duration_s();
  end_ = trajectory.at(duration).position;
  was_stopped_ = was_touched_ = false;
  queue_.push_back({std::move(trajectory), duration, opening_m, force_n, subtask_});
}

void ArmExecutor::wait(double seconds, double opening_m, double force_n) {
  was_stopped_ = was_touched_ = false;
  queue_.push_back({{}, seconds, opening_m, force_n, subtask_});
}

Result<void> ArmExecutor::reach(const Surroundings& around,
                                const ReachRequest& request,
                                Seed seed) {
  MARKETGEN_TRY(const motion::CollisionWorld way_world, motion::CollisionWorld::make(around.way));
  MARKETGEN_TRY(const motion::CollisionWorld line_world, motion::CollisionWorld::make(around.line));
  const std::vector<double> q = state(opening_for(request.opening_m));
  MARKETGEN_TRY(
      const motion::ArmChecker way,
      motion::ArmChecker::make(*model_,
                               q,
                               {},
                               way_world,
                               {.margin_m = options_.way_margin_m, .attached = request.attached}));
  MARKETGEN_TRY(const motion::ArmChecker line, line_checker(q, way_world, line_world));
  motion::ArmPlanOptions arm;
  arm.search.max_iterations = options_.max_samples;
  arm.speed = options_.speed;
  MARKETGEN_TRY(
      const motion::ReachPlan plan,
      motion::plan_reach(way, line, {end_, request.base_from_tip, request.approach}, seed, arm));
  MARKETGEN_TRY(const auto quick, limits(options_.speed));
  MARKETGEN_TRY(motion::JointTrajectory trajectory, motion::timed_path(plan.way, quick));
  MARKETGEN_TRY(const motion::JointTrajectory last, timed_line(plan.line, request));
  if (!request.stops_before) trajectory.append(last);
  queue(std::move(trajectory), request.opening_m, request.force_n);
  guard(request.max_force_n);
  return {};
}

Result<motion::JointTrajectory> ArmExecutor::timed_line(const motion::JointPath& line,
                                                        const ReachRequest& request) const {
  MARKETGEN_TRY(const auto slow, limits(options_.line_speed));
  const double share = options_.felt_m / std::max(length(request.approach), options_.felt_m);
  const auto felt =
      static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(line.size() - 1)));
  if (request.max_force_n <= 0 || felt == 0) return motion::timed_curve(line, slow);
  MARKETGEN_TRY(const auto slowest, limits(options_.felt_speed));
  const auto begins = line.end() - 1 - felt;
  MARKETGEN_TRY(motion::JointTrajectory trajectory,
                motion::timed_curve({line.begin(), begins + 1}, slow));
  MARKETGEN_TRY(const motion::JointTrajectory last,
                motion::timed_curve({begins, line.end()}, slowest));
  trajectory.append(last);
  return trajectory;
}

Result<void> ArmExecutor::straight(const Surroundings& around,
                                   const Pose& base_from_tip,
                                   double opening_m,
                                   double force_n) {
  MARKETGEN_TRY(const motion::CollisionWorld way_world, motion::CollisionWorld::make(around.way));
  MARKETGEN_TRY(const motion::CollisionWorld line_world, motion::CollisionWorld::make(around.line));
  MARKETGEN_TRY(const motion::ArmChecker line,
                line_checker(state(opening_for(opening_m)), way_world, line_world));
  MARKETGEN_TRY(const motion::JointPath path, motion::tool_line(line, end_, base_from_tip));
  MARKETGEN_TRY(const auto slow, limits(options_.line_speed));
  MARKETGEN_TRY(motion::JointTrajectory trajectory, motion::timed_curve(path, slow));
  queue(std::move(trajectory), opening_m, force_n);
  return {};
}

Result<void> ArmExecutor::let_down(const Surroundings& around, double force_n) {
  Result<void> down;
  for (const double by : let_down_m) {
    down = straight(around, {tip().position - Vec3{0, 0, by}, tip().rotation}, 0, force_n);
    if (down.ok()) break;
  }
  return down;
}

agent::Action ArmExecutor::next(const agent::Observation& now) {
  if (retrace_.begins(now)) {
    break_off();
    was_stopped_ = true;
  } else if (is_at_guard(now)) {
    break_off();
    retrace_.begin(touch_back_steps);
    was_touched_ = true;
  }
  played_for_ = subtask_at(now);
  if (retrace_.goes_back() && !now.stopped) go_back();
  if (!queue_.empty() && !now.stopped) {
    const Motion& motion = queue_.front();
    played_s_ += options_.step_s;
    opening_m_ = motion.opening_m;
    force_n_ = motion.force_n;
    if (motion.trajectory.joints() > 0) {
      now_ = motion.trajectory.at(played_s_).position;
      retrace_.tell({now_});
    }
    if (played_s_ >= motion.duration_s) {
      queue_.pop_front();
      played_s_ = 0;
    }
  }
  return {now_, {{opening_m_, force_n_}}};
}

agent::Subtask ArmExecutor::subtask_at(const agent::Observation& now) const {
  if (now.stopped || retrace_.goes_back()) return agent::Subtask::recover;
  return queue_.empty() ? agent::Subtask::none : queue_.front().subtask;
}

bool ArmExecutor::is_at_guard(const agent::Observation& now) const {
  if (queue_.empty() || now.stopped || now.external_force_n.empty()) return false;
  const Motion& motion = queue_.front();
  return motion.max_force_n > 0 && now.external_force_n.front() > motion.max_force_n;
}

void ArmExecutor::break_off() {
  queue_.clear();
  played_s_ = 0;
}

void ArmExecutor::go_back() {
  if (const auto step = retrace_.back()) now_ = step->position;
  end_ = now_;
}

Pose ArmExecutor::tip() const {
  const std::vector<double> q = state(opening_m_);
  const Pose base = robots::link_poses(*robot_, q)[static_cast<std::size_t>(model_->group.base)];
  return inverse(base) * robots::frame_pose(*robot_, q, model_->group.tip);
}

std::optional<double> ArmExecutor::effort_to(const Pose& base_from_tip) const {
  // Of its errors make() has ruled out all but robot.unreachable.
  const auto goals = motion::arm_goals(*robot_, model_->group, base_from_tip, end_);
  if (!goals.ok()) return std::nullopt;
  double most = 0;
  for (std::size_t j = 0; j < end_.size(); ++j)
    most = std::max(most, std::abs(goals->front()[j] - end_[j]));
  return most;
}

}  // namespace marketgen::skills
