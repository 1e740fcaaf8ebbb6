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

// For a hand that feels what it meets: over the basket, and from there straight down until it has
// come upon something, or to the end. What lies in a basket that is driven about rolls, so that the
// way goes on past where something was left.
struct FeltDrop {
  motion::JointTrajectory way;   // to over the basket
  motion::JointTrajectory down;  // slowly, as far as there is room over the basket's floor
  Pose base_from_tip;            // at its end
};

// Out of the basket, empty, from where the arm let go.
struct BasketExit {
  motion::JointTrajectory retreat;  // back along the tool, or else straight up
  motion::JointTrajectory home;     // to the stowed posture
};

// Over what is under it, the better one first: from 40 mm it arrives with 0.9 m/s.
inline constexpr std::array drop_heights_m{0.012, 0.040};

// Errors: collect.no_drop with what was wrong where it came nearest; those of make_arm_model.
Result<DropPlan> plan_drop(const robots::Robot& robot,
                           const CarriedBasket& basket,
                           const DropQuestion& question,
                           Seed seed);

// Errors: as plan_drop.
Result<FeltDrop> plan_felt_drop(const robots::Robot& robot,
                                const CarriedBasket& basket,
                                const DropQuestion& question,
                                Seed seed);

// What was let go may lie at the fingers: what lies in the basket is not minded. Errors: those of
// make_arm_model, tool_line and plan_arm.
Result<BasketExit> plan_basket_exit(const robots::Robot& robot,
                                    const CarriedBasket& basket,
                                    const StowQuestion& question,
                                    Seed seed);

// Straight up until the hand is so much higher, past the basket's walls alone. Errors: those of
// make_arm_model and tool_line.
Result<motion::JointTrajectory> plan_rise(const robots::Robot& robot,
                                          const CarriedBasket& basket,
                                          const StowQuestion& question,
                                          double up_m);

// The empty arm to its stowed posture. Errors: those of make_arm_model and plan_arm.
Result<motion::JointTrajectory> plan_stow(const robots::Robot& robot,
                                          const CarriedBasket& basket,
                                          const StowQuestion& question,
                                          Seed seed);

// Heights of the lift at which both arms reach the basket, the best first.
inline constexpr std::array drop_lifts_m{0.3, 0.45, 0.15, 0.6};

}  // namespace marketgen::skills
