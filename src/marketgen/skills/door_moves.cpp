#include "skills/door_moves.h"

namespace marketgen::skills {
namespace {

constexpr double door_grips_s = 0.7, door_lets_go_s = 0.5, door_calm_s = 0.3;
constexpr double door_lift_share = 0.9;  // of its speed
constexpr double shut_fingers_n = 10;

const std::vector<int>& arm_of(const robots::Robot& robot, const HandOnDoor& hand) {
  return robot.find_group(hand.group)->dofs;
}

}  // namespace

Result<void> queue_door(BodyExecutor& body, const robots::Robot& robot, const DoorPlan& plan) {
  const int lift = robot.find_dof("lift");
  if (lift >= 0)
    MARKETGEN_CHECK(
        body.move_joint(lift, plan.state[static_cast<std::size_t>(lift)], door_lift_share));
  const HandOnDoor& push = plan.push;
  for (const HandOnDoor& pull : plan.pulls) {
    body.grip(pull.tool, {plan.grip_opening_m});
    body.wait(door_lets_go_s);
    body.play(arm_of(robot, pull), pull.reach);
    body.grip(pull.tool, {0, bar_grip_n});
    body.wait(door_grips_s);
    body.play(arm_of(robot, pull), pull.swing);
  }
  body.grip(push.tool, {0, shut_fingers_n});
  body.wait(door_lets_go_s);
  body.play(arm_of(robot, push), push.reach);
  for (const HandOnDoor& pull : plan.pulls) {
    body.grip(pull.tool, {plan.grip_opening_m});
    body.wait(door_lets_go_s);
    body.play(arm_of(robot, pull), pull.leave);
  }
  body.play(arm_of(robot, push), push.swing);
  body.play(arm_of(robot, push), push.leave);
  body.wait(door_calm_s);
  return {};
}

}  // namespace marketgen::skills
