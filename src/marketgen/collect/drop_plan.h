// How an arm lets what it holds down into the basket that its robot carries, and comes back.
//
// The tool looks down into the basket. The product is let go a little over what lies under it, so
// that it never falls far. Base frame: that of the robot (on the floor, X ahead). SI units.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/seed.h"
#include "collect/held_product.h"
#include "motion/tool_line.h"
#include "robots/robot.h"

namespace marketgen {

// The inside of the basket: a box that is open above.
struct CarriedBasket {
  Pose base_from_floor;            // middle of its inner floor, Z up
  Vec3 size;                       // inner; z up to the rim
  std::vector<BoxObstacle> walls;  // base frame, floor included
};

struct DropQuestion {
  std::vector<double> state;  // every degree of freedom of the robot, as it stands now
  Pose world_from_base;
  std::string group;  // of the arm that holds it
  int tool = 0;       // in Robot::tools
  const ProductBody* held = nullptr;
  Pose tip_from_product;            // as it is held
  double opening_m = 0;             // of the gripper when it lets go
  Obstacles around;                 // of the store, world frame
  std::vector<BoxObstacle> inside;  // what lies in the basket, base frame
  Configuration stow;               // of the arm, where it goes afterwards
};

struct DropPlan {
  Pose base_from_tip;       // where it lets go
  JointTrajectory way;      // to there
  JointTrajectory retreat;  // straight out, empty
  JointTrajectory home;     // to the stowed posture
};

// Shares of the joints' limits: an arm that carries something moves gently.
constexpr double carrying_speed = 0.4, carrying_acceleration = 0.25;
// Over what is under it, the better one first: from 40 mm it arrives with 0.9 m/s.
inline constexpr std::array drop_heights_m{0.012, 0.040};

// Errors: collect.no_drop with what was wrong where it came nearest; those of make_arm_model.
Result<DropPlan> plan_drop(const Robot& robot,
                           const CarriedBasket& basket,
                           const DropQuestion& question,
                           Seed seed);

}  // namespace marketgen
