#include "episodes/aisle/aisle_world.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include "agent/aisle_map.h"
#include "episodes/aisle/mapped_store.h"
#include "episodes/aisle/perturbed_aisle.h"
#include "physics/goods/spec_geoms.h"

namespace marketgen::episodes {
namespace {

constexpr double about_basket_m = 0.6;  // of its floor
constexpr double let_go_s = judged_after_s;
constexpr std::string_view basket_material = "pet";  // moulded, against goods

// One box a wall: bodies of the robot's base.
void add_basket(mjSpec& spec, const AisleStation& station, const robots::Robot& robot) {
  const robots::RobotFrame& frame =
      robot.frames[static_cast<std::size_t>(robot.find_frame(station.basket.frame))];
  mjsBody* body =
      mjs_findBody(&spec, robot.links[static_cast<std::size_t>(frame.link)].name.c_str());
  int number = 0;
  for (const physics::ContainerBox& box : station.basket_boxes()) {
    mjsGeom* geom = physics::add_shape(body,
                                       {assets::CollisionShape::box,
                                        link_from_basket(station, robot) * box.container_from_box,
                                        box.half_size});
    geom->mass = 0;
    mjs_setName(geom->element, fmt::format("basket/{}", number++).c_str());
  }
}

std::map<std::string, std::string> materials_of(const AisleStation& station,
                                                const robots::Robot& robot) {
  std::map<std::string, std::string> materials = physics::robot_materials(robot, {});
  for (std::size_t i = 0; i < station.basket_boxes().size(); ++i)
    materials.emplace(fmt::format("basket/{}", i), std::string(basket_material));
  return materials;
}

std::vector<std::int32_t> joints_of_parts(const scene::Scene& scene) {
  std::vector<std::int32_t> joints;
  for (const scene::ScenePart& part : scene.parts)
    joints.push_back(part.joint);
  return joints;
}

robots::BasePlace start_of(const EpisodeSpec& spec) {
  return {spec.start.x_m, spec.start.y_m, spec.start.heading_deg * std::numbers::pi / 180};
}

PointMm start_mm(const EpisodeSpec& spec, const robots::Robot& robot) {
  return floor_mm(axle_of(robot, agent::store_from_base(start_of(spec))));
}

std::size_t dof_named(const robots::Robot& robot, std::string_view name) {
  return static_cast<std::size_t>(robot.find_dof(name));
}

// That the store has what the episode is of: its robot, tools, doors and goals.
Result<void> check_begins(const EpisodeSpec& spec, const AisleStore& store) {
  const AisleStation& station = store.station;
  if (spec.robot != station.robot)
    return Error{"robot.unknown",
                 spec.id,
                 fmt::format("the track has \"{}\", not \"{}\"", station.robot, spec.robot)};
  MARKETGEN_CHECK(check_carried(station.tool_sets, station.carries, spec.tools, spec.id));
  if (doors_of(spec) != store.doors)
    return Error{"episode.bad_value",
                 spec.id + "/doors",
                 fmt::format("the store was opened for goals with doors {}, not {}",
                             name_of(store.doors),
                             name_of(doors_of(spec)))};
  for (const EpisodeGoal& goal : spec.goals) {
    const auto reached = static_cast<int>(store.front_items(goal.sku).size());
    if (reached > 0 && reached < goal.count)
      return Error{"episode.impossible",
                   spec.id,
                   fmt::format("asks for {} of \"{}\"; {} stand in front within reach",
                               goal.count,
                               goal.sku,
                               reached)};
    if (reached == 0)
      return Error{
          "catalog.unknown_sku", spec.id, "the store offers no \"" + goal.sku + "\" within reach"};
  }
  return {};
}

}  // namespace

Result<void> AisleWorld::reset(const EpisodeSpec& spec,
                               const std::optional<Perturbation>& perturbation,
                               const Realism& realism,
                               std::vector<double> posture) {
  perturbation_ =
      perturbation ? perturbation : perturbation_of(realism.goods, goods_seed(spec.seed));
  realism_ = realism;
  posture_ = std::move(posture);
  noise_ = realism_seed(spec.seed);
  store_ = perturbation_ ? perturbed_store(*stocked_, *perturbation_) : stocked_;
  return begin(spec);
}

Result<void> AisleWorld::begin(const EpisodeSpec& spec) {
  const AisleStation& station = store_->station;
  const robots::Robot& robot = store_->robot;
  MARKETGEN_CHECK(check_begins(spec, *store_));
  physics::RobotActorOptions place;
  place.state = posture_.empty() ? store_->driving : posture_;
  const robots::BasePlace start = start_of(spec);
  place.state[dof_named(robot, "base_x")] = start.x_m;
  place.state[dof_named(robot, "base_y")] = start.y_m;
  place.state[dof_named(robot, "base_yaw")] = start.heading;
  if (!store_->ways.space().free(start_mm(spec, robot)))
    return Error{
        "episode.impossible", spec.id, "the robot would begin in something that stands there"};
  physics::WorldOptions options;
  options.frictions = frictions_;
  if (perturbation_) {
    options.frictions = perturbation_->frictions(frictions_);
    options.mass_factors = perturbation_->mass_factors(store_->scene.catalog);
  }
  options.keep_commands = false;
  options.actor_materials = materials_of(station, robot);
  options.cups = physics::robot_cups(robot, place);
  MARKETGEN_CHECK(begin_people(spec));
  options.bystanders = people_.bodies();
  options.add_actors = [&](mjSpec_& made) -> Result<void> {
    MARKETGEN_CHECK(physics::add_robot(made, robot, place));
    add_basket(made, station, robot);
    people_.add_to(made);
    return {};
  };
  MARKETGEN_TRY(physics::World world, physics::World::create(store_->scene, std::move(options)));
  world_ = std::make_unique<physics::World>(std::move(world));
  MARKETGEN_TRY(controller_, physics::RobotController::start(*world_, robot));
  MARKETGEN_TRY(cups_, physics::SuctionActor::find(*world_, robot));
  spec_ = spec;
  commanded_ = commanded_dofs(robot);
  path_m_ = 0;
  people_.start(*world_, robot);
  watch_ = EpisodeWatch(*world_, robot);
  if (store_->doors != Doors::none) watch_.know_joints(joints_of_parts(store_->scene));
  axle_ = axle_of(robot, world_from_base());
  start_senses(agent::base_place(world_from_base()), controller_.wheels().reckoned());
  steps_ = 0;
  done_ = false;
  return {};
}

// The same at each beginning of the episode, also in a twin.
Result<void> AisleWorld::begin_people(const EpisodeSpec& spec) {
  people_ = {};
  if (!realism_.people) return {};
  MARKETGEN_TRY(PeopleAround around,
                PeopleAround::make(store_->scene,
                                   realism_.people->per_m2,
                                   realism_seed(spec.seed).child("people"),
                                   {spec.start.x_m, spec.start.y_m}));
  people_ = PeopleInWorld(std::move(around));
  return {};
}

Result<std::shared_ptr<AisleWorld>> AisleWorld::twin() const {
  auto twin = std::make_shared<AisleWorld>(store_, frictions_);
  twin->perturbation_ = perturbation_;
  twin->realism_ = realism_;
  twin->posture_ = posture_;
  twin->noise_ = noise_.child("rehearsal");
  MARKETGEN_CHECK(twin->begin(spec_));
  return twin;
}

Result<std::shared_ptr<const AisleStore>> AisleWorld::mapped() const {
  return mapped_store(store_, realism_.map, noise_.child("map"), start_mm(spec_, robot()));
}

double AisleWorld::time_s() const {
  return world_->time_s();
}

std::vector<double> AisleWorld::robot_state() const {
  return controller_.actor().position(*world_);
}

Pose AisleWorld::world_from_base() const {
  return base_of(robot(), robot_state());
}

Scenery AisleWorld::scenery() const {
  Scenery now{time_s(), robot_state()};
  now.people = people().moments();
  for (const std::uint32_t row : world_->moved_products())
    now.products.emplace_back(row, world_->product_pose(row));
  return now;
}

Pose AisleWorld::world_from_basket() const {
  return world_from_base() * store_->basket.base_from_floor;
}

agent::Observation AisleWorld::as_it_is() const {
  const std::vector<double> q = robot_state(), v = controller_.actor().velocity(*world_);
  agent::Observation seen;
  seen.time_s = time_s();
  for (const int dof : commanded_) {
    seen.position.push_back(q[static_cast<std::size_t>(dof)]);
    seen.velocity.push_back(v[static_cast<std::size_t>(dof)]);
  }
  seen.openings_m = tool_openings_m(robot(), q);
  see_cups(cups_, *world_, robot(), seen);
  seen.base = controller_.wheels().reckoned();
  seen.external_force_n = controller_.external_force_n();
  seen.stopped = controller_.stopped(time_s());
  seen.people = people_.scanned(world_from_base(), axle_of(robot(), world_from_base()));
  return seen;
}

SealedProducts AisleWorld::sealed_products() const {
  return episodes::sealed_products(cups_, *world_, robot());
}

Result<void> AisleWorld::move(const agent::Action& action) {
  link_.give(action);
  people_.pass(*world_, control_step_s);
  for (int i = 0; i < ControlStep::count(); ++i) {
    MARKETGEN_CHECK(people_.move(*world_, static_cast<double>(i + 1) / ControlStep::count()));
    MARKETGEN_CHECK(controller_.command(*world_, link_.next(controller_)));
    MARKETGEN_CHECK(use_cups(cups_, *world_, robot(), link_.in_force()));
    MARKETGEN_CHECK(world_->step());
    controller_.feel(*world_);
    sense(i + 1);
    const Vec3 now = axle_of(robot(), world_from_base());
    const Vec3 way = now - axle_;
    path_m_ += std::hypot(way.x, way.y);
    const double turn = controller_.actor().velocity(*world_)[dof_named(robot(), "base_yaw")];
    const auto sealed = sealed_products();
    watch_.look(*world_, {now, way / physics::time_step_s, turn, sealed, {}, {}});
    axle_ = now;
    if (physics_watch_) physics_watch_(world_->model(), world_->data());
  }
  MARKETGEN_CHECK(people_.measure(*world_, control_step_s));
  return {};
}

Result<agent::Observation> AisleWorld::step(const agent::Action& action) {
  MARKETGEN_CHECK(check_action(action, robot(), commanded_.size(), done_));
  if (action.stop) {
    done_ = true;
    return observe();
  }
  MARKETGEN_CHECK(move(action));
  ++steps_;
  senses_.drive(controller_.wheels().reckoned(), agent::base_place(world_from_base()), steps_);
  done_ = time_s() >= spec_.limit_s - physics::time_step_s / 2;
  return observe();
}

HoldsPoint AisleWorld::region() const {
  const CarriedBasketRow& b = store_->station.basket;
  return [b](Vec3 at) {
    return std::abs(at.x) <= b.top_m[0] / 2 && std::abs(at.y) <= b.top_m[1] / 2 && at.z >= 0 &&
           at.z <= b.height_m;
  };
}

ItemState AisleWorld::item_state(std::uint32_t product, const EpisodeWatch::Item& item) const {
  const EpisodeGoods& goods = *goods_.at(store_->scene.products[product].sku);
  return {goods.product.sku,
          inverse(world_from_basket()) * world_->product_pose(product),
          to_double(goods.body.center_of_mass),
          goods.volume,
          item.touched_by >= 0,
          item.rested_s,
          item.impact_m_s};
}

// What was touched, and what else has moved about the basket: that may lie on goods in it.
Result<std::vector<ItemState>> AisleWorld::item_states() {
  std::map<std::uint32_t, EpisodeWatch::Item> items = watch_.items();
  const Vec3 basket = world_from_basket().position;
  for (const std::uint32_t product : world_->moved_products())
    if (length(world_->product_pose(product).position - basket) < about_basket_m)
      items.try_emplace(product);
  std::vector<ItemState> states;
  for (const auto& [product, item] : items) {
    MARKETGEN_CHECK(know_goods(product));
    states.push_back(item_state(product, item));
  }
  return states;
}

Result<void> AisleWorld::know_goods(std::uint32_t product) {
  const std::uint32_t sku = store_->scene.products[product].sku;
  if (goods_.contains(sku)) return {};
  MARKETGEN_TRY(SharedEpisodeGoods made, episode_goods(store_->scene.catalog[sku], frictions_));
  goods_.emplace(sku, std::move(made));
  return {};
}

Result<bool> AisleWorld::in_place(std::uint32_t product) {
  const auto item = watch_.items().find(product);
  if (item == watch_.items().end() || item->second.touched_by >= 0 ||
      item->second.rested_s < min_rest_s)
    return false;
  MARKETGEN_CHECK(know_goods(product));
  return is_in_place(region(), item_state(product, item->second));
}

Result<bool> AisleWorld::goals_met() {
  int asked = 0, there = 0;
  for (const EpisodeGoal& goal : spec_.goals)
    asked += goal.count;
  for (const auto& [product, item] : watch_.items()) {
    MARKETGEN_TRY(const bool placed, in_place(product));
    there += placed ? 1 : 0;
  }
  if (there < asked) return false;  // most of the time: judging costs more
  MARKETGEN_TRY(const std::vector<ItemState> states, item_states());
  const EpisodeOutcome outcome = judged(states);
  return outcome.hits >= outcome.asked;
}

// Void where somebody was hurt, whatever lies in the basket.
EpisodeOutcome AisleWorld::judged(const std::vector<ItemState>& states) const {
  EpisodeOutcome outcome = judge(region(), spec_.goals, states);
  outcome.is_void = watch_.person_hardest_n() > max_person_n;
  if (outcome.is_void) outcome.hits = 0;
  return outcome;
}

std::string AisleWorld::save() const {
  ByteWriter writer;
  writer(world_->snapshot().bytes(), controller_, watch_, axle_, path_m_);
  writer(senses_, late_, link_, steps_, done_, people_);
  return writer.take();
}

Result<void> AisleWorld::restore(std::string_view moment) {
  std::string physics;
  physics::RobotController controller = controller_;
  double path = 0;
  EpisodeWatch watch = watch_;
  Vec3 axle;
  RobotSenses senses = senses_;
  LateSenses late = late_;
  CommandLink link = link_;
  int steps = 0;
  bool done = false;
  PeopleInWorld people = people_;
  ByteReader reader(moment);
  reader(physics, controller, watch, axle, path, senses, late, link, steps, done, people);
  if (!reader.ok() || controller.setpoints().size() != robot().dof_count())
    return Error{"physics.bad_command", spec_.id, "the moment is of another episode"};
  MARKETGEN_TRY(const physics::WorldSnapshot snapshot, physics::WorldSnapshot::of_bytes(physics));
  MARKETGEN_CHECK(world_->restore(snapshot));
  controller_ = std::move(controller);
  path_m_ = path;
  watch_ = std::move(watch);
  axle_ = axle;
  senses_ = senses;
  late_ = std::move(late);
  link_ = std::move(link);
  steps_ = steps;
  done_ = done;
  people_ = std::move(people);
  return {};
}

std::vector<std::uint32_t> AisleWorld::in_basket() const {
  const HoldsPoint inside = region();
  const Pose basket_from_world = inverse(world_from_basket());
  std::vector<std::uint32_t> rows;
  for (const auto& [product, item] : watch_.items()) {
    const double height = store_->scene.catalog[store_->scene.products[product].sku].height_m();
    const Vec3 middle = world_->product_pose(product) * Vec3{0, 0, height / 2};
    if (inside(basket_from_world * middle)) rows.push_back(product);
  }
  return rows;
}

Result<std::vector<motion::GraspCandidate>> AisleWorld::known_grasps(
    std::uint32_t product, const robots::GraspTool& tool) const {
  const catalog::Product& goods = store_->scene.catalog[store_->scene.products[product].sku];
  const auto& witness = spec_.certificate.witness;
  const auto pick = std::ranges::find(witness, goods.sku, &WitnessPick::sku);
  return studied_grasps(
      goods, tool, frictions_, pick == witness.end() ? std::vector<int>() : pick->grasps);
}

int AisleWorld::strayed() const {
  const std::vector<std::uint32_t> carried = in_basket();
  const std::vector<std::uint32_t> moved = world_->moved_products();
  return static_cast<int>(std::ranges::count_if(moved, [&](std::uint32_t row) {
    const Vec3 stood = scene::world_from_product(store_->scene.products[row]).position;
    return !std::ranges::binary_search(carried, row) &&
           length(world_->product_pose(row).position - stood) > max_clean_shift_m;
  }));
}

int AisleWorld::doors_open() const {
  int open = 0;
  for (std::uint32_t joint = 0; joint < store_->scene.joints.size(); ++joint)
    if (collect::hinged_door(store_->scene, joint) && world_->joint_position(joint) > max_shut_rad)
      ++open;
  return open;
}

SideEffects AisleWorld::side_effects() const {
  SideEffects effects = watch_.effects();
  effects.strayed = strayed();
  effects.protective_stops = controller_.stops();
  if (realism_.people) {
    effects.person_contacts = watch_.person_contacts();
    effects.person_hardest_n = watch_.person_hardest_n();
    effects.person_near_s = people_.near_s();
    effects.person_distance_m = people_.min_distance_m();
  }
  return effects;
}

// How far it went, and how far it would have had to go.
void AisleWorld::add_lengths(EpisodeResult& result) const {
  const PointMm from = floor_mm(Vec2{spec_.start.x_m, spec_.start.y_m});
  std::vector<std::string> all, reached;
  for (const GoalOutcome& goal : result.goals) {
    all.push_back(goal.sku);
    if (goal.reached >= goal.count) reached.push_back(goal.sku);
  }
  result.path_m = path_m_;
  const auto share_of = [&](const std::vector<std::string>& skus, double& shortest) {
    const std::optional<double> tour = shortest_tour_m(*store_, from, skus);
    if (!tour) return 0.0;  // no way leads past all of them: nothing to compare with
    shortest = *tour;
    const double longer = std::max(shortest, path_m_);
    return longer > 0 ? result.success_partial * shortest / longer : 0;
  };
  double shortest_subset = 0;
  result.spl = share_of(all, result.shortest_m);
  result.spl_subset = share_of(reached, shortest_subset);
}

Result<EpisodeResult> AisleWorld::finish() {
  done_ = true;
  agent::Action hold = still_action(as_it_is());
  hold.position = told();
  turn_cups_off(robot(), hold);
  for (double waited = 0; waited < let_go_s - physics::time_step_s; waited += control_step_s)
    MARKETGEN_CHECK(move(hold));
  MARKETGEN_TRY(const std::vector<ItemState> states, item_states());
  const EpisodeOutcome outcome = judged(states);
  EpisodeResult result;
  result.episode = spec_.id;
  result.store = spec_.store;
  result.scene_hash = spec_.scene_hash;
  result.side_effects = side_effects();
  if (spec_.doors) result.side_effects.doors_open = doors_open();
  add_outcome(outcome, result);
  result.steps = steps_;
  result.simulated_s = time_s();
  result.state_hash = state_hash();
  result.realism = realism_.name;
  add_lengths(result);
  return result;
}

MovedThing AisleWorld::thing_of(std::uint32_t product) const {
  const scene::Scene& scene = store_->scene;
  return {ThingKind::product, product, scene.catalog[scene.products[product].sku].sku, {}};
}

std::vector<MovedThing> AisleWorld::things() const {
  std::vector<MovedThing> things;
  for (const auto& [row, pose] : scenery().products) {
    things.push_back(thing_of(row));
    things.back().store_from_thing = pose;
  }
  return things;
}

std::vector<double> AisleWorld::joint_positions() const {
  return world_->joint_positions();
}

}  // namespace marketgen::episodes
