// One hand's part in moving a door: to where it takes hold of the leaf or presses on it, along with
// it, off it and home.
//
// World frame, SI units; a door's position is in rad.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/seed.h"
#include "motion/tool_line.h"
#include "robots/robot.h"
#include "skills/hinged_door.h"
#include "skills/pick_ways.h"

namespace marketgen::skills {

// The robot's state with the arm in another posture.
std::vector<double> with_arm(const robots::JointGroup& arm,
                             std::vector<double> state,
                             const motion::Configuration& q);

// Where the robot stands, and what it must not meet there but the leaf.
struct DoorStand {
  Pose world_from_base;
  std::vector<double> state;          // every degree of freedom; the arm at work where it is stowed
  motion::Obstacles around;           // with what it carries, without the leaf
  std::vector<double> at_reach = {};  // the state while the arm comes to the leaf; empty: the same
};

// What an arm's way with a door is worth; more is better.
using WorthOfWay =
    std::function<double(const robots::JointGroup& arm, const motion::JointPath& way)>;

// How the door is to move with the tip of a hand.
struct HandSwing {
  double from_rad = 0, to_rad = 0;
  double min_rad = 0;  // that will do, from `from_rad` on
  std::function<Pose(double position_rad)> world_from_tip;
  // Of the ways in which the arm can follow, the one of most worth; without it the one that begins
  // nearest to where the arm is.
  WorthOfWay worth = {};
};

struct HandOnDoor {
  std::string group;                       // of the arm
  int tool = 0;                            // in Robot::tools
  double end_rad = 0;                      // of the door, after the swing
  double worth = 0;                        // by HandSwing::worth
  motion::JointTrajectory reach, swing;    // to the leaf; with it
  motion::JointTrajectory leave;           // off it, and to where it began
  motion::Configuration at_start, at_end;  // of the swing
};

class DoorHand {
 public:
  // Both must outlive it. Errors: those of make_arm_model.
  static Result<DoorHand> make(const robots::Robot& robot,
                               const HingedDoor& door,
                               const Hand& hand);

  // Errors: robot.unreachable or motion.* with what was wrong where it came farthest.
  Result<HandOnDoor> plan(const DoorStand& stand, const HandSwing& swing, Seed seed) const;

  // Off the leaf and home again, from a posture of the arm in which it touches the leaf. Errors:
  // those of plan_leave.
  Result<motion::JointTrajectory> leave(const DoorStand& stand,
                                        const motion::Configuration& at,
                                        double position_rad,
                                        Seed seed) const;

  const Hand& hand() const { return hand_; }

 private:
  struct Followed {
    motion::JointPath path;
    double end_rad = 0;
  };
  std::optional<motion::Configuration> next_posture(const DoorStand& stand,
                                                    const motion::ArmChecker& checker,
                                                    const Pose& world_from_tip,
                                                    const motion::Configuration& last) const;
  Followed follow(const DoorStand& stand,
                  const motion::ArmChecker& checker,
                  const HandSwing& swing,
                  const motion::Configuration& start) const;
  std::vector<motion::Configuration> by_worth(const DoorStand& stand,
                                              const motion::ArmChecker& checker,
                                              const HandSwing& swing,
                                              std::vector<motion::Configuration> starts) const;
  Result<HandOnDoor> timed(const DoorStand& stand,
                           const motion::CollisionWorld& still,
                           const HandSwing& swing,
                           const Followed& followed,
                           Seed seed) const;
  Result<motion::LeavePlan> off_it(const DoorStand& stand,
                                   const motion::CollisionWorld& still,
                                   const motion::Configuration& at,
                                   double position_rad,
                                   Seed seed) const;

  const robots::Robot* robot_ = nullptr;
  const HingedDoor* door_ = nullptr;
  Hand hand_;
  motion::ArmModel model_;
  std::vector<int> fingers_;  // links
};

// Whether a robot that stands so is clear of the leaf, but for the links in `without`.
bool is_clear_of_leaf(const robots::Robot& robot,
                      const std::vector<double>& state,
                      const Pose& world_from_base,
                      const HingedDoor& door,
                      double position_rad,
                      const std::vector<int>& without = {});

}  // namespace marketgen::skills
