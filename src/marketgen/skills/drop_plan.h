// How an arm lets what it holds down into the basket that its robot carries, and comes back.
//
// The tool looks down into the basket. The product is let go a little over what lies under it, so
// that it never falls far. Base frame: that of the robot (on the floor, X ahead). SI units.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/seed.h"
#include "robots/robot.h"
#include "skills/carried_basket.h"
#include "skills/pick_ways.h"

namespace marketgen::skills {

// An arm of a robot that stands in a store with its basket.
struct StowQuestion {
  std::vector<double> state;  // every degree of freedom of the robot, as it stands now
  Pose world_from_base;
  std::string group;                     // of the arm
  motion::Obstacles around;              // of the store, world frame
  motion::Configuration stow;            // of the arm, where it is to end
  std::vector<CarriedItem> inside = {};  // what lies in the basket
};

struct DropQuestion : StowQuestion {
  int tool = 0;  // in Robot::tools, that holds it
  const assets::ProductBody* held = nullptr;
  Pose tip_from_product;                        // as it is held
  double acceleration = carrying_acceleration;  // with it in the hand, share of the joints' limits
};

struct DropPlan {
  Pose base_from_tip;               // where it lets go
  motion::JointTrajectory way;      // to there
  motion::JointTrajectory retreat;  // straight out, empty
  motion::JointTrajectory home;     // to the stowed posture
};

// Over what is under it, the better one first: from 40 mm it arrives with 0.9 m/s.
inline constexpr std::array drop_heights_m{0.012, 0.040};

// Errors: collect.no_drop with what was wrong where it came nearest; those of make_arm_model.
Result<DropPlan> plan_drop(const robots::Robot& robot,
                           const CarriedBasket& basket,
                           const DropQuestion& question,
                           Seed seed);

// The empty arm to its stowed posture. Errors: those of make_arm_model and plan_arm.
Result<motion::JointTrajectory> plan_stow(const robots::Robot& robot,
                                          const CarriedBasket& basket,
                                          const StowQuestion& question,
                                          Seed seed);

// Heights of the lift at which both arms reach the basket, the best first.
inline constexpr std::array drop_lifts_m{0.3, 0.45, 0.15, 0.6};

}  // namespace marketgen::skills
