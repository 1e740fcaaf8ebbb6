// How a robot takes what stands at a pose off a shelf: where it stands, and its arm's ways. What is
// known of the surroundings is given, so that who plans may have measured it.
//
// Store frame, SI units.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/seed.h"
#include "robots/grasp_tool.h"
#include "robots/robot.h"
#include "skills/pick_ways.h"

namespace marketgen::skills {

struct ShelfPick : PickWays {
  std::string group;  // of the arm
  int tool = 0;       // in Robot::tools
  robots::Grasp grasp;
  std::size_t number = 0;  // of the grasp, in the question's
  Pose world_from_base;
  std::vector<double> state;  // every degree of freedom at the start; fingers open
};

struct ShelfPickQuestion : PickMotion {
  Pose world_from_product;
  double depth_m = 0;                 // of the pack
  std::vector<robots::Grasp> grasps;  // best first
  std::string tool_row;               // of the gripper that they are for
  std::vector<double> driving;        // the robot's state while it drives
  PickSurroundings around;
  // An error where the robot, in that state, cannot stand there. Not asked when there is none.
  std::function<Result<void>(const Pose& world_from_base, const std::vector<double>& state)>
      may_stand;
  // An error where what that hand holds so cannot be let go afterwards. Not asked when there is
  // none.
  std::function<Result<void>(const ShelfPick&)> may_hold;
  std::optional<Pose> world_from_base = {};  // stands there and nowhere else
  // Of the lift, from the one at which a grasp is at the height that suits an arm; tried in this
  // order.
  std::vector<double> lift_offsets_m = {0};
  std::string where;  // of errors: what is to be taken
};

// Over the grasps, the robot's arms that end in that gripper, and places in front of the product.
// Errors: collect.no_place with what was wrong at the place that was tried last; at a place that is
// given, what is wrong there; that of may_hold where a grasp was in reach; robot.unknown when
// no arm of the robot ends in the gripper; those of make_arm_model.
Result<ShelfPick> plan_shelf_pick(const robots::Robot& robot,
                                  const ShelfPickQuestion& question,
                                  Seed seed);

}  // namespace marketgen::skills
