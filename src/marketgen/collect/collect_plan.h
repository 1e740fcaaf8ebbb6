// How a robot takes one product off its shelf: where it stands, where it takes hold, and its arm's
// ways. Everything is known: this is what an oracle and a certificate build on, not what a policy
// may use.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/seed.h"
#include "collect/goods_now.h"
#include "motion/grasp_candidates.h"
#include "robots/robot.h"
#include "skills/pick_ways.h"

namespace marketgen::collect {

struct CollectOptions : skills::PickMotion {
  std::string posture = {};  // of the arms at the start; empty: the robot's first
  std::vector<motion::BoxObstacle> carried = {};  // by the robot, in its base frame: a basket
  std::vector<motion::GraspCandidate> grasps =
      {};  // tried in this order; empty: all from the front
  // Stands there and nowhere else.
  std::optional<Pose> world_from_base = {};
  double fingers_friction = 0.5;  // of the pads on the product
  // An error where the robot, in that state, must not stand, beside what stands there in the store.
  // Not asked when there is none.
  std::function<Result<void>(const Pose& world_from_base, const std::vector<double>& state)>
      may_stand = {};
};

struct CollectPlan : skills::PickWays {
  std::uint32_t product = 0;
  std::string group;  // of the arm
  int tool = 0;       // in Robot::tools
  Pose world_from_base;
  std::vector<double> state;  // every degree of freedom at the start; fingers open
  motion::GraspCandidate grasp;
};

// The row of the gripper at the end of the robot's first arm that has one: "parallel-gripper".
// Error: robot.unknown when no arm ends in a gripper.
Result<std::string> gripper_row(const robots::Robot& robot);

// Looks for it over the product's grasps from the front, best first, over the robot's arms that end
// in that tool, and over places in front of it. Errors:
// collect.no_product for a row that does not exist; motion.no_grasp with the reason;
// collect.no_place with what was wrong at the place that came nearest; robot.unknown when no arm of
// the robot ends in a gripper; assets.*.
Result<CollectPlan> plan_collect(const GoodsNow& goods,
                                 std::uint32_t product,
                                 const robots::Robot& robot,
                                 const robots::GraspTool& tool,
                                 Seed seed,
                                 const CollectOptions& options = {});

}  // namespace marketgen::collect
