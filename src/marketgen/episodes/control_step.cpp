#include "episodes/control_step.h"

#include <algorithm>
#include <cmath>

#include "episodes/track_world.h"
#include "physics/goods/contact_shape.h"

namespace marketgen::episodes {
namespace {

constexpr int substeps = static_cast<int>(control_step_s / physics::time_step_s + 0.5);

// With speed v0 at the start, v1 at the end and v1 in the mean, after the share s of the time:
// speed, and how far, in control steps.
double speed_at(double v0, double v1, double s) {
  return v0 + (v1 - v0) * s * (4 - 3 * s);
}
double way_at(double v0, double v1, double s) {
  return s * (v0 + (v1 - v0) * s * (2 - s));
}

}  // namespace

ControlStep::ControlStep(const physics::RobotController& controller,
                         const robots::Robot& robot,
                         const std::vector<int>& commanded,
                         const agent::Action& action)
    : commanded_(commanded),
      from_(controller.setpoints()),
      drive_from_(controller.wheels().drive_m_s()),
      turn_from_(controller.wheels().turn_rad_s()) {
  end_.joints = from_;
  for (robots::Setpoint& still : end_.joints)
    still.velocity = 0;
  for (std::size_t j = 0; j < commanded.size(); ++j) {
    const auto dof = static_cast<std::size_t>(commanded[j]);
    const robots::Joint& joint = robot.joint_of_dof(dof);
    const double target = std::clamp(action.position[j], joint.lower, joint.upper);
    speeds_.push_back((target - from_[dof].position) / control_step_s);
  }
  for (const agent::ToolCommand& tool : action.tools)
    end_.grips.push_back({tool.opening_m, tool.force_n});
  if (robot.drive) {
    end_.drive_m_s = std::clamp(action.drive_m_s, -robot.drive->speed, robot.drive->speed);
    end_.turn_rad_s =
        std::clamp(action.turn_rad_s, -robot.drive->turn_rate, robot.drive->turn_rate);
  }
}

int ControlStep::count() {
  return substeps;
}

physics::RobotReference ControlStep::at(int step) const {
  const double s = std::min(1.0, static_cast<double>(step + 1) / substeps);
  physics::RobotReference reference = end_;
  for (std::size_t j = 0; j < commanded_.size(); ++j) {
    const auto dof = static_cast<std::size_t>(commanded_[j]);
    const robots::Setpoint& from = from_[dof];
    reference.joints[dof] = {from.position + way_at(from.velocity, speeds_[j], s) * control_step_s,
                             step < substeps ? speed_at(from.velocity, speeds_[j], s) : 0};
  }
  reference.drive_m_s = std::lerp(drive_from_, end_.drive_m_s, s);
  reference.turn_rad_s = std::lerp(turn_from_, end_.turn_rad_s, s);
  return reference;
}

}  // namespace marketgen::episodes
