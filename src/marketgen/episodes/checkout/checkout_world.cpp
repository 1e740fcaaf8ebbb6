#include "episodes/checkout/checkout_world.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/hash.h"
#include "episodes/checkout/checkout_goals.h"
#include "episodes/control_step.h"
#include "physics/goods/contact_shape.h"

namespace marketgen::episodes {
namespace {

constexpr char world_where[] = "checkout";
constexpr double displaced_m = 0.02;
constexpr double hold_n = 20;

}  // namespace

Result<CheckoutWorld> CheckoutWorld::create(const std::filesystem::path& data,
                                            std::vector<catalog::FrictionRow> frictions,
                                            const std::string& station) {
  CheckoutWorld world(std::move(frictions));
  MARKETGEN_TRY(world.station_, load_checkout_station(data, station));
  MARKETGEN_TRY(robots::Robot robot, load_station_robot(data, world.station_));
  world.robot_ = std::make_unique<robots::Robot>(std::move(robot));
  if (world.robot_->find_group("arm") == nullptr || world.robot_->tools.size() != 1)
    return Error{"robot.unknown", world.station_.robot, "expected an arm with a gripper"};
  world.arm_ = commanded_dofs(*world.robot_);
  return world;
}

Result<void> CheckoutWorld::reset(const EpisodeSpec& spec,
                                  const std::vector<catalog::Product>& products) {
  if (spec.robot != station_.robot)
    return Error{"robot.unknown",
                 spec.id,
                 fmt::format("the station has \"{}\", not \"{}\"", station_.robot, spec.robot)};
  if (const std::string asked = spec.station.value_or(checkout_station); asked != station_.id)
    return Error{"robot.unknown",
                 spec.id,
                 fmt::format("it is of the station \"{}\", this is \"{}\"", asked, station_.id)};
  item_goods_.clear();
  for (const EpisodeItem& item : spec.items) {
    const auto row = std::ranges::find(products, item.sku, &catalog::Product::sku);
    if (row == products.end())
      return Error{"catalog.unknown_sku", spec.id, "there is no product \"" + item.sku + "\""};
    MARKETGEN_TRY(SharedGoods goods, checkout_goods(*row, frictions_));
    item_goods_.push_back(std::move(goods));
  }
  spec_ = spec;
  const std::vector<double> ready = ready_state(station_, *robot_);
  MARKETGEN_TRY(model_, checkout_model(station_, *robot_, ready, spec.items, item_goods_));
  MARKETGEN_TRY(data_, physics::make_data(*model_.model, world_where));
  MARKETGEN_CHECK(
      physics::guarded(world_where, [&] { mj_forward(model_.model.get(), data_.get()); }));
  MARKETGEN_TRY(controller_, physics::RobotController::start(*model_.model, *data_, *robot_));
  watch_ = CheckoutWatch(model_, *data_);
  steps_ = 0;
  done_ = false;
  return {};
}

double CheckoutWorld::time_s() const {
  return data_->time;
}

std::vector<double> CheckoutWorld::robot_state() const {
  return controller_.actor().position(*data_);
}

agent::Observation CheckoutWorld::observe() const {
  const physics::RobotActor& actor = controller_.actor();
  const std::vector<double> q = actor.position(*data_), v = actor.velocity(*data_);
  agent::Observation seen;
  seen.time_s = data_->time;
  for (const int dof : arm_) {
    seen.position.push_back(q[static_cast<std::size_t>(dof)]);
    seen.velocity.push_back(v[static_cast<std::size_t>(dof)]);
  }
  seen.openings_m = tool_openings_m(*robot_, q);
  seen.sealed.assign(robot_->tools.size(), 0);
  seen.stopped = controller_.stopped(data_->time);
  return seen;
}

Result<void> CheckoutWorld::move(const agent::Action& action) {
  const ControlStep step(controller_, *robot_, arm_, action);
  const mjModel& model = *model_.model;
  for (int i = 0; i < ControlStep::count(); ++i) {
    MARKETGEN_CHECK(controller_.command(model, *data_, step.at(i)));
    MARKETGEN_CHECK(physics::guarded(world_where, [&] { mj_step(&model, data_.get()); }));
    controller_.feel(model, *data_);
    watch_.look(model_, *data_);
    if (physics_watch_) physics_watch_(model, *data_);
  }
  return {};
}

Result<agent::Observation> CheckoutWorld::step(const agent::Action& action) {
  MARKETGEN_CHECK(check_action(action, *robot_, arm_.size(), done_));
  if (action.stop) {
    done_ = true;
    return observe();
  }
  MARKETGEN_CHECK(move(action));
  ++steps_;
  done_ = data_->time >= spec_.limit_s - physics::time_step_s / 2;
  return observe();
}

ItemState CheckoutWorld::item_state(std::size_t item) const {
  const CheckoutGoods& goods = *item_goods_[item];
  const CheckoutWatch::Item& seen = watch_.items()[item];
  return {goods.product.sku,
          item_pose(item),
          to_double(goods.body.center_of_mass),
          goods.volume,
          seen.touched,
          seen.rested_s,
          seen.impact_m_s};
}

std::vector<ItemState> CheckoutWorld::item_states() const {
  std::vector<ItemState> states;
  for (std::size_t i = 0; i < item_goods_.size(); ++i)
    states.push_back(item_state(i));
  return states;
}

HoldsPoint CheckoutWorld::region() const {
  return over_area(station_.unloading.area(), {station_.container(), basket_pose()});
}

bool CheckoutWorld::in_place(std::size_t item) const {
  const CheckoutWatch::Item& seen = watch_.items()[item];
  if (seen.touched || seen.rested_s < min_rest_s) return false;  // before its volume is looked at
  return is_in_place(region(), item_state(item));
}

Result<bool> CheckoutWorld::goals_met() {
  int asked = 0, there = 0;
  for (const EpisodeGoal& goal : spec_.goals) {
    asked += goal.count;
    for (std::size_t i = 0; i < item_goods_.size(); ++i)
      there += spec_.items[i].sku == goal.sku && in_place(i) ? 1 : 0;
  }
  if (there < asked) return false;  // most of the time: judging costs more
  const EpisodeOutcome outcome =
      judge_checkout(region(), spec_.goals, item_states(), watch_.greatest_tilt_deg());
  return outcome.hits >= outcome.asked;
}

SideEffects CheckoutWorld::side_effects(const EpisodeOutcome& outcome) const {
  SideEffects effects = watch_.effects();
  effects.protective_stops = controller_.stops();
  effects.wrong_items = outcome.wrong;
  const HoldsPoint belongs = where_goods_belong(station_, basket_pose());
  for (std::size_t i = 0; i < item_goods_.size(); ++i) {
    if (!is_inside(belongs, item_state(i))) ++effects.strayed;
    if (std::ranges::count(spec_.goals, spec_.items[i].sku, &EpisodeGoal::sku) > 0) continue;
    const Pose now = inverse(basket_pose()) * item_pose(i);
    if (length(now.position - watch_.items()[i].first.position) > displaced_m) ++effects.displaced;
  }
  return effects;
}

Result<EpisodeResult> CheckoutWorld::finish() {
  done_ = true;
  const agent::Action hold{told(), {{observe().openings_m.front(), hold_n}}};
  for (double waited = 0; waited < judged_after_s - physics::time_step_s; waited += control_step_s)
    MARKETGEN_CHECK(move(hold));
  const EpisodeOutcome outcome =
      judge_checkout(region(), spec_.goals, item_states(), watch_.greatest_tilt_deg());
  EpisodeResult result;
  result.episode = spec_.id;
  result.store = spec_.store;
  result.side_effects = side_effects(outcome);
  add_outcome(outcome, result);
  result.steps = steps_;
  result.simulated_s = data_->time;
  result.state_hash = state_hash();
  return result;
}

std::string CheckoutWorld::save() const {
  ByteWriter writer;
  writer(physics::moment_of(*data_), controller_, watch_, steps_, done_);
  return writer.take();
}

Result<void> CheckoutWorld::restore(std::string_view moment) {
  physics::MujocoMoment physics;
  physics::RobotController controller = controller_;
  CheckoutWatch watch;
  int steps = 0;
  bool done = false;
  ByteReader reader(moment);
  reader(physics, controller, watch, steps, done);
  if (!reader.ok() || physics.buffer.size() != static_cast<std::size_t>(data_->nbuffer) ||
      controller.setpoints().size() != robot_->dof_count() ||
      watch.items().size() != item_goods_.size())
    return Error{"physics.bad_command", world_where, "the moment is of another episode"};
  physics::restore_moment(*data_, physics);
  controller_ = std::move(controller);
  watch_ = std::move(watch);
  steps_ = steps;
  done_ = done;
  return {};
}

std::string CheckoutWorld::state_hash() const {
  const mjModel& m = *model_.model;
  std::vector<double> physics(static_cast<std::size_t>(mj_stateSize(&m, mjSTATE_INTEGRATION)));
  mj_getState(&m, data_.get(), physics.data(), mjSTATE_INTEGRATION);
  Hasher hash;
  hash.add_bytes(std::as_bytes(std::span(physics)));
  hash.add_bytes(std::as_bytes(std::span(data_->tree_asleep, static_cast<std::size_t>(m.ntree))));
  return hash.hex();
}

Pose CheckoutWorld::item_pose(std::size_t item) const {
  return body_pose(*data_, model_.items[item]);
}

Vec3 CheckoutWorld::item_velocity(std::size_t item) const {
  mjtNum velocity[6];
  mj_objectVelocity(model_.model.get(), data_.get(), mjOBJ_BODY, model_.items[item], velocity, 0);
  return {velocity[3], velocity[4], velocity[5]};
}

Pose CheckoutWorld::basket_pose() const {
  return body_pose(*data_, model_.basket);
}

double CheckoutWorld::deepest_overlap_m() const {
  double deepest = 0;
  for (int c = 0; c < data_->ncon; ++c)
    deepest = std::max(deepest, -data_->contact[c].dist);
  return deepest;
}

}  // namespace marketgen::episodes
