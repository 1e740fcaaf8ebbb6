#include "physics/world/robot_actor.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

namespace marketgen::physics {
namespace {

constexpr double finger_quickness = 10;  // what is left of the fingers' way is made up for, 1/s

Error bad_robot_command(const std::string& robot, const std::string& message) {
  return {"physics.bad_command", robot, message};
}

}  // namespace

Result<RobotActor> RobotActor::find(const World& world,
                                    const robots::Robot& robot,
                                    const std::string& prefix) {
  const mjModel& model = world.model();
  RobotActor actor;
  actor.robot_ = &robot;
  for (std::size_t dof = 0; dof < robot.dof_count(); ++dof) {
    const robots::Joint& joint = robot.joint_of_dof(dof);
    const std::string name = prefix + joint.name;
    const int found = mj_name2id(&model, mjOBJ_JOINT, name.c_str());
    if (found < 0)
      return bad_robot_command(robot.name,
                               fmt::format("the world has no joint \"{}\": add the robot with "
                                           "WorldOptions::add_actors and the same prefix",
                                           name));
    Axis axis;
    axis.joint_position = model.jnt_qposadr[found];
    axis.joint_velocity = model.jnt_dofadr[found];
    const bool finger = robots::gripper_of(robot, static_cast<int>(dof)) != nullptr;
    axis.max_velocity = finger ? finger_speed(joint) : joint.velocity;
    axis.locking = model.dof_damping[axis.joint_velocity];
    if (joint.follows >= 0)  // parents come first: the leader is there already
      actor.axes_[static_cast<std::size_t>(joint.follows)].locking += axis.locking;
    axis.actuator = mj_name2id(&model, mjOBJ_ACTUATOR, name.c_str());
    if (axis.actuator >= 0) {
      axis.stiffness = -model.actuator_biasprm[axis.actuator * mjNBIAS + 1];
      axis.damping = -model.actuator_biasprm[axis.actuator * mjNBIAS + 2];
      const bool wheels = robots::is_on_wheels(robot, static_cast<int>(dof));
      if (axis.stiffness == 0 && !wheels) actor.drive_ = RobotDrive::torque;
      axis.follows_position = axis.stiffness > 0 && !finger;
    }
    actor.axes_.push_back(axis);
  }
  return actor;
}

std::vector<double> RobotActor::position(const World& world) const {
  std::vector<double> q;
  for (const Axis& axis : axes_)
    q.push_back(world.data().qpos[axis.joint_position]);
  return q;
}

std::vector<double> RobotActor::velocity(const World& world) const {
  std::vector<double> v;
  for (const Axis& axis : axes_)
    v.push_back(world.data().qvel[axis.joint_velocity]);
  return v;
}

std::vector<double> RobotActor::effort(const World& world) const {
  std::vector<double> efforts;
  for (const Axis& axis : axes_)
    efforts.push_back(world.data().qfrc_actuator[axis.joint_velocity]);
  return efforts;
}

Result<void> RobotActor::check(std::span<const double> values, bool servo, const char* what) const {
  if (servo != (drive_ == RobotDrive::position))
    return bad_robot_command(robot_->name,
                             servo ? "its drives take torques: use apply(), or add it with "
                                     "RobotDrive::position"
                                   : "its drives take positions: use command(), or add it with "
                                     "RobotDrive::torque");
  if (values.size() != axes_.size())
    return bad_robot_command(
        robot_->name,
        fmt::format("{} {} for {} degrees of freedom", values.size(), what, axes_.size()));
  for (std::size_t dof = 0; dof < values.size(); ++dof) {
    if (!std::isfinite(values[dof]))
      return bad_robot_command(
          robot_->name,
          fmt::format("{} of joint {} is no number", what, robot_->joint_of_dof(dof).name));
  }
  return {};
}

// A servo's force is stiffness (control - place) - damping x velocity: it pushes no more at the
// velocity at which the two are equal, but for what it is to give beside.
Result<void> RobotActor::command(World& world,
                                 std::span<const double> position,
                                 std::span<const double> velocity,
                                 std::span<const double> effort) const {
  MARKETGEN_CHECK(check(position, true, "positions"));
  MARKETGEN_CHECK(check(velocity, true, "velocities"));
  if (!effort.empty()) MARKETGEN_CHECK(check(effort, true, "efforts"));
  for (std::size_t dof = 0; dof < axes_.size(); ++dof) {
    const Axis& axis = axes_[dof];
    if (!follows_position(dof)) continue;
    const double lag_s = axis.damping / axis.stiffness;
    const double now = world.data().qpos[axis.joint_position], reach = axis.max_velocity * lag_s;
    const double wanted = position[dof] + velocity[dof] * lag_s;
    const double beside = effort.empty() ? 0 : effort[dof] / axis.stiffness;
    MARKETGEN_CHECK(
        world.set_control(axis.actuator, std::clamp(wanted, now - reach, now + reach) + beside));
  }
  return {};
}

const RobotActor::Axis* RobotActor::finger_axis(const robots::Tool& tool) const {
  const robots::Joint* finger = robots::driven_finger(*robot_, tool);
  return finger == nullptr ? nullptr : &axes_[static_cast<std::size_t>(finger->dof)];
}

double RobotActor::finger_reach_m(const robots::Tool& tool, double force_n) const {
  const Axis* axis = finger_axis(tool);
  return axis == nullptr ? 0 : 2 * force_n / axis->stiffness;  // the drive presses both fingers
}

Result<void> RobotActor::grip(World& world,
                              const robots::Tool& tool,
                              const robots::Setpoint& finger,
                              double force_n) const {
  if (!(force_n >= 0) || !std::isfinite(finger.position) || !std::isfinite(finger.velocity))
    return bad_robot_command(robot_->name, "places of fingers are numbers, forces from 0 on");
  if (force_n > tool.force)
    return bad_robot_command(
        robot_->name,
        fmt::format("{} N is more than the {} N that the gripper has", force_n, tool.force));
  const Axis* axis = finger_axis(tool);
  if (axis == nullptr) return bad_robot_command(robot_->name, "the tool is no gripper");
  const mjData& data = world.data();
  const double now = data.actuator_length[axis->actuator],
               speed = data.actuator_velocity[axis->actuator];
  const double both = 2 * force_n;  // the drive presses both fingers
  const double pressing = std::clamp(axis->stiffness * (finger.position - now), -both, both);
  // What moves them where they are to go is not held up by what locks them.
  const double wanted = std::clamp(finger.velocity + (finger.position - now) * finger_quickness,
                                   -axis->max_velocity,
                                   axis->max_velocity);
  const double free = std::clamp(speed, std::min(wanted, 0.0), std::max(wanted, 0.0));
  const double top = axis->locking * axis->max_velocity;  // takes them to their top speed
  const double force = std::clamp(pressing + axis->locking * free, -top, top);
  return world.set_control(axis->actuator, now + force / axis->stiffness);
}

Result<void> RobotActor::push_base(World& world, const robots::FloorForce& force) const {
  const robots::JointGroup* base = robot_->drive ? robot_->find_group("base") : nullptr;
  if (base == nullptr || base->dofs.size() != 3)
    return bad_robot_command(robot_->name, "it has no base that drives");
  const double efforts[3] = {force.x_n, force.y_n, force.turn_n_m};
  for (std::size_t i = 0; i < 3; ++i)
    MARKETGEN_CHECK(
        world.set_control(axes_[static_cast<std::size_t>(base->dofs[i])].actuator, efforts[i]));
  return {};
}

Result<void> RobotActor::apply(World& world, std::span<const double> effort) const {
  MARKETGEN_CHECK(check(effort, false, "efforts"));
  for (std::size_t dof = 0; dof < axes_.size(); ++dof) {
    const Axis& axis = axes_[dof];
    if (axis.actuator < 0 || axis.stiffness > 0 ||
        robots::is_on_wheels(*robot_, static_cast<int>(dof)))
      continue;
    MARKETGEN_CHECK(world.set_control(axis.actuator, effort[dof]));
  }
  return {};
}

}  // namespace marketgen::physics
