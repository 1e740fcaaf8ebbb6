// The way of actions to a robot's drives: each is in force from so many steps of physics after it
// was given until the next one is. With none it is in force at once.
//
//   link.give(action);                       // at the beginning of a control step
//   for (int i = 0; i < ControlStep::count(); ++i)
//     controller.command(world, link.next(controller));
#pragma once
#include <vector>

#include "agent/policy.h"
#include "episodes/control_step.h"

namespace marketgen::episodes {

// Not thread-safe. What changes is in bytes(); robot and commanded joints it has from its
// constructor.
class CommandLink {
 public:
  CommandLink() = default;
  // `commanded`: as of ControlStep. `before_first`: in force until the first action arrives. The
  // robot must outlive it.
  CommandLink(const robots::Robot& robot,
              std::vector<int> commanded,
              int late_steps,
              agent::Action before_first);

  int late_steps() const { return late_steps_; }
  void give(agent::Action action);
  // What the drives are told before the next step of physics.
  physics::RobotReference next(const physics::RobotController& controller);
  // The action that the last reference was of.
  const agent::Action& in_force() const { return in_force_; }

  // late_steps() stays: another link has its own.
  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.on_their_way_, self.step_, self.steps_of_it_);
    action_bytes(archive, self.in_force_);
  }

 private:
  template <class Archive, class Action>
  static void action_bytes(Archive& archive, Action& action) {
    archive(action.position, action.tools, action.drive_m_s, action.turn_rad_s, action.stop);
  }
  struct Given {
    int steps_left = 0;  // of physics, until it arrives
    agent::Action action;
    template <class Archive, class Self>
    static void bytes(Archive& archive, Self& self) {
      archive(self.steps_left);
      action_bytes(archive, self.action);
    }
  };
  void take(agent::Action action, const physics::RobotController& controller);

  const robots::Robot* robot_ = nullptr;
  std::vector<int> commanded_;
  int late_steps_ = 0;
  std::vector<Given> on_their_way_;  // oldest first
  agent::Action in_force_;
  ControlStep step_;
  int steps_of_it_ = -1;  // of physics, that it was told; -1: nothing is in force yet
};

}  // namespace marketgen::episodes
