// The arm's ways of one pick off a shelf, from a place where the robot stands: to the grasp, up,
// and straight out. What the planners of picks share, whoever knows the surroundings.
//
// Store frame, SI units.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "base/seed.h"
#include "motion/collision_world.h"
#include "motion/tool_line.h"
#include "robots/robot.h"

namespace marketgen::skills {

// What stands round a shelf, and how the arm moves there.
struct PickSurroundings {
  motion::Obstacles way;   // what the arm keeps off
  motion::Obstacles line;  // the same on lines, where the hand may push things aside
  std::vector<motion::BoxObstacle> carried;  // by the robot, in its base frame: a basket
};
struct PickMotion {
  double speed = 0.6;        // share of the joints' velocity limits, over 0 to 1
  double acceleration = 1;   // the same of their acceleration limits
  double approach_m = 0.12;  // length of the straight line to the grasp
  double lift_m = 0.015;     // straight up before it goes out
  double retreat_m = 0.22;   // straight out of the shelf
};

struct PickPlace {
  Pose world_from_base;
  std::vector<double> state;  // every degree of freedom at the start; fingers open
  Pose world_from_tip;        // at the grasp
  Vec3 out;                   // from the shelf into the aisle, unit
};

struct PickWays {
  motion::ReachPlan reach;                // to the grasp
  motion::JointTrajectory lift, retreat;  // with the product
};

// Errors: those of CollisionWorld, ArmChecker, plan_reach and tool_line.
Result<PickWays> plan_pick_ways(const motion::ArmModel& model,
                                const PickPlace& place,
                                const PickSurroundings& around,
                                const PickMotion& motion,
                                Seed seed);

// A robot that drives, its lift at this height (as far as it goes) and each of its grippers open so
// far.
std::vector<double> raised_state(const robots::Robot& robot,
                                 std::vector<double> driving,
                                 double lift_m,
                                 double opening_m);
// The same in a posture; without its name, or where the robot has none of it, in its first.
std::vector<double> stowed_state(const robots::Robot& robot,
                                 const std::string& posture,
                                 double lift_m,
                                 double opening_m);

// Where the base stands so far before a product's front, the product `side` to its left. `out`:
// from the shelf into the aisle.
Pose place_before_shelf(Vec3 product, double depth_m, Vec3 out, double distance_m, double side_m);

// An arm that ends in a tool.
struct Hand {
  const robots::JointGroup* arm = nullptr;
  int tool = -1;  // in Robot::tools
};
// Those that end in a tool of this row, by the order of the tools. Errors: robot.unknown where no
// arm does.
Result<std::vector<Hand>> hands_with(const robots::Robot& robot, const std::string& tool_row);

// Boxes that a robot carries, in the store frame.
std::vector<motion::BoxObstacle> carried_at(const std::vector<motion::BoxObstacle>& carried,
                                            const Pose& world_from_base);

// Back along a line on which the arm came, empty, at half the speed at which it carries.
Result<motion::JointTrajectory> way_back(const robots::Robot& robot,
                                         const std::string& group,
                                         const motion::JointPath& line);

// Shares of the joints' limits: an arm that carries something moves gently.
constexpr double carrying_speed = 0.4, carrying_acceleration = 0.25;

}  // namespace marketgen::skills
