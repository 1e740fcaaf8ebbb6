// One control step of a robot, as what its controller is told before each step of physics: the same
// for every track.
#pragma once
#include <vector>

#include "agent/policy.h"
#include "physics/world/robot_controller.h"

namespace marketgen::episodes {

// Joints go along cubic curves that take over the speed at which they go: a servo that is told to
// jump to another shakes what a cup holds out of it. Wheels change their speed evenly.
class ControlStep {
 public:
  ControlStep() = default;
  // `commanded`: degrees of freedom of action.position. Targets beyond a joint's end mean its end.
  ControlStep(const physics::RobotController& controller,
              const robots::Robot& robot,
              const std::vector<int>& commanded,
              const agent::Action& action);

  static int count();  // steps of physics in it
  // What is told before step 0, 1 .. count() - 1; from count() on joints stay at their targets.
  physics::RobotReference at(int step) const;

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.commanded_, self.from_, self.speeds_, self.drive_from_, self.turn_from_);
    archive(self.end_.joints, self.end_.grips, self.end_.drive_m_s, self.end_.turn_rad_s);
  }

 private:
  std::vector<int> commanded_;
  std::vector<robots::Setpoint> from_;  // of all degrees of freedom
  std::vector<double> speeds_;          // of the commanded ones, at the end
  double drive_from_ = 0, turn_from_ = 0;
  physics::RobotReference end_;
};

}  // namespace marketgen::episodes
