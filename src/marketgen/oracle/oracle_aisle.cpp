#include "oracle/oracle_aisle.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/progress.h"
#include "collect/scene_obstacles.h"
#include "oracle/aisle_oracle.h"
#include "skills/hand_grasp.h"

namespace marketgen::oracle {
namespace {

constexpr double way_reach_m = 1.4;      // obstacles farther from the robot do not count
constexpr double let_go_wider_m = 0.02;  // than what was held, when it is let go

}  // namespace

AisleOracle::AisleOracle(const episodes::AisleWorld& world,
                         robots::GraspTool tool,
                         Seed seed,
                         const OracleSearch& search)
    : world_(&world),
      robot_(world.robot()),
      tool_(std::move(tool)),
      seed_(seed),
      search_(search),
      goods_(world.store().scene),
      memory_{.executor = {world.robot(), episodes::commanded_dofs(world.robot())}} {}

Result<void> AisleOracle::begin(const agent::Task& task, const agent::Observation& first) {
  task_ = task;
  if (search_.rehearses) {
    MARKETGEN_TRY(twin_, world_->twin());
  }
  memory_.executor.start(first);
  return {};
}

Result<agent::Action> AisleOracle::act(const agent::Observation& now) {
  if (memory_.plan.tool < static_cast<int>(now_.sealed.size()) &&
      tool_.kind == robots::ToolKind::suction) {
    const auto cup = static_cast<std::size_t>(memory_.plan.tool);
    if (now_.sealed[cup] && !now.sealed[cup] && now.openings_m[cup] == 0) say("the cup came off");
  }
  now_ = now;
  if (memory_.executor.idle()) MARKETGEN_CHECK(decide());
  agent::Action action = memory_.executor.next(now);
  action.stop = memory_.done;
  return action;
}

std::string AisleOracle::failure() const {
  for (const std::string& sku : unmet())
    if (const auto why = memory_.failures.find(sku); why != memory_.failures.end())
      return std::string(name_of(why->second));
  return "None";
}

void AisleOracle::say(const std::string& what) const {
  if (!is_rehearsal_) log_debug(fmt::format("oracle {:.2f} s: {}", now_.time_s, what));
}

// The arm or what it holds was pressed on, and has been moved back a second of its way: what was
// planned is given up, and goes on from here by another plan.
Result<void> AisleOracle::recover() {
  say("was stopped");
  switch (memory_.phase) {
    case Phase::choose:  // on its way to its stowed posture
      return memory_.plan.group.empty() ? fold_arms() : go_home();
    case Phase::at_door:
    case Phase::at_leaf:
      memory_.phase = Phase::choose;
      return choose();
    case Phase::opening:
    case Phase::shutting:
      return fold_arms();
    case Phase::arrived:
      memory_.phase = Phase::choose;
      return choose();
    case Phase::pressed:
      note(episodes::FailureCode::collision);
      memory_.held = false;
      memory_.missed[memory_.plan.product].push_back(
          memory_.plan.grasp.grasp.product_from_tool.position);
      return back_off();
    case Phase::out:
      return back_off();
    case Phase::away:
    case Phase::dropped:
      memory_.phase = Phase::away;
      return drop();
  }
  return {};
}

Result<void> AisleOracle::decide() {
  if (memory_.executor.take_stop()) return recover();
  if (memory_.executor.take_held_up()) return make_way();
  switch (memory_.phase) {
    case Phase::choose:
      return choose();
    case Phase::at_door:
      return open_door();
    case Phase::opening:
      return check_opened();
    case Phase::at_leaf:
      return shut_door();
    case Phase::shutting:
      return check_shut();
    case Phase::arrived:
      return reach();
    case Phase::pressed:
      return pull_out();
    case Phase::out:
      return back_off();
    case Phase::away:
      return drop();
    case Phase::dropped:
      return check();
  }
  return {};
}

// ---- Taking it ----

// On the way to the grasp: the fingers apart, the cup off.
agent::ToolCommand AisleOracle::opened() const {
  return {tool_.kind == robots::ToolKind::suction ? agent::cup_off_m
                                                  : memory_.plan.grasp.grasp.opening_m};
}
agent::ToolCommand AisleOracle::let_go() const {
  if (tool_.kind == robots::ToolKind::suction) return {agent::cup_off_m};
  const double held = now_.openings_m[static_cast<std::size_t>(memory_.plan.tool)];
  return {held + let_go_wider_m, memory_.force_n};
}

double AisleOracle::lift_height() const {
  return memory_.plan.state[static_cast<std::size_t>(robot_.find_dof("lift"))];
}

bool AisleOracle::holds_it() const {
  return world_->watch().is_held(memory_.plan.product);
}

Result<void> AisleOracle::pull_out() {
  memory_.phase = Phase::out;
  memory_.held = holds_it();
  if (memory_.held) {
    memory_.executor.pull_out();
    return {};
  }
  const Pose from_shelf =
      inverse(scene::world_from_product(world_->store().scene.products[memory_.plan.product])) *
      world_->world().product_pose(memory_.plan.product);
  say(fmt::format("took hold of nothing; it was moved by {:.3f} m, its upright is {:.2f}",
                  length(from_shelf.position),
                  rotate(from_shelf.rotation, {0, 0, 1}).z));
  note(episodes::FailureCode::missed);
  memory_.missed[memory_.plan.product].push_back(
      memory_.plan.grasp.grasp.product_from_tool.position);
  return memory_.executor.go_back();
}

Result<void> AisleOracle::back_off() {
  const double room = world_->store().room_behind_m(world_->world_from_base(), ways());
  MARKETGEN_CHECK(memory_.executor.back_off(room));
  if (!holds_it() && memory_.held) {
    say("lost it while it pulled it out");
    note(episodes::FailureCode::slipped);
  }
  memory_.drop_lift = 0;
  memory_.phase = Phase::away;
  if (!holds_it()) return {};
  return memory_.executor.raise(skills::drop_lifts_m[memory_.drop_lift], agent::Subtask::place);
}

// ---- Into the basket ----

std::vector<double> AisleOracle::state_now() const {
  std::vector<double> q = world_->sensed_state();
  for (std::size_t dof = 0; dof < q.size(); ++dof) {
    const robots::Joint& joint = robot_.joint_of_dof(dof);
    q[dof] = std::clamp(q[dof], joint.lower, joint.upper);
  }
  for (const int dof : robot_.find_group("base")->dofs)
    q[static_cast<std::size_t>(dof)] = 0;
  return robots::with_followers(robot_, std::move(q));
}

Result<motion::Obstacles> AisleOracle::around() const {
  const Vec3 middle = world_->world_from_base().position + Vec3{0, 0, 0.9};
  motion::Obstacles obstacles = collect::fixture_obstacles(goods_now(), middle, way_reach_m);
  std::vector<std::uint32_t> carried = world_->in_basket();
  carried.push_back(memory_.plan.product);
  MARKETGEN_CHECK(
      collect::add_product_obstacles(goods_now(), middle, way_reach_m, carried, obstacles));
  return obstacles;
}

Result<std::vector<skills::CarriedItem>> AisleOracle::inside() const {
  std::vector<skills::CarriedItem> items;
  const Pose base_from_world = inverse(world_->world_from_base());
  for (const std::uint32_t row : world_->in_basket()) {
    if (row == memory_.plan.product && holds_it()) continue;
    const scene::Scene& scene = world_->store().scene;
    MARKETGEN_TRY(const assets::ProductBody body,
                  skills::make_store_body(scene.catalog[scene.products[row].sku]));
    items.push_back({body.pieces, base_from_world * world_->world().product_pose(row)});
  }
  return items;
}

Pose AisleOracle::base_from_tip() const {
  const int frame = robot_.tools[static_cast<std::size_t>(memory_.plan.tool)].frame;
  return robots::frame_pose(robot_, state_now(), frame);
}

Result<skills::StowQuestion> AisleOracle::stow_question(const std::string& group) const {
  const robots::JointGroup& arm = *robot_.find_group(group);
  skills::StowQuestion question{.state = state_now(),
                                .world_from_base = world_->world_from_base(),
                                .group = group,
                                .around = {},
                                .stow = robots::values_of(arm, world_->store().driving)};
  MARKETGEN_TRY(question.around, around());
  MARKETGEN_TRY(question.inside, inside());
  return question;
}

Result<void> AisleOracle::drop() {
  if (!holds_it()) return go_home();
  const scene::Scene& scene = world_->store().scene;
  MARKETGEN_TRY(const assets::ProductBody body,
                skills::make_store_body(scene.catalog[scene.products[memory_.plan.product].sku]));
  skills::DropQuestion question;
  MARKETGEN_TRY(static_cast<skills::StowQuestion&>(question), stow_question(memory_.plan.group));
  question.tool = memory_.plan.tool;
  if (tool_.kind == robots::ToolKind::suction) question.acceleration = skills::cup_acceleration;
  question.held = &body;
  question.tip_from_product = inverse(world_->world_from_base() * base_from_tip()) *
                              world_->world().product_pose(memory_.plan.product);
  const Seed seed = next_seed("drop");
  auto plan = skills::plan_drop(robot_, world_->store().basket, question, seed);
  if (!plan.ok()) {
    say("no way into the basket: " + to_string(plan.error()));
    return try_other_lift();
  }
  memory_.executor.let_down(std::move(*plan), let_go());
  memory_.phase = Phase::dropped;
  return {};
}

Result<void> AisleOracle::try_other_lift() {
  note(episodes::FailureCode::no_path);
  if (++memory_.drop_lift >= skills::drop_lifts_m.size()) {
    memory_.done = true;  // with the item in its hand: it cannot go on
    return {};
  }
  return memory_.executor.raise(skills::drop_lifts_m[memory_.drop_lift], agent::Subtask::place);
}

// The arm to its stowed posture, empty.
Result<void> AisleOracle::go_home() {
  memory_.phase = Phase::choose;
  MARKETGEN_TRY(const skills::StowQuestion question, stow_question(memory_.plan.group));
  const Seed seed = next_seed("home");
  auto way = skills::plan_stow(robot_, world_->store().basket, question, seed);
  if (!way.ok()) {
    note(episodes::FailureCode::no_path);
    memory_.done = true;
    return {};
  }
  memory_.executor.stow(std::move(*way));
  return {};
}

Result<void> AisleOracle::check() {
  memory_.phase = Phase::choose;
  const std::vector<std::uint32_t> inside = world_->in_basket();
  const bool there = std::ranges::count(inside, memory_.plan.product) > 0;
  say(there ? "it is in the basket" : "lost it on its way into the basket");
  if (there)
    memory_.tries[sku_of(memory_.plan.product)] = 0;
  else
    note(episodes::FailureCode::dropped);
  return {};
}

Result<std::unique_ptr<agent::Policy>> make_aisle_oracle(const episodes::AisleWorld& world,
                                                         const std::filesystem::path& data,
                                                         Seed seed,
                                                         const OracleSearch& search) {
  const std::string& row = world.store().station.tools().picks_with;
  MARKETGEN_TRY(robots::GraspTool tool, robots::load_grasp_tool(data, row));
  return std::unique_ptr<agent::Policy>(
      std::make_unique<AisleOracle>(world, std::move(tool), seed, search));
}

}  // namespace marketgen::oracle
