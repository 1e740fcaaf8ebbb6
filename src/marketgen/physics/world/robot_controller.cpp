#include "physics/world/robot_controller.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include "robots/dynamics.h"

namespace marketgen::physics {
namespace {

constexpr double felt_over_s = 0.010;  // mean: as the ledger's, and about what a joint's sensor has
// How far a drive may be told ahead of where its joint is: twice what takes its full effort.
constexpr double max_lead_rad = 0.04, max_lead_m = 0.004;
constexpr double yields_share = 0.5;  // of a contact limit: what a stopped robot still gives way to

Error bad_reference(const std::string& robot, const std::string& message) {
  return {"physics.bad_command", robot, message};
}

robots::FloorMotion floor_motion(const robots::JointGroup& base,
                                 const std::vector<double>& q,
                                 const std::vector<double>& v) {
  const auto at = [&](const std::vector<double>& of, std::size_t i) {
    return of[static_cast<std::size_t>(base.dofs[i])];
  };
  return {{at(q, 0), at(q, 1), at(q, 2)}, at(v, 0), at(v, 1), at(v, 2)};
}

}  // namespace

Result<RobotController> RobotController::start(const World& world,
                                               const robots::Robot& robot,
                                               const std::string& prefix) {
  RobotController made;
  made.robot_ = &robot;
  MARKETGEN_TRY(made.actor_, RobotActor::find(world, robot, prefix));
  const std::vector<double> q = made.actor_.position(world), v = made.actor_.velocity(world);
  for (const double place : q)
    made.setpoints_.emplace_back(robots::Setpoint{place, 0});
  for (const robots::Tool& tool : robot.tools) {
    const robots::Joint* finger = robots::driven_finger(robot, tool);
    made.fingers_.push_back({finger == nullptr ? 0 : q[static_cast<std::size_t>(finger->dof)], 0});
  }
  if (const robots::JointGroup* base = robot.drive ? robot.find_group("base") : nullptr) {
    if (base->dofs.size() != 3)
      return bad_reference(robot.name, "a base that drives has the joints x, y and yaw");
    made.wheels_ = robots::WheelDrive(robot, floor_motion(*base, q, v).place);
  }
  made.felt_.resize(robot.contact_limits.size());
  made.find_parts(world.model(), prefix);
  return made;
}

void RobotController::find_parts(const mjModel& model, const std::string& prefix) {
  std::vector<int> of_body(static_cast<std::size_t>(model.nbody), -1);
  for (std::size_t limit = 0; limit < robot_->contact_limits.size(); ++limit) {
    for (const int link : robots::links_from(*robot_, robot_->contact_limits[limit].link)) {
      const std::string name = prefix + robot_->links[static_cast<std::size_t>(link)].name;
      const int body = mj_name2id(&model, mjOBJ_BODY, name.c_str());
      if (body > 0) of_body[static_cast<std::size_t>(body)] = static_cast<int>(limit);
    }
  }
  for (int geom = 0; geom < model.ngeom; ++geom)
    limit_of_.push_back(of_body[static_cast<std::size_t>(model.geom_bodyid[geom])]);
}

Result<void> RobotController::check(const RobotReference& reference) const {
  if (reference.joints.size() != setpoints_.size() || reference.grips.size() != fingers_.size())
    return bad_reference(robot_->name,
                         fmt::format("{} joints and {} tools; it has {} and {}",
                                     reference.joints.size(),
                                     reference.grips.size(),
                                     setpoints_.size(),
                                     fingers_.size()));
  const auto finite = [](const robots::Setpoint& wanted) {
    return std::isfinite(wanted.position) && std::isfinite(wanted.velocity);
  };
  const auto sound = [](const GripReference& grip) {
    return grip.opening_m >= 0 && grip.force_n >= 0 && std::isfinite(grip.opening_m);
  };
  if (!std::ranges::all_of(reference.joints, finite) ||
      !std::ranges::all_of(reference.grips, sound) || !std::isfinite(reference.drive_m_s) ||
      !std::isfinite(reference.turn_rad_s))
    return bad_reference(robot_->name, "expected numbers, openings and forces from 0 on");
  return {};
}

std::vector<robots::Setpoint> RobotController::setpoints() const {
  std::vector<robots::Setpoint> now;
  for (const robots::SmoothSetpoint& setpoint : setpoints_)
    now.push_back(setpoint.now());
  return now;
}

void RobotController::follow(const RobotReference& reference, bool stopped, double step_s) {
  for (std::size_t dof = 0; dof < setpoints_.size(); ++dof) {
    if (!actor_.follows_position(dof)) continue;
    robots::SmoothSetpoint& setpoint = setpoints_[dof];
    const robots::Setpoint stay{setpoint.now().position, 0};
    setpoint.follow(stopped ? stay : reference.joints[dof],
                    robots::setpoint_limits(robot_->joint_of_dof(dof)),
                    step_s);
  }
}

void RobotController::keep_near(const std::vector<double>& q, const std::vector<double>& v) {
  for (std::size_t dof = 0; dof < setpoints_.size(); ++dof) {
    const bool slides = robot_->joint_of_dof(dof).kind == robots::JointType::prismatic;
    setpoints_[dof].keep_near({q[dof], v[dof]}, slides ? max_lead_m : max_lead_rad);
  }
}

// Where the robot is; going as its drives are told, and as its wheels turn. Gravity is carried
// already.
std::vector<double> RobotController::effort_of_motion(const std::vector<double>& q,
                                                      const std::vector<double>& v) const {
  constexpr double no_gravity = 0;
  std::vector<double> speeds(q.size()), accelerations(q.size());
  if (const robots::JointGroup* base = robot_->drive ? robot_->find_group("base") : nullptr)
    for (const int dof : base->dofs)
      speeds[static_cast<std::size_t>(dof)] = v[static_cast<std::size_t>(dof)];
  for (std::size_t dof = 0; dof < q.size(); ++dof) {
    if (!actor_.follows_position(dof)) continue;
    speeds[dof] = setpoints_[dof].now().velocity;
    accelerations[dof] = setpoints_[dof].acceleration();
  }
  const Eigen::VectorXd inertial =
      robots::inverse_dynamics(*robot_, q, speeds, accelerations, no_gravity);
  std::vector<double> efforts(inertial.begin(), inertial.end());
  for (std::size_t dof = 0; dof < q.size(); ++dof)
    efforts[dof] += robot_->joint_of_dof(dof).damping * speeds[dof];
  return efforts;
}

// A gripper that closes goes on until it presses: it is then told to be as far inside as takes its
// force.
void RobotController::follow_finger(std::size_t tool,
                                    const GripReference& wanted,
                                    const std::vector<double>& q,
                                    double step_s) {
  const robots::Tool& row = robot_->tools[tool];
  const robots::Joint* joint = robots::driven_finger(*robot_, row);
  if (joint == nullptr) return;
  const double reach = actor_.finger_reach_m(row, wanted.force_n);
  const double open = std::min(wanted.opening_m / row.opening, 1.0) * joint->upper;
  robots::SetpointLimits limits = robots::setpoint_limits(*joint);
  limits.lower -= reach;  // pads that press on one another
  fingers_[tool].follow({wanted.opening_m > 0 ? open : limits.lower, 0}, limits, step_s);
  fingers_[tool].keep_near({q[static_cast<std::size_t>(joint->dof)], 0}, reach);
}

robots::FloorForce RobotController::push(const World& world,
                                         const RobotReference& reference,
                                         bool stopped,
                                         double step_s) {
  const robots::FloorMotion now =
      floor_motion(*robot_->find_group("base"), actor_.position(world), actor_.velocity(world));
  return stopped ? wheels_.push(now, 0, 0, step_s)
                 : wheels_.push(now, reference.drive_m_s, reference.turn_rad_s, step_s);
}

Result<void> RobotController::command(World& world, const RobotReference& reference) {
  MARKETGEN_CHECK(check(reference));
  const double step_s = world.model().opt.timestep;
  const bool halt = stopped(world.time_s());
  follow(reference, halt, step_s);
  const std::vector<double> q = actor_.position(world), v = actor_.velocity(world);
  keep_near(q, v);
  std::vector<double> places, speeds;
  for (const robots::SmoothSetpoint& setpoint : setpoints_) {
    places.push_back(setpoint.now().position);
    speeds.push_back(setpoint.now().velocity);
  }
  MARKETGEN_CHECK(actor_.command(world, places, speeds, effort_of_motion(q, v)));
  for (std::size_t t = 0; t < fingers_.size(); ++t) {
    const robots::Tool& tool = robot_->tools[t];
    if (robots::driven_finger(*robot_, tool) == nullptr) continue;
    const GripReference wanted{reference.grips[t].opening_m,
                               std::min(reference.grips[t].force_n, tool.force)};
    follow_finger(t, wanted, q, step_s);
    MARKETGEN_CHECK(actor_.grip(world, tool, fingers_[t], wanted.force_n));
  }
  if (!robot_->drive) return {};
  return actor_.push_base(world, push(world, reference, halt, step_s));
}

void RobotController::give_way(const World& world) {
  const std::vector<double> q = actor_.position(world);
  for (std::size_t dof = 0; dof < setpoints_.size(); ++dof) {
    const robots::Joint& joint = robot_->joint_of_dof(dof);
    setpoints_[dof] = robots::SmoothSetpoint({std::clamp(q[dof], joint.lower, joint.upper), 0});
  }
}

std::vector<double> RobotController::external_force_n() const {
  std::vector<double> forces(felt_.size());
  std::ranges::transform(felt_, forces.begin(), [](const Vec3& felt) { return length(felt); });
  return forces;
}

void RobotController::feel(const World& world) {
  const mjModel& model = world.model();
  const mjData& data = world.data();
  std::vector<Vec3> now(felt_.size());
  for (int c = 0; c < data.ncon; ++c) {
    const mjContact& contact = data.contact[c];
    if (contact.efc_address < 0) continue;
    const int a = limit_of_[static_cast<std::size_t>(contact.geom[0])],
              b = limit_of_[static_cast<std::size_t>(contact.geom[1])];
    if (a == b) continue;
    mjtNum force[6], f[3];
    mj_contactForce(&model, &data, c, force);
    mju_mulMatTVec(f, contact.frame, force, 3, 3);  // on the second geom
    const Vec3 on_b{f[0], f[1], f[2]};
    if (a >= 0) now[static_cast<std::size_t>(a)] = now[static_cast<std::size_t>(a)] - on_b;
    if (b >= 0) now[static_cast<std::size_t>(b)] = now[static_cast<std::size_t>(b)] + on_b;
  }
  const bool halted = stopped(data.time);
  for (std::size_t limit = 0; limit < felt_.size(); ++limit) {
    const robots::ContactLimit& row = robot_->contact_limits[limit];
    felt_[limit] = felt_[limit] + (now[limit] - felt_[limit]) * (model.opt.timestep / felt_over_s);
    const double force = length(felt_[limit]);
    max_force_n_ = std::max(max_force_n_, force);
    if (halted && force > yields_share * row.force) give_way(world);
    if (halted || force <= row.force) continue;
    if (!stopped(data.time)) ++stops_;
    goes_on_s_ = std::max(goes_on_s_, data.time + row.pause);
    give_way(world);
  }
}

}  // namespace marketgen::physics
