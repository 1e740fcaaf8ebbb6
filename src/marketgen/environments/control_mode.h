// What the numbers of an environment's action mean, for any robot: one arm that stands still, or
// two on a base that drives.
//
// In this order: the move; an opening for each tool (-1 closed, 1 open; a cup sucks up to 0); speed
// and turn rate of a base that drives, as shares of the most; where wanted, stop (above 0: the
// agent has done).
// All are in [-1, 1] and clipped to it, but the joints of pd_joint_pos.
#pragma once
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "agent/policy.h"
#include "base/result.h"
#include "robots/numeric_ik.h"
#include "robots/robot.h"

namespace marketgen::environments {

// What the move is. Names as in ManiSkill.
//   pd_joint_pos        every joint that is commanded: rad or m
//   pd_joint_delta_pos  the same from its last target, or from a step before it when its drive
//                       stays behind: 1 = 0.1 rad, or what a slide does in a step
//   pd_ee_delta_pos     of each tool x, y, z: 1 = 20 mm from where it is; then the joints of no arm
//                       (lift, head) as in pd_joint_delta_pos
//   pd_ee_delta_pose    the same, and after x, y, z a turn about these axes: 1 = 0.1 rad
// Axes are those of the robot's base. A tool that cannot be brought where it is told goes as near
// as its arm can from where it is (nearest_numeric), and ToolCut says how far that stays off.
enum class ControlMode { pd_joint_pos, pd_joint_delta_pos, pd_ee_delta_pos, pd_ee_delta_pose };
constexpr std::array<std::string_view, 4> names_of(ControlMode) {
  return {"pd_joint_pos", "pd_joint_delta_pos", "pd_ee_delta_pos", "pd_ee_delta_pose"};
}

// One number of an action.
struct ActionNumber {
  std::string name;  // "joint1", "left_tool_z", "left_tool_opening", "drive", "stop"
  double low = -1, high = 1;
  double unit = 0;                  // what 1 stands for, in `dimension`; 0: a share of the most
  std::string_view dimension = {};  // "rad", "m" or none
};

// How far a tool's target was cut: from where its numbers told it to be to where it was sent; both
// 0 when that is the same, to 1e-5.
struct ToolCut {
  double off_m = 0, off_rad = 0;
};

struct MappedAction {
  agent::Action action;
  std::vector<ToolCut> cuts;  // one a tool in modes of tools, else none
};

// Immutable; the robot must outlive it.
class ActionMap {
 public:
  // `grip_n`: how hard the fingers press that are told to shut.
  ActionMap(const robots::Robot& robot,
            ControlMode mode,
            bool stop = true,
            double grip_n = agent::ToolCommand{}.force_n);

  const std::vector<ActionNumber>& numbers() const { return numbers_; }

  // `state`: all degrees of freedom as they are; `target`: of the commanded joints, where the last
  // step left them. `values` has as many numbers as numbers(), finite. Errors: robot.bad_state.
  Result<MappedAction> action(std::span<const double> values,
                              const std::vector<double>& state,
                              const std::vector<double>& target) const;

  // The other way: numbers of which action() makes `wanted`, as near as they can say it. They have
  // no force of a tool, and a step of pd_joint_delta_pos is no longer than its most. Error
  // usage.bad_flag: how an arm is bent cannot be said in the modes of tools.
  Result<std::vector<double>> values(const agent::Action& wanted,
                                     const std::vector<double>& target) const;

  // Of each tool in the frame of the robot's base.
  std::vector<Pose> tool_poses(const std::vector<double>& state) const;
  // Of the commanded joints: targets from which the next step goes on when the drives are told
  // `told`. No farther from it than one step of pd_joint_delta_pos, so that what is held back does
  // not run ahead.
  std::vector<double> led(std::vector<double> target, const std::vector<double>& told) const;

 private:
  struct Arm {
    int frame = -1;
    std::vector<int> dofs;
  };
  void add_joints(bool absolute);
  void add_tools();
  std::vector<double> at_origin(std::vector<double> state) const;
  Result<robots::NearestIk> moved_tool(const Arm& arm,
                                       std::span<const double> by,
                                       const std::vector<double>& state) const;
  std::vector<double> moved_joints(std::span<const double> values,
                                   const std::vector<double>& target) const;
  Result<MappedAction> moved_tools(std::span<const double> values,
                                   const std::vector<double>& state,
                                   const std::vector<double>& target) const;
  double step_of(int dof) const;

  const robots::Robot& robot_;
  ControlMode mode_;
  bool stop_;
  double grip_n_;
  std::vector<int> joints_;  // degrees of freedom that are commanded
  std::vector<int> other_;   // of these, those of no arm, as places in joints_
  std::vector<Arm> arms_;    // one a tool
  std::vector<ActionNumber> numbers_;
};

}  // namespace marketgen::environments
