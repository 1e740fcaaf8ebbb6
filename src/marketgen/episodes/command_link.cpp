#include "episodes/command_link.h"

#include <utility>

namespace marketgen::episodes {

CommandLink::CommandLink(const robots::Robot& robot,
                         std::vector<int> commanded,
                         int late_steps,
                         agent::Action before_first)
    : robot_(&robot),
      commanded_(std::move(commanded)),
      late_steps_(late_steps),
      in_force_(std::move(before_first)) {}

void CommandLink::give(agent::Action action) {
  on_their_way_.push_back({late_steps_, std::move(action)});
}

void CommandLink::take(agent::Action action, const physics::RobotController& controller) {
  in_force_ = std::move(action);
  step_ = ControlStep(controller, *robot_, commanded_, in_force_);
  steps_of_it_ = 0;
}

physics::RobotReference CommandLink::next(const physics::RobotController& controller) {
  while (!on_their_way_.empty() && on_their_way_.front().steps_left <= 0) {
    agent::Action arrived = std::move(on_their_way_.front().action);
    on_their_way_.erase(on_their_way_.begin());
    take(std::move(arrived), controller);
  }
  if (steps_of_it_ < 0) take(in_force_, controller);
  for (Given& given : on_their_way_)
    --given.steps_left;
  return step_.at(steps_of_it_++);
}

}  // namespace marketgen::episodes
