#include "episodes/track_world.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace marketgen::episodes {
namespace {

Error bad_action(const std::string& message) {
  return {"episode.bad_action", "action", message};
}

bool is_finite(const agent::Action& action) {
  const auto finite = [](double value) { return std::isfinite(value); };
  return std::ranges::all_of(action.position, finite) && finite(action.drive_m_s) &&
         finite(action.turn_rad_s) &&
         std::ranges::all_of(action.tools, [&](const agent::ToolCommand& tool) {
           return finite(tool.opening_m) && finite(tool.force_n);
         });
}

}  // namespace

std::vector<double> TrackWorld::told() const {
  std::vector<double> places;
  for (const int dof : commanded_dofs(robot()))
    places.push_back(controller().setpoints()[static_cast<std::size_t>(dof)].position);
  return places;
}

std::vector<double> TrackWorld::sensed_state() const {
  std::vector<double> state = robot_state();
  const std::vector<double> seen = observe().position;
  const std::vector<int> commanded = commanded_dofs(robot());
  for (std::size_t j = 0; j < commanded.size(); ++j)
    state[static_cast<std::size_t>(commanded[j])] = seen[j];
  return state;
}

void TrackWorld::start_senses(const robots::BasePlace& truth, const robots::BasePlace& reckoned) {
  senses_ = RobotSenses(realism_, noise_, robot(), truth, reckoned);
  late_ = LateSenses(realism_, noise_, as_it_is(), scenery());
  link_ =
      CommandLink(robot(), commanded_dofs(robot()), senses_.late_steps(), still_action(as_it_is()));
}

std::vector<int> commanded_dofs(const robots::Robot& robot) {
  std::vector<bool> left_out(robot.dof_count());
  const auto leave_out = [&](const robots::JointGroup* group) {
    if (group == nullptr) return;
    for (const int dof : group->dofs)
      left_out[static_cast<std::size_t>(dof)] = true;
  };
  if (robot.drive) leave_out(robot.find_group("base"));
  for (const robots::Tool& tool : robot.tools)
    leave_out(robot.find_group(tool.prefix + "fingers"));
  std::vector<int> dofs;
  for (std::size_t dof = 0; dof < robot.dof_count(); ++dof) {
    if (!left_out[dof] && robot.joint_of_dof(dof).follows < 0)
      dofs.push_back(static_cast<int>(dof));
  }
  return dofs;
}

std::vector<double> tool_openings_m(const robots::Robot& robot, const std::vector<double>& state) {
  std::vector<double> openings;
  for (const robots::Tool& tool : robot.tools) {
    const robots::JointGroup* fingers = robot.find_group(tool.prefix + "fingers");
    double opening = 0;
    for (const int dof : fingers == nullptr ? std::vector<int>{} : fingers->dofs)
      opening += state[static_cast<std::size_t>(dof)];
    openings.push_back(std::max(opening, 0.0));
  }
  return openings;
}

agent::Action still_action(const agent::Observation& now) {
  agent::Action action;
  action.position = now.position;
  for (const double opening : now.openings_m)
    action.tools.push_back({opening});
  return action;
}

Result<void> check_action(const agent::Action& action,
                          const robots::Robot& robot,
                          std::size_t joints,
                          bool done) {
  if (done) return bad_action("the episode is over: reset it first");
  if (action.position.size() != joints)
    return bad_action(fmt::format("{} joint values for {} joints", action.position.size(), joints));
  if (action.tools.size() != robot.tools.size())
    return bad_action(
        fmt::format("commands for {} tools, of {}", action.tools.size(), robot.tools.size()));
  const bool positive = std::ranges::all_of(action.tools, [](const agent::ToolCommand& tool) {
    return tool.opening_m >= 0 && tool.force_n >= 0;
  });
  if (!is_finite(action) || !positive)
    return bad_action("expected finite values, openings and forces from 0 on");
  if (!robot.drive && (action.drive_m_s != 0 || action.turn_rad_s != 0))
    return bad_action("this robot stands still: it cannot drive");
  return {};
}

}  // namespace marketgen::episodes
