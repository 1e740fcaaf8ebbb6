// How a robot with two arms opens a door on an upright hinge, and shuts it again: where it stands,
// and its arms' ways. What is known of the surroundings is given, so that who plans may have
// measured it.
//
// To open it one hand takes the bar and pulls the leaf out as far as its arm goes; the other comes
// behind the leaf and pushes it on to where it stays open by itself. To shut it a hand presses on
// the outer face until the door's own spring takes it.
//
// World frame, SI units; a door's position is in rad.
#pragma once
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "skills/door_hand.h"

namespace marketgen::skills {

struct DoorQuestion {
  HingedDoor door;
  double position_rad = 0;                   // where it is
  std::string tool_row;                      // of the grippers
  std::vector<double> driving;               // the robot's state while it drives
  motion::Obstacles around;                  // what stands there, without the leaf
  std::vector<motion::BoxObstacle> carried;  // by the robot, in its base frame: a basket
  // An error where the robot, in that state, cannot stand or come to. Not asked when there is none.
  std::function<Result<void>(const Pose& world_from_base, const std::vector<double>& state)>
      may_stand;
  std::optional<Pose> world_from_base = {};  // stands there and nowhere else
  // So far the hand at the bar pulls at least: from there on the other finds room behind the leaf.
  double min_pulled_rad = 48 * std::numbers::pi / 180;
  WorthOfWay worth_of_pull = {};  // see HandSwing
  std::string where;              // of errors: the door
};

struct DoorPlan {
  Pose world_from_base;
  std::vector<double> state;      // every degree of freedom at the start
  std::vector<HandOnDoor> pulls;  // one where it is opened
  HandOnDoor push;
  double grip_opening_m = 0;  // of the hand that comes to the bar
};

// Errors: collect.no_place with what was wrong at the place that was tried last; collect.no_door
// for a door that does not stay open; robot.unknown when no two arms of the robot end in the
// gripper; those of make_arm_model.
Result<DoorPlan> plan_open_door(const robots::Robot& robot,
                                const DoorQuestion& question,
                                Seed seed);

// Errors: as above, but one arm will do.
Result<DoorPlan> plan_shut_door(const robots::Robot& robot,
                                const DoorQuestion& question,
                                Seed seed);

// One hand's part in opening it, by which it is pulled so far as is asked for: of the ways at the
// place that serves, the one of most worth.
struct DoorPull {
  Pose world_from_base;
  std::vector<double> state;  // every degree of freedom at the start
  HandOnDoor hand;
};
// Errors: as of plan_shut_door().
Result<DoorPull> plan_pull_door(const robots::Robot& robot,
                                const DoorQuestion& question,
                                Seed seed);

}  // namespace marketgen::skills
