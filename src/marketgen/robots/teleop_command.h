// What a person at keys or sticks wants of a robot.
#pragma once
#include <array>
#include <string_view>
#include <vector>

#include "base/fields.h"

namespace marketgen::robots {

// Axes along which a tool is moved: of the robot's base (X ahead, Y left, Z up), or of the tool
// itself, in which a camera at the wrist looks along Z.
enum class TeleopAxes { base, tool };
constexpr std::array<std::string_view, 2> names_of(TeleopAxes) {
  return {"base", "tool"};
}
enum class TeleopGrip { keep, open, close };
constexpr std::array<std::string_view, 3> names_of(TeleopGrip) {
  return {"keep", "open", "close"};
}

// Speeds are shares of the most that a control step can do, see ControlMode.
struct TeleopCommand {
  double drive = 0, turn = 0;             // of a base that drives; ahead, to the left
  std::array<double, 3> move{}, twist{};  // of the tool `arm`
  std::vector<double> joints;             // of those of no arm, as in the action; less: the rest 0
  int arm = 0;
  TeleopAxes axes = TeleopAxes::base;
  TeleopGrip grip = TeleopGrip::keep;  // what the tool `arm` does from now on

  static constexpr auto fields =
      field_list(field("drive", &TeleopCommand::drive, "ahead", range(-1, 1)),
                 field("turn", &TeleopCommand::turn, "to the left", range(-1, 1)),
                 field("move", &TeleopCommand::move, "of the tool along the axes", range(-1, 1)),
                 field("twist", &TeleopCommand::twist, "of the tool about them", range(-1, 1)),
                 field("joints",
                       &TeleopCommand::joints,
                       "of no arm: lift, head",
                       range(-1, 1),
                       at_most_items(16)),
                 field("arm", &TeleopCommand::arm, "which tool is moved", range(0, 7)),
                 field("axes", &TeleopCommand::axes, "of the base, or of the tool"),
                 field("grip", &TeleopCommand::grip, "of that tool: keep, open or close"));

  bool moves() const;  // anything, or opens or closes
};

}  // namespace marketgen::robots
