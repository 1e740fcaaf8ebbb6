#include "episodes/checkout/checkout_world.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include "episodes/checkout/checkout_goals.h"
#include "physics/goods/spec_geoms.h"

namespace marketgen::episodes {
namespace {

constexpr double displaced_m = 0.02;
constexpr double hold_n = 20;
// Neighbours of the lane that can be awake at once. The arm does not reach them by itself: only
// what it throws there wakes any.
constexpr int pool_at_lane = 32, soft_pool_at_lane = 4;
constexpr char basket_name[] = "basket";
constexpr std::string_view basket_plastic_material = "pet";  // moulded, as robots carry it

std::string basket_geom(std::size_t box) {
  return fmt::format("{}/{}", basket_name, box);
}

// A free body, as heavy as its row says.
void add_loose_basket(mjSpec& spec, const CheckoutStation& station, const Pose& store_from_basket) {
  mjsBody* body = mjs_addBody(mjs_findBody(&spec, "world"), nullptr);
  mjs_setName(body->element, basket_name);
  physics::set_pose(body->pos, body->quat, store_from_basket);
  mjs_setName(mjs_addFreeJoint(body)->element, basket_name);
  const std::vector<physics::ContainerBox> boxes = station.basket_boxes();
  double volume = 0;
  for (const physics::ContainerBox& box : boxes)
    volume += 8 * box.half_size.x * box.half_size.y * box.half_size.z;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vec3& h = boxes[i].half_size;
    mjsGeom* geom =
        physics::add_shape(body, {assets::CollisionShape::box, boxes[i].container_from_box, h});
    geom->mass = station.basket.mass_kg * 8 * h.x * h.y * h.z / volume;
    mjs_setName(geom->element, basket_geom(i).c_str());
  }
}

std::map<std::string, std::string> counter_materials(const CheckoutStation& station,
                                                     const robots::Robot& robot,
                                                     const physics::RobotActorOptions& place) {
  std::map<std::string, std::string> materials = physics::robot_materials(robot, place);
  for (std::size_t i = 0; i < station.basket_boxes().size(); ++i)
    materials.emplace(basket_geom(i), std::string(basket_plastic_material));
  return materials;
}

std::string spoken_place(const std::string& lane) {
  return lane.empty() ? "in a room of its own" : "at the lane \"" + lane + "\"";
}

}  // namespace

Result<CheckoutWorld> CheckoutWorld::create(const std::filesystem::path& data,
                                            std::vector<catalog::FrictionRow> frictions,
                                            const std::string& station,
                                            const std::string& tools) {
  CheckoutWorld world(std::move(frictions));
  MARKETGEN_TRY(world.station_, load_checkout_station(data, station, tools));
  MARKETGEN_TRY(robots::Robot robot, load_station_robot(data, world.station_));
  world.robot_ = std::make_unique<robots::Robot>(std::move(robot));
  if (world.robot_->find_group("arm") == nullptr || world.robot_->tools.size() != 1)
    return Error{"robot.unknown", world.station_.robot, "expected an arm with one tool"};
  world.arm_ = commanded_dofs(*world.robot_);
  world.room_ = std::make_shared<CheckoutPlace>(checkout_room(world.station_));
  world.place_ = world.room_;
  world.station_from_store_ = inverse(world.store_from_station());
  return world;
}

Result<void> CheckoutWorld::check_reset(const EpisodeSpec& spec, const CheckoutPlace* lane) const {
  if (spec.robot != station_.robot)
    return Error{"robot.unknown",
                 spec.id,
                 fmt::format("the station has \"{}\", not \"{}\"", station_.robot, spec.robot)};
  if (const std::string asked = spec.station.value_or(checkout_station); asked != station_.id)
    return Error{"robot.unknown",
                 spec.id,
                 fmt::format("it is of the station \"{}\", this is \"{}\"", asked, station_.id)};
  MARKETGEN_CHECK(check_carried(station_.tool_sets, station_.carries, spec.tools, spec.id));
  const std::string given = lane == nullptr ? "" : lane->lane;
  const std::string asked = spec.lane.value_or("");
  if (asked == given) return {};
  return Error{"episode.other_store",
               spec.id + "/lane",
               fmt::format("it is {}, this is {}: open it with its store",
                           spoken_place(asked),
                           spoken_place(given))};
}

Result<void> CheckoutWorld::reset(const EpisodeSpec& spec,
                                  const std::vector<catalog::Product>& products,
                                  std::shared_ptr<const CheckoutPlace> lane,
                                  const std::optional<Perturbation>& perturbation,
                                  const Realism& realism) {
  MARKETGEN_CHECK(check_reset(spec, lane.get()));
  item_goods_.clear();
  for (const EpisodeItem& item : spec.items) {
    const auto row = std::ranges::find(products, item.sku, &catalog::Product::sku);
    if (row == products.end())
      return Error{"catalog.unknown_sku", spec.id, "there is no product \"" + item.sku + "\""};
    MARKETGEN_TRY(SharedEpisodeGoods goods, episode_goods(*row, frictions_));
    item_goods_.push_back(std::move(goods));
  }
  place_ = lane ? std::move(lane) : room_;
  station_from_store_ = inverse(store_from_station());
  first_item_ = static_cast<std::uint32_t>(place_->surroundings.products.size());
  perturbation_ =
      perturbation ? perturbation : perturbation_of(realism.goods, goods_seed(spec.seed));
  realism_ = realism;
  noise_ = realism_seed(spec.seed);
  basket_start_ = station_.basket_pose();
  const EpisodeSpec lies = displaced(spec);
  return perturbation_ ? begin_perturbed(lies) : begin(lies);
}

Result<void> CheckoutWorld::begin(const EpisodeSpec& spec) {
  spec_ = spec;
  std::unique_ptr<scene::Scene> scene = checkout_scene(*place_, basket_start_, spec_, item_goods_);
  MARKETGEN_TRY(physics::World world, make_world(*scene));
  world_ = std::make_unique<physics::World>(std::move(world));
  scene_ = std::move(scene);
  MARKETGEN_CHECK(place_items(spec_.items));
  const mjModel& m = world_->model();
  basket_place_ = m.jnt_qposadr[mj_name2id(&m, mjOBJ_JOINT, basket_name)];
  MARKETGEN_TRY(controller_, physics::RobotController::start(*world_, *robot_));
  MARKETGEN_TRY(cups_, physics::SuctionActor::find(*world_, *robot_));
  watch_ = EpisodeWatch(*world_, *robot_, item_rows());
  start_senses({}, {});
  steps_ = 0;
  done_ = false;
  return {};
}

Result<void> CheckoutWorld::place_items(const std::vector<EpisodeItem>& items) {
  const Pose store_from_basket = store_from_station() * basket_start_;
  for (std::size_t i = 0; i < item_goods_.size(); ++i)
    MARKETGEN_CHECK(world_->place(product_of(i), store_from_basket * items[i].pose()));
  return {};
}

Result<std::unique_ptr<CheckoutWorld>> CheckoutWorld::twin() const {
  std::unique_ptr<CheckoutWorld> twin(new CheckoutWorld(frictions_));
  twin->station_ = station_;
  twin->robot_ = std::make_unique<robots::Robot>(*robot_);
  twin->arm_ = arm_;
  twin->room_ = room_;
  twin->place_ = place_;
  twin->station_from_store_ = station_from_store_;
  twin->first_item_ = first_item_;
  twin->item_goods_ = item_goods_;
  twin->perturbation_ = perturbation_;
  twin->realism_ = realism_;
  twin->noise_ = noise_.child("rehearsal");
  twin->basket_start_ = basket_start_;
  MARKETGEN_CHECK(twin->begin(spec_));
  return twin;
}

std::vector<std::uint32_t> CheckoutWorld::item_rows() const {
  std::vector<std::uint32_t> rows(item_goods_.size());
  std::iota(rows.begin(), rows.end(), first_item_);
  return rows;
}

Result<physics::World> CheckoutWorld::make_world(const scene::Scene& scene) const {
  physics::RobotActorOptions place;
  place.world_from_base = store_from_station();
  place.state = ready_state(station_, *robot_);
  place.touch = physics::GripperTouch::fine;
  const bool alone = place_ == room_;
  physics::WorldOptions options;
  options.frictions = frictions_;
  if (perturbation_) {
    options.frictions = perturbation_->frictions(frictions_);
    options.mass_factors = perturbation_->mass_factors(scene.catalog);
  }
  options.keep_commands = false;
  options.loose = item_rows();
  options.pool = std::max(1, static_cast<int>(item_goods_.size()) + (alone ? 0 : pool_at_lane));
  options.soft_pool = alone ? 0 : soft_pool_at_lane;
  options.cups = physics::robot_cups(*robot_, place);
  options.actor_materials = counter_materials(station_, *robot_, place);
  options.add_actors = [&](mjSpec_& made) -> Result<void> {
    MARKETGEN_CHECK(physics::add_robot(made, *robot_, place));
    add_loose_basket(made, station_, store_from_station() * basket_start_);
    return {};
  };
  return physics::World::create(scene, std::move(options));
}

double CheckoutWorld::time_s() const {
  return world_->time_s();
}

std::vector<double> CheckoutWorld::robot_state() const {
  return controller_.actor().position(*world_);
}

Scenery CheckoutWorld::scenery() const {
  Scenery now{time_s(), robot_state()};
  for (std::size_t i = 0; i < item_count(); ++i)
    now.products.emplace_back(product_of(i), store_from_station() * item_pose(i));
  for (const std::uint32_t product : moved_neighbours())
    now.products.emplace_back(product, product_pose(product));
  now.basket = store_from_station() * basket_pose();
  return now;
}

agent::Observation CheckoutWorld::as_it_is() const {
  const physics::RobotActor& actor = controller_.actor();
  const std::vector<double> q = actor.position(*world_), v = actor.velocity(*world_);
  agent::Observation seen;
  seen.time_s = time_s();
  for (const int dof : arm_) {
    seen.position.push_back(q[static_cast<std::size_t>(dof)]);
    seen.velocity.push_back(v[static_cast<std::size_t>(dof)]);
  }
  seen.openings_m = tool_openings_m(*robot_, q);
  see_cups(cups_, *world_, *robot_, seen);
  seen.external_force_n = controller_.external_force_n();
  seen.stopped = controller_.stopped(time_s());
  return seen;
}

SealedProducts CheckoutWorld::sealed_products() const {
  return episodes::sealed_products(cups_, *world_, *robot_);
}

EpisodeWatch::Moment CheckoutWorld::moment() const {
  EpisodeWatch::Moment now;
  now.world_from_basket = store_from_station() * basket_pose();
  now.is_outside = [this](std::uint32_t product) {
    const std::uint32_t item = product - first_item_;
    const Vec3 middle = to_double(item_goods_[item]->body.center_of_mass);
    return !in_basket({station_.container(), basket_pose()})(item_pose(item) * middle);
  };
  return now;
}

Result<void> CheckoutWorld::move(const agent::Action& action) {
  link_.give(action);
  for (int i = 0; i < ControlStep::count(); ++i) {
    MARKETGEN_CHECK(controller_.command(*world_, link_.next(controller_)));
    MARKETGEN_CHECK(use_cups(cups_, *world_, *robot_, link_.in_force()));
    MARKETGEN_CHECK(world_->step());
    controller_.feel(*world_);
    sense(i + 1);
    const SealedProducts sealed = sealed_products();
    EpisodeWatch::Moment now = moment();
    now.sealed = sealed;
    watch_.look(*world_, now);
    if (physics_watch_) physics_watch_(world_->model(), world_->data());
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
  done_ = time_s() >= spec_.limit_s - physics::time_step_s / 2;
  return observe();
}

ItemState CheckoutWorld::item_state(std::size_t item) const {
  const EpisodeGoods& goods = *item_goods_[item];
  const EpisodeWatch::Item& seen = watched(item);
  return {goods.product.sku,
          item_pose(item),
          to_double(goods.body.center_of_mass),
          goods.volume,
          seen.touched_by >= 0,
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
  return rests_in(region(), item);
}

bool CheckoutWorld::rests_in(const HoldsPoint& region, std::size_t item) const {
  const EpisodeWatch::Item& seen = watched(item);
  if (seen.touched_by >= 0 || seen.rested_s < min_rest_s)
    return false;  // before its volume is looked at
  return is_in_place(region, item_state(item));
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
      judge_checkout(region(), spec_.goals, item_states(), watch_.max_tilt_deg());
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
    if (length(now.position - spec_.items[i].pose().position) > displaced_m) ++effects.displaced;
  }
  return effects;
}

Result<EpisodeResult> CheckoutWorld::finish() {
  done_ = true;
  agent::Action hold{told(), {{as_it_is().openings_m.front(), hold_n}}};
  turn_cups_off(*robot_, hold);
  for (double waited = 0; waited < judged_after_s - physics::time_step_s; waited += control_step_s)
    MARKETGEN_CHECK(move(hold));
  const EpisodeOutcome outcome =
      judge_checkout(region(), spec_.goals, item_states(), watch_.max_tilt_deg());
  EpisodeResult result;
  result.episode = spec_.id;
  result.store = spec_.store;
  result.scene_hash = spec_.scene_hash;
  result.side_effects = side_effects(outcome);
  add_outcome(outcome, result);
  result.steps = steps_;
  result.simulated_s = time_s();
  result.state_hash = state_hash();
  result.realism = realism_.name;
  return result;
}

std::string CheckoutWorld::save() const {
  ByteWriter writer;
  writer(world_->snapshot().bytes(), controller_, watch_, senses_, late_, link_, steps_, done_);
  return writer.take();
}

Result<void> CheckoutWorld::restore(std::string_view moment) {
  std::string physics;
  physics::RobotController controller = controller_;
  EpisodeWatch watch = watch_;
  RobotSenses senses = senses_;
  LateSenses late = late_;
  CommandLink link = link_;
  int steps = 0;
  bool done = false;
  ByteReader reader(moment);
  reader(physics, controller, watch, senses, late, link, steps, done);
  if (!reader.ok() || controller.setpoints().size() != robot_->dof_count() ||
      !std::ranges::all_of(item_rows(),
                           [&](std::uint32_t row) { return watch.items().contains(row); }))
    return Error{"physics.bad_command", spec_.id, "the moment is of another episode"};
  MARKETGEN_TRY(const physics::WorldSnapshot snapshot, physics::WorldSnapshot::of_bytes(physics));
  MARKETGEN_CHECK(world_->restore(snapshot));
  controller_ = std::move(controller);
  watch_ = std::move(watch);
  senses_ = senses;
  late_ = std::move(late);
  link_ = std::move(link);
  steps_ = steps;
  done_ = done;
  return {};
}

std::vector<std::uint32_t> CheckoutWorld::moved_neighbours() const {
  std::vector<std::uint32_t> moved = world_->moved_products();
  std::erase_if(moved, [&](std::uint32_t product) { return product >= first_item_; });
  return moved;
}

Pose CheckoutWorld::item_pose(std::size_t item) const {
  return station_from_store_ * world_->product_pose(product_of(item));
}

Vec3 CheckoutWorld::item_velocity(std::size_t item) const {
  return rotate(station_from_store_.rotation,
                world_->product_motion(product_of(item)).velocity_m_s);
}

Pose CheckoutWorld::basket_pose() const {
  const mjtNum* q = world_->data().qpos + basket_place_;
  return station_from_store_ * Pose{{q[0], q[1], q[2]}, {q[3], q[4], q[5], q[6]}};
}

double CheckoutWorld::deepest_overlap_m() const {
  double deepest = 0;
  for (const physics::WorldContact& contact : world_->contacts())
    deepest = std::max(deepest, contact.depth_m);
  return deepest;
}

MovedThing CheckoutWorld::thing_of(std::uint32_t product) const {
  const bool item = product >= first_item_;
  return {item ? ThingKind::item : ThingKind::product,
          item ? product - first_item_ : product,
          scene_->catalog[scene_->products[product].sku].sku,
          {}};
}

std::vector<MovedThing> CheckoutWorld::things() const {
  const Scenery now = scenery();
  std::vector<MovedThing> things;
  for (const auto& [row, pose] : now.products) {
    things.push_back(thing_of(row));
    things.back().store_from_thing = pose;
  }
  things.push_back({ThingKind::basket, 0, "", *now.basket});
  return things;
}

std::vector<double> CheckoutWorld::joint_positions() const {
  return world_->joint_positions();
}

}  // namespace marketgen::episodes
