#include "environments/teleop_hands.h"

#include <algorithm>
#include <cmath>

namespace marketgen::environments {
namespace {

constexpr std::size_t numbers_of_tool = 6;  // x, y, z and the turns about them

double on_grid(double value) {
  return std::clamp(std::round(value / teleop_grid) * teleop_grid, -1.0, 1.0);
}

std::array<double, 3> along(const std::array<double, 3>& by, const Quaternion& base_from_axes) {
  const Vec3 turned = rotate(base_from_axes, {by[0], by[1], by[2]});
  return {turned.x, turned.y, turned.z};
}

}  // namespace

std::vector<ActionNumber> teleop_joints(const Environment& environment) {
  const robots::Robot& robot = environment.world().robot();
  const std::vector<ActionNumber>& all = environment.action_numbers();
  const std::size_t behind = robot.tools.size() + (robot.drive ? 2 : 0) + 1;  // 1: stop
  return {all.begin() + static_cast<std::ptrdiff_t>(robot.tools.size() * numbers_of_tool),
          all.end() - static_cast<std::ptrdiff_t>(behind)};
}

TeleopHands::TeleopHands(const Environment& environment) : environment_(environment) {
  const std::vector<double> now = environment.world().observe().openings_m;
  for (std::size_t tool = 0; tool < now.size(); ++tool) {
    const robots::Tool& row = environment.world().robot().tools[tool];
    const double most = row.kind == robots::ToolKind::suction ? agent::cup_off_m : row.opening;
    openings_.push_back(on_grid(2 * now[tool] / most - 1));
  }
}

std::vector<double> TeleopHands::numbers(const robots::TeleopCommand& command, bool stop) {
  const robots::Robot& robot = environment_.world().robot();
  const std::vector<Pose> tools = environment_.tool_poses();
  const std::size_t arm = std::min(static_cast<std::size_t>(command.arm), tools.size() - 1);
  if (command.grip != robots::TeleopGrip::keep)
    openings_[arm] = command.grip == robots::TeleopGrip::open ? 1 : -1;
  const Quaternion axes =
      command.axes == robots::TeleopAxes::tool ? tools[arm].rotation : Quaternion{1, 0, 0, 0};
  std::vector<double> numbers(tools.size() * numbers_of_tool, 0.0);
  const auto put = [&](std::size_t at, const std::array<double, 3>& by) {
    std::ranges::transform(
        along(by, axes), numbers.begin() + static_cast<std::ptrdiff_t>(at), on_grid);
  };
  put(arm * numbers_of_tool, command.move);
  put(arm * numbers_of_tool + 3, command.twist);
  const std::size_t others = teleop_joints(environment_).size();
  for (std::size_t j = 0; j < others; ++j)
    numbers.push_back(j < command.joints.size() ? on_grid(command.joints[j]) : 0.0);
  numbers.insert(numbers.end(), openings_.begin(), openings_.end());
  if (robot.drive) {
    numbers.push_back(on_grid(command.drive));
    numbers.push_back(on_grid(command.turn));
  }
  numbers.push_back(stop ? 1 : -1);
  return numbers;
}

}  // namespace marketgen::environments
