// The oracle at doors: it opens the one before what it fetches, takes all that is missing from
// behind it, and shuts it.
#include <algorithm>

#include <fmt/format.h>

#include "oracle/aisle_oracle.h"
#include "skills/plan_failure.h"

namespace marketgen::oracle {
namespace {

constexpr double opening_s = 75, shutting_s = 45;  // with the ways to it, as a rule less
constexpr double swings_s = 3, latches_s = 6;      // until it rests when it was let go
constexpr double held_open_rad =
    0.07;  // less than from where on it stays: its friction, 3.6 degrees
constexpr int max_door_tries = 2;
constexpr int max_door_arrivals = 6;  // from where it came to stand no arm may follow the leaf, and
                                      // from a few millimetres beside it may

}  // namespace

const navigation::VisibilityGraph& AisleOracle::ways() const {
  return memory_.open ? *memory_.open->ways : world_->store().ways;
}

// None in stores whose goals stand before no door, and for the door that is open.
std::optional<std::uint32_t> AisleOracle::shut_door_before(std::uint32_t product) const {
  if (world_->store().doors == episodes::Doors::none || is_behind_open_door(product))
    return std::nullopt;
  return collect::door_before(world_->store().scene, product);
}

bool AisleOracle::is_behind_open_door(std::uint32_t product) const {
  return memory_.open &&
         collect::door_before(world_->store().scene, product) == memory_.open->joint;
}

// That what it fetches next takes beside.
double AisleOracle::time_for_doors_s() const {
  if (world_->store().doors == episodes::Doors::none) return 0;
  return memory_.open ? shutting_s : opening_s + shutting_s;
}

Result<AisleOracle::OpenedDoor> AisleOracle::opened_at(std::uint32_t joint,
                                                       double position_rad) const {
  const episodes::AisleStore& store = world_->store();
  MARKETGEN_TRY(skills::HingedDoor door, collect::known_door(store.scene, joint));
  MARKETGEN_TRY(auto ways, store.ways_past(door, position_rad));
  return OpenedDoor{joint,
                    std::move(door),
                    position_rad,
                    std::make_shared<const navigation::VisibilityGraph>(std::move(ways))};
}

// For a place that it drives to, the door before the product open.
Result<collect::CollectOptions> AisleOracle::options_from_afar(std::uint32_t product) {
  goods_ = goods_now();
  MARKETGEN_TRY(collect::CollectOptions options, collect_options(product));
  std::optional<OpenedDoor> open = memory_.open;
  if (const auto shut = shut_door_before(product)) {
    const double hold = double(world_->store().scene.joints[*shut].hold_open);
    MARKETGEN_TRY(open, opened_at(*shut, hold));
    std::vector<double> joints = goods_.joints();
    joints[*shut] = hold;
    goods_.set_joints(std::move(joints));
  }
  if (open)
    options.may_stand = [&store = world_->store(), door = *open](const Pose& world_from_base,
                                                                 const std::vector<double>& state) {
      return store.check_standing_past(
          door.door, door.position_rad, *door.ways, world_from_base, state);
    };
  return options;
}

// To where it stands for what `plan_way` plans.
Result<void> AisleOracle::drive_to_door(std::uint32_t joint, DoorPlanning plan_way, Seed seed) {
  MARKETGEN_TRY(const skills::DoorQuestion question,
                world_->store().door_question(goods_now(), joint));
  MARKETGEN_TRY(const skills::DoorPlan plan, plan_way(robot_, question, seed));
  MARKETGEN_TRY(auto way, way_of(plan.world_from_base));
  memory_.executor.drive(std::move(way));
  return {};
}

// ---- Opening ----

bool AisleOracle::go_to_door(std::uint32_t joint, std::uint32_t product) {
  if (refused_doors_.contains(joint)) return false;
  const auto begun = drive_to_door(joint, skills::plan_open_door, next_seed("door"));
  if (!begun.ok()) {
    note_plan(product, begun.error());
    refused_doors_.insert(joint);
    return false;
  }
  memory_.plan.product = product;
  memory_.door = joint;
  memory_.phase = Phase::at_door;
  return true;
}

// Planned anew from where the base came to stand.
Result<void> AisleOracle::open_door() {
  const Seed seed = next_seed("open");
  MARKETGEN_TRY(skills::DoorQuestion question,
                world_->store().door_question(goods_now(), memory_.door));
  question.world_from_base = world_->world_from_base();
  const auto plan = skills::plan_open_door(robot_, question, seed);
  if (!plan.ok()) {
    note_plan(memory_.plan.product, plan.error());
    memory_.phase = Phase::choose;
    if (++memory_.door_arrivals[memory_.door] >= max_door_arrivals)
      refused_doors_.insert(memory_.door);
    return {};
  }
  say("opens " + question.where);
  memory_.phase = Phase::opening;
  return memory_.executor.move_door(*plan, swings_s);
}

Result<void> AisleOracle::check_opened() {
  const double now = world_->world().joint_position(memory_.door);
  const double hold = double(world_->store().scene.joints[memory_.door].hold_open);
  say(fmt::format("the door is open by {:.3f} of {:.3f} rad", now, hold));
  memory_.phase = Phase::choose;
  if (now < hold - held_open_rad) {
    note(episodes::FailureCode::missed);
    give_up_door();
    return {};
  }
  memory_.door_tries.erase(memory_.door);
  memory_.door_arrivals.erase(memory_.door);
  MARKETGEN_TRY(memory_.open, opened_at(memory_.door, now));
  return {};
}

// It is tried again, unless it was tried as often as it may be.
void AisleOracle::give_up_door() {
  memory_.phase = Phase::choose;
  if (++memory_.door_tries[memory_.door] >= max_door_tries) refused_doors_.insert(memory_.door);
}

// ---- Shutting ----

Result<void> AisleOracle::go_to_leaf() {
  const auto begun = drive_to_door(memory_.open->joint, skills::plan_shut_door, next_seed("leaf"));
  if (!begun.ok()) {
    say("no way to shut it: " + to_string(begun.error()));
    note(episodes::FailureCode::no_path);
    memory_.done = true;
    return {};
  }
  memory_.phase = Phase::at_leaf;
  return {};
}

Result<void> AisleOracle::shut_door() {
  const Seed seed = next_seed("shut");
  MARKETGEN_TRY(skills::DoorQuestion question,
                world_->store().door_question(goods_now(), memory_.open->joint));
  question.world_from_base = world_->world_from_base();
  const auto plan = skills::plan_shut_door(robot_, question, seed);
  if (!plan.ok()) {
    say("no way to shut it from here: " + to_string(plan.error()));
    memory_.phase = Phase::choose;
    memory_.done = ++memory_.door_arrivals[memory_.open->joint] >= max_door_arrivals;
    return {};
  }
  say("shuts " + question.where);
  memory_.phase = Phase::shutting;
  return memory_.executor.move_door(*plan, latches_s);
}

Result<void> AisleOracle::check_shut() {
  const std::uint32_t joint = memory_.open->joint;
  const double now = world_->world().joint_position(joint);
  say(fmt::format("the door is open by {:.3f} rad", now));
  memory_.phase = Phase::choose;
  if (now > episodes::max_shut_rad) {
    memory_.open->position_rad = now;
    memory_.done = ++memory_.door_tries[joint] >= max_door_tries;
    return {};
  }
  memory_.open.reset();
  memory_.door_tries.erase(joint);
  memory_.door_arrivals.erase(joint);
  return {};
}

// After a stop at a door: both arms home, one after the other, past the leaf where it is.
Result<void> AisleOracle::fold_arms() {
  memory_.phase = Phase::choose;
  note(episodes::FailureCode::collision);
  const std::uint32_t joint = memory_.open ? memory_.open->joint : memory_.door;
  if (++memory_.door_tries[joint] >= max_door_tries) {
    refused_doors_.insert(joint);
    memory_.done = memory_.open.has_value();
  }
  std::vector<double> state = state_now();
  MARKETGEN_TRY(const std::vector<skills::Hand> hands, skills::hands_with(robot_, tool_.id));
  for (const skills::Hand& hand : hands) {
    MARKETGEN_TRY(skills::StowQuestion question, stow_question(hand.arm->name));
    question.state = state;
    const Seed seed = next_seed("fold");
    auto way = skills::plan_stow(robot_, world_->store().basket, question, seed);
    if (!way.ok()) {
      say("no way home: " + to_string(way.error()));
      memory_.done = true;
      return {};
    }
    state = skills::with_arm(*hand.arm, std::move(state), question.stow);
    memory_.executor.stow(hand.arm->name, std::move(*way));
  }
  return {};
}

}  // namespace marketgen::oracle
