#include "policy/floor_policies.h"

namespace marketgen::policy {
namespace {

constexpr double max_step_rad = 0.05;  // in a control step of 50 ms
constexpr double widest_m = 0.08;
constexpr double fastest_m_s = 0.3, fastest_rad_s = 0.5;
constexpr double pull_back = 0.05;  // of the way to where the arm is: targets do not run off

}  // namespace

Result<void> RandomPolicy::begin(const agent::Task&, const agent::Observation& first) {
  target_ = first.position;
  return {};
}

Result<agent::Action> RandomPolicy::act(const agent::Observation& now) {
  for (std::size_t j = 0; j < target_.size(); ++j) {
    target_[j] += (now.position[j] - target_[j]) * pull_back;
    target_[j] += draw_.uniform(-max_step_rad, max_step_rad);
  }
  agent::Action action;
  action.position = target_;
  for (std::size_t tool = 0; tool < now.openings_m.size(); ++tool)
    action.tools.push_back({draw_.uniform(0, widest_m)});
  if (drives_) {
    action.drive_m_s = draw_.uniform(-fastest_m_s, fastest_m_s);
    action.turn_rad_s = draw_.uniform(-fastest_rad_s, fastest_rad_s);
  }
  return action;
}

Result<agent::Action> StopPolicy::act(const agent::Observation& now) {
  agent::Action action;
  action.position = now.position;
  for (const double opening : now.openings_m)
    action.tools.push_back({opening});
  action.stop = true;
  return action;
}

}  // namespace marketgen::policy
