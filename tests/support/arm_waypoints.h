// An arm at the counter that goes from place to place, whatever is in the way.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "agent/policy.h"
#include "episodes/track_world.h"
#include "geometry/rotation_axes.h"
#include "robots/arm_ik.h"

namespace marketgen {

// A place of the tip, which points down and closes along Y, and how fast the joints go there.
struct Waypoint {
  Vec3 tip;
  double opening_m = 0, speed_rad_s = 0.8;
};

// Goes from one to the next in joint space, whatever is in the way, and says then that it has done.
class Waypoints : public agent::Policy {
 public:
  Waypoints(const robots::Robot& robot, std::vector<Waypoint> way)
      : arm_(robots::make_arm_ik(robot, *robot.find_group("arm")).value()), way_(std::move(way)) {}

  Result<void> begin(const agent::Task&, const agent::Observation& first) override {
    target_ = first.position;
    return {};
  }

  Result<agent::Action> act(const agent::Observation& now) override {
    agent::Action action = episodes::still_action(now);
    if (steps_left_ == 0 && next_ < way_.size()) MARKETGEN_CHECK(head_for(way_[next_++]));
    action.stop = steps_left_ == 0;
    if (steps_left_ > 0) {
      for (std::size_t joint = 0; joint < target_.size(); ++joint)
        target_[joint] += (goal_[joint] - target_[joint]) / steps_left_;
      --steps_left_;
    }
    action.position = target_;
    action.tools[0] = {way_[next_ - 1].opening_m, 70};
    return action;
  }

 private:
  Result<void> head_for(const Waypoint& place) {
    robots::ArmJoints from{};
    std::ranges::copy(target_, from.begin());
    MARKETGEN_TRY(const robots::ArmJoints to,
                  robots::nearest_arm_solution(
                      arm_, {place.tip, rotation_with_axes({0, 1, 0}, {0, 0, -1})}, from));
    goal_.assign(to.begin(), to.begin() + std::ssize(target_));
    double farthest = 0;
    for (std::size_t joint = 0; joint < goal_.size(); ++joint)
      farthest = std::max(farthest, std::abs(goal_[joint] - target_[joint]));
    const double time_s = std::max(0.5, farthest / place.speed_rad_s);
    steps_left_ = static_cast<int>(std::ceil(time_s / episodes::control_step_s));
    return {};
  }

  robots::ArmIk arm_;
  std::vector<Waypoint> way_;
  std::size_t next_ = 0;
  int steps_left_ = 0;
  std::vector<double> target_, goal_;
};

}  // namespace marketgen
