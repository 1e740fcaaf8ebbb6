#include "oracle/oracle_checkout.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/progress.h"
#include "oracle/checkout_oracle.h"
#include "oracle/oracle_places.h"
#include "skills/basket_moves.h"

namespace marketgen::oracle {
namespace {

constexpr std::size_t max_places = 8;
constexpr double settle_s = 0.25, open_s = 0.35;
constexpr double lowest_rim_m = 0.03;  // over which it is lifted off the counter

}  // namespace

CheckoutOracle::CheckoutOracle(const episodes::CheckoutWorld& world,
                               robots::GraspTool tool,
                               skills::ArmExecutor arm,
                               Seed seed,
                               const OracleSearch& search)
    : world_(&world),
      tool_(std::move(tool)),
      seed_(seed),
      search_(search),
      memory_{.arm = std::move(arm)} {}

CheckoutOracle::CheckoutOracle(const CheckoutOracle& other)
    : world_(other.twin_.get()),
      is_rehearsal_(true),
      tool_(other.tool_),
      seed_(other.seed_),
      search_(other.search_),
      task_(other.task_),
      scene_(std::make_unique<OracleScene>(*other.twin_, tool_)),
      now_(other.now_),
      home_(other.home_),
      memory_(other.memory_) {}

Result<void> CheckoutOracle::begin(const agent::Task& task, const agent::Observation& first) {
  task_ = task;
  scene_ = std::make_unique<OracleScene>(*world_, tool_);
  if (search_.rehearses) {
    MARKETGEN_TRY(twin_, world_->twin());
  }
  memory_ = {.arm = std::move(memory_.arm)};
  lone_.clear();
  memory_.arm.start(first);
  home_ = memory_.arm.tip();
  say("begins " + world_->spec().id);
  return {};
}

Result<agent::Action> CheckoutOracle::act(const agent::Observation& now) {
  now_ = now;
  memory_.arm.hold(now.openings_m.front());
  if (memory_.arm.idle()) MARKETGEN_CHECK(decide());
  agent::Action action = memory_.arm.next(now);
  action.stop = memory_.done;
  return action;
}

// The arm or what it holds was pressed on, and has been moved back a second of its way: what was
// planned is given up, and goes on from here by another plan.
Result<void> CheckoutOracle::recover() {
  say("was stopped");
  note(episodes::FailureCode::collision);
  if (memory_.arm.presses() && holds_it()) {
    memory_.phase = Phase::lifted;
    return scene_->in_basket(memory_.item) ? lift() : put_down();
  }
  if (memory_.phase == Phase::closed) memory_.tried.fail(memory_.item, memory_.product_from_tip);
  memory_.phase = Phase::released;
  return choose();
}

Result<void> CheckoutOracle::decide() {
  if (memory_.arm.take_stop()) return recover();
  switch (memory_.phase) {
    case Phase::choose:
    case Phase::released:
      return choose();
    case Phase::closed:
      return lift();
    case Phase::lifted:
      return put_down();
    case Phase::over_place:
      return lower();
  }
  return {};
}

void CheckoutOracle::say(const std::string& what) const {
  if (is_rehearsal_) return;
  log_debug(fmt::format("oracle {:.2f} s: {}", now_.time_s, what));
}
// Of a motion without which it goes on.
void CheckoutOracle::say_failed(std::string_view motion, const Result<void>& planned) const {
  if (!planned.ok()) say(fmt::format("cannot {}: {}", motion, to_string(planned.error())));
}
std::string CheckoutOracle::called(std::size_t item) const {
  const episodes::EpisodeGoods& goods = world_->goods(item);
  return fmt::format("{}{} {} {} ({:.2f} kg)",
                     scene_->is_target(item) ? "target " : "other ",
                     item,
                     goods.product.archetype,
                     fmt::join(goods.product.size_mm, "x"),
                     goods.product.mass_kg);
}

Result<void> CheckoutOracle::lift() {
  if (!holds_it()) return let_go_for_good(episodes::FailureCode::missed);
  const Pose pose = world_->item_pose(memory_.item);
  const Vec3 half = scene_->half_extents_at(memory_.item, pose.rotation);
  const double lowest = scene_->box_middle(memory_.item, pose).z - half.z;
  const skills::BasketSurroundings basket{
      scene_->surroundings({memory_.item}),
      skills::counter_alone(scene_->place()),
      scene_->in_basket(memory_.item) ? scene_->rim_z_m() : lowest_rim_m};
  const Vec3 middle = scene_->place().base_from_basket.position;
  if (!skills::lift_out(memory_.arm, basket, lowest, middle, memory_.force_n).ok())
    return let_go_for_good(episodes::FailureCode::no_path);
  memory_.arm.wait(settle_s, 0, memory_.force_n);
  memory_.phase = Phase::lifted;
  return {};
}

// And never takes it so again.
Result<void> CheckoutOracle::let_go_for_good(episodes::FailureCode why) {
  memory_.tried.fail(memory_.item, memory_.product_from_tip);
  return let_go(why);
}

// Opens where it is, and goes back the way it came.
Result<void> CheckoutOracle::let_go(episodes::FailureCode why) {
  note(why);
  say(fmt::format("lets go of {}: {}", called(memory_.item), name_of(why)));
  const double opening = skills::let_go_m(tool_, now_.openings_m.front());
  memory_.arm.set_subtask(agent::Subtask::retreat);
  memory_.arm.wait(open_s, opening, memory_.force_n);
  back_off(opening);
  memory_.phase = Phase::released;
  return {};
}

bool CheckoutOracle::back_off(double opening_m) {
  const skills::HandAt hand =
      scene_->in_basket(memory_.item) ? skills::HandAt::basket : skills::HandAt::counter;
  const skills::BasketSurroundings basket{
      scene_->surroundings({}, hand), skills::counter_alone(scene_->place()), scene_->rim_z_m()};
  const auto raised = skills::draw_back(memory_.arm, basket, opening_m, memory_.force_n);
  say_failed("raise the hand", raised);
  return raised.ok();
}

// ---- Putting it down ----

// Where it belongs, or else where it can be taken anew.
Result<void> CheckoutOracle::put_down() {
  if (!holds_it()) return let_go_for_good(episodes::FailureCode::slipped);
  const Pose tip_from_item = inverse(memory_.arm.tip()) * world_->item_pose(memory_.item);
  const double opening = skills::let_go_m(tool_, now_.openings_m.front());
  note(episodes::FailureCode::no_ik);
  memory_.places.clear();
  memory_.in_area = scene_->is_target(memory_.item);
  for (const bool in_area : {scene_->is_target(memory_.item), false}) {
    if (!memory_.places.empty()) break;
    const skills::HeldPack held = held_pack(*scene_, memory_.item, tip_from_item, opening);
    memory_.places = skills::free_places(
        tool_, memory_.arm, held, place_question(*scene_, memory_.item, in_area), max_places);
    memory_.in_area = in_area;
  }
  memory_.next_place = 0;
  return go_over_place();
}

Result<void> CheckoutOracle::go_over_place() {
  memory_.arm.set_subtask(agent::Subtask::place);
  const Pose tip_from_item = inverse(memory_.arm.tip()) * world_->item_pose(memory_.item);
  const motion::AttachedObject held =
      skills::held_spheres(world_->robot(), world_->goods(memory_.item).body, tip_from_item);
  const skills::Surroundings around = scene_->surroundings({memory_.item}, skills::HandAt::counter);
  for (; memory_.next_place < 2 * memory_.places.size(); ++memory_.next_place) {
    const skills::FreePlace& place = memory_.places[memory_.next_place % memory_.places.size()];
    skills::ReachRequest request{place.base_from_tip, place.approach, 0, memory_.force_n};
    request.stops_before = true;
    if (memory_.next_place < memory_.places.size()) request.attached = {held};
    if (!memory_.arm.reach(around, request, next_seed("place")).ok()) {
      note(episodes::FailureCode::no_path);
      continue;
    }
    memory_.arm.wait(settle_s, 0, memory_.force_n);
    memory_.phase = Phase::over_place;
    return {};
  }
  return put_back();
}

// It may have turned in the hand on its way: the hand goes to where the item ends as planned.
Result<void> CheckoutOracle::lower() {
  if (!holds_it()) return let_go_for_good(episodes::FailureCode::slipped);
  memory_.arm.set_subtask(agent::Subtask::place);
  const skills::FreePlace& place = memory_.places[memory_.next_place++ % memory_.places.size()];
  const Pose item_from_tip = inverse(world_->item_pose(memory_.item)) * memory_.arm.tip();
  const skills::Surroundings around = scene_->surroundings({memory_.item}, skills::HandAt::counter);
  for (const Pose& tip : {place.base_from_product * item_from_tip, place.base_from_tip}) {
    if (!memory_.arm.straight(around, tip, 0, memory_.force_n).ok()) continue;
    say(fmt::format("puts {} down, place {}, in the area {}",
                    called(memory_.item),
                    memory_.next_place,
                    memory_.in_area));
    const double opening = skills::let_go_m(tool_, now_.openings_m.front());
    memory_.arm.wait(settle_s, 0, memory_.force_n);
    memory_.arm.wait(open_s, opening, memory_.force_n);
    memory_.placed = back_off(opening);  // a hand that stays there meets what stands beside
    if (memory_.in_area == scene_->is_target(memory_.item)) memory_.tried.put_down(memory_.item);
    memory_.phase = Phase::released;
    return {};
  }
  return go_over_place();
}

// Down again to where it was, as far as that goes.
Result<void> CheckoutOracle::put_back() {
  memory_.arm.set_subtask(agent::Subtask::place);
  say_failed("let it down to where it was",
             memory_.arm.let_down(scene_->surroundings({memory_.item}), memory_.force_n));
  return let_go_for_good(memory_.failure);
}

Result<std::unique_ptr<agent::Policy>> make_checkout_oracle(const episodes::CheckoutWorld& world,
                                                            const std::filesystem::path& data,
                                                            Seed seed,
                                                            const OracleSearch& search) {
  MARKETGEN_TRY(robots::GraspTool tool, load_checkout_tool(world, data));
  MARKETGEN_TRY(skills::ArmExecutor arm, make_checkout_arm(world, tool));
  return std::unique_ptr<agent::Policy>(
      std::make_unique<CheckoutOracle>(world, std::move(tool), std::move(arm), seed, search));
}

}  // namespace marketgen::oracle
