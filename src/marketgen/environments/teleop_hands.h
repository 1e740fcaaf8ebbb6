// What a person wants of a robot (robots::TeleopCommand) as the numbers of an Environment's action
// in pd_ee_delta_pose.
#pragma once
#include <span>
#include <vector>

#include "environments/environment.h"
#include "robots/teleop_command.h"

namespace marketgen::environments {

// Numbers of actions lie on a grid of this width: whoever keeps them in float32 has them exactly.
constexpr double teleop_grid = 1.0 / 1024;

// One robot's tools, as they were told to open or close last. `environment` has the control mode
// pd_ee_delta_pose, was reset, and must outlive it.
class TeleopHands {
 public:
  // As the tools stand open now.
  explicit TeleopHands(const Environment& environment);

  // Of the next control step. `stop`: the person says that it is done. A tool that there is not is
  // the last one.
  std::vector<double> numbers(const robots::TeleopCommand& command, bool stop);
  // Of each tool: 1 open, -1 closed.
  std::span<const double> openings() const { return openings_; }

 private:
  const Environment& environment_;
  std::vector<double> openings_;
};

// Names of the joints of no arm, in the order of robots::TeleopCommand::joints.
std::vector<ActionNumber> teleop_joints(const Environment& environment);

}  // namespace marketgen::environments
