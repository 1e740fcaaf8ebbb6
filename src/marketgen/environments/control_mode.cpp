#include "environments/control_mode.h"

#include <algorithm>
#include <cmath>

#include "base/seed.h"
#include "environments/observation_parts.h"
#include "episodes/track_world.h"

namespace marketgen::environments {
namespace {

constexpr double turn_rad = 0.1;  // in a control step: 2 rad/s, slower than any joint can
constexpr double tool_m = 0.02;   // in a control step
constexpr std::array<const char*, 6> tool_axes{"x", "y", "z", "turn_x", "turn_y", "turn_z"};

bool by_joint(ControlMode mode) {
  return mode == ControlMode::pd_joint_pos || mode == ControlMode::pd_joint_delta_pos;
}

std::string_view dimension_of(const robots::Joint& joint) {
  return joint.kind == robots::JointType::prismatic ? "m" : "rad";
}

std::size_t numbers_a_tool(ControlMode mode) {
  return mode == ControlMode::pd_ee_delta_pos ? 3 : 6;
}

double share(double value) {
  return std::clamp(value, -1.0, 1.0);
}

// `pose` moved and turned by shares of a step, about its own origin along its parent's axes.
Pose moved_pose(Pose pose, std::span<const double> by) {
  pose.position = pose.position + Vec3{share(by[0]), share(by[1]), share(by[2])} * tool_m;
  if (by.size() < 6) return pose;
  const Vec3 turn = Vec3{share(by[3]), share(by[4]), share(by[5])} * turn_rad;
  const double angle = length(turn);
  if (angle > 0) pose.rotation = rotation_about(turn / angle, angle) * pose.rotation;
  return pose;
}

}  // namespace

ActionMap::ActionMap(const robots::Robot& robot, ControlMode mode, bool stop, double grip_n)
    : robot_(robot),
      mode_(mode),
      stop_(stop),
      grip_n_(grip_n),
      joints_(episodes::commanded_dofs(robot)) {
  for (const robots::Tool& tool : robot.tools) {
    Arm arm{tool.frame, {}};
    for (const robots::JointGroup& group : robot.groups)
      if (group.tip == tool.frame && group.name != tool.prefix + "fingers") arm.dofs = group.dofs;
    arms_.push_back(std::move(arm));
  }
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const bool of_arm = std::ranges::any_of(
        arms_, [&](const Arm& arm) { return std::ranges::count(arm.dofs, joints_[j]) > 0; });
    if (!of_arm) other_.push_back(static_cast<int>(j));
  }
  if (by_joint(mode_))
    add_joints(mode_ == ControlMode::pd_joint_pos);
  else
    add_tools();
  for (const robots::Tool& tool : robot.tools)
    numbers_.push_back({tool_prefix(tool) + "opening"});
  if (robot.drive) {
    numbers_.push_back({"drive"});
    numbers_.push_back({"turn"});
  }
  if (stop_) numbers_.push_back({"stop"});
}

void ActionMap::add_joints(bool absolute) {
  for (const int dof : joints_) {
    const robots::Joint& joint = robot_.joint_of_dof(static_cast<std::size_t>(dof));
    numbers_.push_back(
        absolute ? ActionNumber{joint.name, joint.lower, joint.upper, 1, dimension_of(joint)}
                 : ActionNumber{joint.name, -1, 1, step_of(dof), dimension_of(joint)});
  }
}

void ActionMap::add_tools() {
  for (const robots::Tool& tool : robot_.tools)
    for (std::size_t axis = 0; axis < numbers_a_tool(mode_); ++axis)
      numbers_.push_back({tool_prefix(tool) + tool_axes[axis],
                          -1,
                          1,
                          axis < 3 ? tool_m : turn_rad,
                          axis < 3 ? "m" : "rad"});
  for (const int place : other_) {
    const int dof = joints_[static_cast<std::size_t>(place)];
    const robots::Joint& joint = robot_.joint_of_dof(static_cast<std::size_t>(dof));
    numbers_.push_back({joint.name, -1, 1, step_of(dof), dimension_of(joint)});
  }
}

double ActionMap::step_of(int dof) const {
  const robots::Joint& joint = robot_.joint_of_dof(static_cast<std::size_t>(dof));
  return joint.kind == robots::JointType::prismatic ? joint.velocity * episodes::control_step_s
                                                    : turn_rad;
}

std::vector<double> ActionMap::at_origin(std::vector<double> state) const {
  if (const robots::JointGroup* base = robot_.drive ? robot_.find_group("base") : nullptr)
    for (const int dof : base->dofs)
      state[static_cast<std::size_t>(dof)] = 0;
  return state;
}

std::vector<Pose> ActionMap::tool_poses(const std::vector<double>& state) const {
  const std::vector<double> there = at_origin(state);
  std::vector<Pose> poses;
  for (const Arm& arm : arms_)
    poses.push_back(robots::frame_pose(robot_, there, arm.frame));
  return poses;
}

std::vector<double> ActionMap::led(std::vector<double> target,
                                   const std::vector<double>& told) const {
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const robots::Joint& joint = robot_.joint_of_dof(static_cast<std::size_t>(joints_[j]));
    const double step = step_of(joints_[j]);
    target[j] = std::clamp(target[j], told[j] - step, told[j] + step);
    target[j] = std::clamp(target[j], joint.lower, joint.upper);
  }
  return target;
}

Result<robots::NearestIk> ActionMap::moved_tool(const Arm& arm,
                                                std::span<const double> by,
                                                const std::vector<double>& state) const {
  robots::NumericIkOptions near;
  near.restarts = 0;
  near.tolerance = 1e-5;
  const Pose wanted = moved_pose(robots::frame_pose(robot_, state, arm.frame), by);
  return robots::nearest_numeric(robot_, arm.frame, arm.dofs, wanted, state, Seed(0), near);
}

std::vector<double> ActionMap::moved_joints(std::span<const double> values,
                                            const std::vector<double>& target) const {
  std::vector<double> position = target;
  for (std::size_t j = 0; j < joints_.size(); ++j)
    position[j] = mode_ == ControlMode::pd_joint_pos
                      ? values[j]
                      : target[j] + step_of(joints_[j]) * share(values[j]);
  return position;
}

Result<MappedAction> ActionMap::moved_tools(std::span<const double> values,
                                            const std::vector<double>& state,
                                            const std::vector<double>& target) const {
  MappedAction moved;
  std::vector<double> reached = at_origin(state);
  const std::size_t each = numbers_a_tool(mode_);
  for (std::size_t t = 0; t < arms_.size(); ++t) {
    MARKETGEN_TRY(robots::NearestIk near,
                  moved_tool(arms_[t], values.subspan(t * each, each), reached));
    moved.cuts.push_back({near.off_m, near.off_rad});
    reached = std::move(near.q);
  }
  std::vector<double>& position = moved.action.position = target;
  for (std::size_t j = 0; j < joints_.size(); ++j)
    position[j] = reached[static_cast<std::size_t>(joints_[j])];
  for (std::size_t i = 0; i < other_.size(); ++i) {
    const auto j = static_cast<std::size_t>(other_[i]);
    position[j] = target[j] + step_of(joints_[j]) * share(values[arms_.size() * each + i]);
  }
  return moved;
}

Result<MappedAction> ActionMap::action(std::span<const double> values,
                                       const std::vector<double>& state,
                                       const std::vector<double>& target) const {
  MappedAction mapped;
  if (by_joint(mode_)) {
    mapped.action.position = moved_joints(values, target);
  } else {
    MARKETGEN_TRY(mapped, moved_tools(values, state, target));
  }
  agent::Action& action = mapped.action;
  const std::size_t tail = robot_.tools.size() + (robot_.drive ? 2 : 0) + (stop_ ? 1 : 0);
  std::span<const double> rest = values.last(tail);
  for (const robots::Tool& tool : robot_.tools) {
    const double open = (share(rest.front()) + 1) / 2;
    const double cup = open > 0.5 ? agent::cup_off_m : 0;
    action.tools.push_back(
        {tool.kind == robots::ToolKind::suction ? cup : open * tool.opening, grip_n_});
    rest = rest.subspan(1);
  }
  if (robot_.drive) {
    action.drive_m_s = share(rest[0]) * robot_.drive->speed;
    action.turn_rad_s = share(rest[1]) * robot_.drive->turn_rate;
  }
  action.stop = stop_ && values.back() > 0;
  return mapped;
}

Result<std::vector<double>> ActionMap::values(const agent::Action& wanted,
                                              const std::vector<double>& target) const {
  if (!by_joint(mode_))
    return Error{
        "usage.bad_flag",
        "control_mode",
        "what moves the joints cannot be said in pd_ee_delta_pos or pd_ee_delta_pose: take "
        "pd_joint_pos, or pd_joint_delta_pos"};
  std::vector<double> values;
  for (std::size_t j = 0; j < joints_.size(); ++j)
    values.push_back(mode_ == ControlMode::pd_joint_pos
                         ? wanted.position[j]
                         : share((wanted.position[j] - target[j]) / step_of(joints_[j])));
  for (std::size_t t = 0; t < robot_.tools.size(); ++t) {
    const bool cup = robot_.tools[t].kind == robots::ToolKind::suction;
    const double widest = cup ? agent::cup_off_m : robot_.tools[t].opening;
    values.push_back(2 * std::clamp(wanted.tools[t].opening_m / widest, 0.0, 1.0) - 1);
  }
  if (robot_.drive) {
    values.push_back(share(wanted.drive_m_s / robot_.drive->speed));
    values.push_back(share(wanted.turn_rad_s / robot_.drive->turn_rate));
  }
  if (stop_) values.push_back(wanted.stop ? 1 : -1);
  return values;
}

}  // namespace marketgen::environments
