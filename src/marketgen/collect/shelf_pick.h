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
#include "motion/collision_world.h"
#include "motion/tool_line.h"
#include "robots/grasp_tool.h"
#include "robots/robot.h"

namespace marketgen {

struct ShelfPickQuestion {
  Pose world_from_product;
  double depth_m = 0;                // of the pack
  std::vector<Grasp> grasps;         // best first
  std::string tool_row;              // of the gripper that they are for
  std::vector<double> driving;       // the robot's state while it drives
  std::vector<BoxObstacle> carried;  // by the robot, in its base frame
  Obstacles way;                     // what the arm keeps off
  Obstacles line;                    // the same on lines, where the hand may push things aside
  std::function<bool(const Pose& world_from_base)> may_stand;
  std::optional<Pose> world_from_base = {};  // stands there and nowhere else
  double speed = 0.6, acceleration = 1;      // shares of the joints' limits
  double approach_m = 0.12;                  // length of the straight line to the grasp
  double lift_m = 0.015;                     // straight up before it goes out
  double retreat_m = 0.22;                   // straight out of the shelf
};

struct ShelfPick {
  std::string group;  // of the arm
  int tool = 0;       // in Robot::tools
  Grasp grasp;
  Pose world_from_base;
  std::vector<double> state;  // every degree of freedom at the start; fingers open
  ReachPlan reach;            // to the grasp
  JointTrajectory lift, retreat;
};

// Over the grasps, the robot's arms that end in that gripper, and places in front of the product.
// Errors: collect.no_place with what was wrong at the place that was tried last; robot.unknown when
// no arm of the robot ends in the gripper; those of make_arm_model.
Result<ShelfPick> plan_shelf_pick(const Robot& robot, const ShelfPickQuestion& question, Seed seed);

}  // namespace marketgen
