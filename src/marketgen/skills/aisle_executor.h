// Carries out what a robot does to take an item off a shelf and let it down into the basket that it
// carries: ways of its base, its lift, its head and an arm, one after another. Everyone's: whoever
// knows the surroundings, or has measured them, plans the ways; it knows nothing of them.
//
// SI units.
#pragma once
#include <string>
#include <vector>

#include "agent/policy.h"
#include "motion/way_round.h"
#include "skills/body_executor.h"
#include "skills/door_ways.h"
#include "skills/drop_plan.h"
#include "skills/pick_ways.h"

namespace marketgen::skills {

// One item's: by which arm, and how its tool takes hold.
struct Taking {
  PickWays ways;
  std::string group;  // of the arm
  int tool = 0;       // in Robot::tools
  double lift_m = 0;  // height of the lift
  agent::ToolCommand open, close;
};

class AisleExecutor {
 public:
  // `commanded`: the degrees of freedom of an action's positions. The robot must outlive it.
  AisleExecutor(const robots::Robot& robot, std::vector<int> commanded);

  void start(const agent::Observation& now);  // forgets what is queued
  bool idle() const { return body_.idle(); }
  bool take_stop() { return body_.take_stop(); }        // as BodyExecutor
  bool take_held_up() { return body_.take_held_up(); }  // likewise
  bool presses(int tool) const { return body_.told(tool).opening_m <= 0; }
  agent::Action next(const agent::Observation& now) { return body_.next(now); }
  agent::Subtask subtask() const { return body_.subtask(); }  // as BodyExecutor

  // ---- Each queues motions, and says what they are for. Errors: motion.bad_limits; those of
  // way_back. ----
  void drive(motion::BaseFollower way);
  void drive(motion::WayRound way);
  Result<void> look(double pan, double tilt);  // the head, to the left and down, rad
  void wait(double seconds) { body_.wait(seconds); }
  Result<void> raise(double lift_m, agent::Subtask of);
  void open(int tool, agent::ToolCommand command);  // for what was queued before

  Result<void> take(Taking taking);  // from where it stands, up to the grip
  void pull_out();                   // with the item
  Result<void> go_back();            // empty, the way that the arm came
  Result<void> back_off(double room_m);
  void let_down(DropPlan plan, agent::ToolCommand let_go);  // into the basket; then home
  // A hand that feels what it meets: it is left there, and holds on.
  void let_down(FeltDrop plan, double max_force_n);
  void take_up(motion::JointTrajectory way);  // from there, with what it holds
  void let_go(agent::ToolCommand let_go) { open(taking_.tool, let_go); }
  double felt_share() const { return body_.felt_share(); }           // as BodyExecutor
  void leave_basket(BasketExit plan);                                // from there
  void stow(motion::JointTrajectory way);                            // the empty arm
  void stow(const std::string& group, motion::JointTrajectory way);  // another arm
  // Opens or shuts a door, as planned, from where the robot stands; then waits.
  Result<void> move_door(const DoorPlan& plan, double then_wait_s);

 private:
  const std::vector<int>& arm() const { return robot_->find_group(taking_.group)->dofs; }

  const robots::Robot* robot_;
  BodyExecutor body_;
  Taking taking_;  // the last one
};

}  // namespace marketgen::skills
