#include "skills/aisle_executor.h"

#include "skills/door_moves.h"

namespace marketgen::skills {
namespace {

constexpr double calm_s = 0.3;   // until nothing swings
constexpr double press_s = 0.7;  // until a tool has taken hold
constexpr double let_go_s = 0.5;
constexpr double back_off_m_s = 0.2;
constexpr double lift_speed_share = 0.9, head_speed_share = 0.9;

}  // namespace

AisleExecutor::AisleExecutor(const robots::Robot& robot, std::vector<int> commanded)
    : robot_(&robot), body_(robot, std::move(commanded)) {}

void AisleExecutor::start(const agent::Observation& now) {
  body_.start(now);
}

void AisleExecutor::drive(motion::BaseFollower way) {
  body_.set_subtask(agent::Subtask::drive);
  body_.follow(std::move(way));
  body_.wait(calm_s);
}

void AisleExecutor::drive(motion::WayRound way) {
  body_.set_subtask(agent::Subtask::drive);
  if (way.aside) body_.follow(std::move(*way.aside));
  if (way.wait_s > 0) body_.wait(way.wait_s);
  drive(std::move(way.on));
}

Result<void> AisleExecutor::look(double pan, double tilt) {
  body_.set_subtask(agent::Subtask::look);
  MARKETGEN_CHECK(body_.move_joint(robot_->find_dof("head_pan"), pan, head_speed_share));
  MARKETGEN_CHECK(body_.move_joint(robot_->find_dof("head_tilt"), tilt, head_speed_share));
  body_.wait(calm_s);
  return {};
}

Result<void> AisleExecutor::raise(double lift_m, agent::Subtask of) {
  body_.set_subtask(of);
  return body_.move_joint(robot_->find_dof("lift"), lift_m, lift_speed_share);
}

void AisleExecutor::open(int tool, agent::ToolCommand command) {
  body_.grip(tool, command);
  body_.wait(let_go_s);
}

Result<void> AisleExecutor::take(Taking taking) {
  taking_ = std::move(taking);
  MARKETGEN_CHECK(raise(taking_.lift_m, agent::Subtask::reach));
  open(taking_.tool, taking_.open);
  body_.play(arm(), taking_.ways.reach.trajectory);
  body_.set_subtask(agent::Subtask::grasp);
  body_.grip(taking_.tool, taking_.close);
  body_.wait(press_s);
  return {};
}

void AisleExecutor::pull_out() {
  body_.set_subtask(agent::Subtask::lift);
  body_.play(arm(), taking_.ways.lift);
  body_.play(arm(), taking_.ways.retreat);
}

Result<void> AisleExecutor::go_back() {
  MARKETGEN_TRY(motion::JointTrajectory way,
                way_back(*robot_, taking_.group, taking_.ways.reach.line));
  body_.set_subtask(agent::Subtask::retreat);
  open(taking_.tool, taking_.open);
  body_.play(arm(), std::move(way));
  return {};
}

Result<void> AisleExecutor::back_off(double room_m) {
  body_.set_subtask(agent::Subtask::drive);
  if (room_m > 0) MARKETGEN_CHECK(body_.drive_straight(-room_m, back_off_m_s));
  body_.wait(calm_s);
  return {};
}

void AisleExecutor::let_down(DropPlan plan, agent::ToolCommand let_go) {
  body_.set_subtask(agent::Subtask::place);
  body_.play(arm(), std::move(plan.way));
  body_.wait(calm_s);
  open(taking_.tool, let_go);
  body_.set_subtask(agent::Subtask::retreat);
  body_.play(arm(), std::move(plan.retreat));
  stow(std::move(plan.home));
}

void AisleExecutor::let_down(FeltDrop plan, double max_force_n) {
  body_.set_subtask(agent::Subtask::place);
  body_.play(arm(), std::move(plan.way));
  body_.wait(calm_s);
  body_.feel(arm(), std::move(plan.down), max_force_n);
  body_.wait(calm_s);
}

void AisleExecutor::take_up(motion::JointTrajectory way) {
  body_.play(arm(), std::move(way));
  body_.wait(calm_s);
}

void AisleExecutor::leave_basket(BasketExit plan) {
  body_.set_subtask(agent::Subtask::retreat);
  body_.play(arm(), std::move(plan.retreat));
  stow(std::move(plan.home));
}

void AisleExecutor::stow(motion::JointTrajectory way) {
  body_.set_subtask(agent::Subtask::retreat);
  body_.play(arm(), std::move(way));
  body_.wait(calm_s);
}

void AisleExecutor::stow(const std::string& group, motion::JointTrajectory way) {
  body_.play(robot_->find_group(group)->dofs, std::move(way));
  body_.wait(calm_s);
}

Result<void> AisleExecutor::move_door(const DoorPlan& plan, double then_wait_s) {
  MARKETGEN_CHECK(queue_door(body_, *robot_, plan));
  body_.wait(then_wait_s);
  return {};
}

}  // namespace marketgen::skills
