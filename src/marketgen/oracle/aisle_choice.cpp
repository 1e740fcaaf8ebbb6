#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "oracle/aisle_oracle.h"
#include "oracle/rehearsal.h"
#include "skills/hand_grasp.h"
#include "skills/people_about.h"
#include "skills/plan_failure.h"

namespace marketgen::oracle {
namespace {

constexpr double min_item_s = 25;                         // no new item with less time left
constexpr double max_aside_m = 0.10, min_upright = 0.99;  // of what may be tried once more
constexpr int max_off_mm = 30;  // the ways of a base that slid on its wheels, or was stopped

}  // namespace

// Of which too few lie in the basket.
std::vector<std::string> AisleOracle::unmet() const {
  std::vector<std::string> skus;
  const std::vector<std::uint32_t> inside = world_->in_basket();
  for (const episodes::EpisodeGoal& goal : world_->spec().goals) {
    const auto there =
        std::ranges::count_if(inside, [&](std::uint32_t row) { return sku_of(row) == goal.sku; });
    if (there < goal.count) skus.push_back(goal.sku);
  }
  return skus;
}
std::vector<std::string> AisleOracle::missing() const {
  std::vector<std::string> skus = unmet();
  std::erase_if(skus, [&](const std::string& sku) {
    const auto tried = memory_.tries.find(sku);
    return tried != memory_.tries.end() && tried->second >= search_.max_item_tries;
  });
  return skus;
}

const std::string& AisleOracle::sku_of(std::uint32_t product) const {
  const scene::Scene& scene = world_->store().scene;
  return scene.catalog[scene.products[product].sku].sku;
}

// Length of the way to where it could stand; empty when it could not. Before a door that is open it
// stands nearly there, where the leaf leaves room: as far off as the product is.
std::optional<double> AisleOracle::way_to(std::uint32_t product) const {
  if (is_behind_open_door(product)) {
    const Vec3 off = world_->world().product_pose(product).position -
                     episodes::axle_of(robot_, world_->world_from_base());
    return std::hypot(off.x, off.y);
  }
  const auto place = world_->store().standing_place(product);
  if (!place) return std::nullopt;
  const Vec3 at = episodes::axle_of(robot_, world_->world_from_base());
  const auto path = ways().shortest_path(floor_mm(at), *place);
  return path.ok() ? std::optional(path->length_m) : std::nullopt;
}

// No longer about where it stood on its shelf, upright.
bool AisleOracle::was_moved(std::uint32_t product) const {
  const Pose stood = scene::world_from_product(world_->store().scene.products[product]),
             now = world_->world().product_pose(product);
  return length(now.position - stood.position) > max_aside_m ||
         rotate(now.rotation, {0, 0, 1}).z < min_upright;
}

// Items of all missing goals, nearest first; of a facing only the first one. While a door is open,
// of those behind it.
std::vector<AisleOracle::Fetch> AisleOracle::fetches(const std::vector<std::string>& skus) const {
  std::vector<Fetch> found;
  for (const std::string& sku : skus) {
    std::set<std::uint32_t> seen;
    for (const std::uint32_t row : world_->store().front_items(sku)) {
      if (refused_.contains(row) || was_moved(row)) continue;
      if (memory_.open && !is_behind_open_door(row)) continue;
      if (!seen.insert(world_->store().scene.products[row].facing).second) continue;
      if (const auto way = way_to(row)) found.push_back({*way, row});
    }
  }
  std::ranges::stable_sort(found, {}, &Fetch::way_m);
  if (search_.other_order) std::ranges::reverse(found);
  return found;
}

Result<void> AisleOracle::choose() {
  if (is_rehearsal_) {  // what it rehearses is over
    memory_.done = true;
    return {};
  }
  const std::vector<std::string> skus = missing();
  const bool late = now_.time_s + min_item_s + time_for_doors_s() > task_.limit_s;
  const std::vector<Fetch> found = skus.empty() || late ? std::vector<Fetch>{} : fetches(skus);
  if (memory_.open && found.empty()) return go_to_leaf();
  if (skus.empty() || late) {
    for (const std::string& sku : skus)
      note(sku, episodes::FailureCode::timeout);
    memory_.done = true;
    return {};
  }
  std::map<std::string, std::size_t> looked_at;
  for (const Fetch& fetch : found) {
    if (looked_at[sku_of(fetch.product)]++ >= search_.max_items_looked_at) continue;
    if (go_to(fetch.product)) return {};
    if (++unplanned_[fetch.product] >= search_.max_unplanned) refused_.insert(fetch.product);
  }
  // The others at the next step: one answer must not take for ever.
  memory_.done = looked_at.empty();
  for (const std::string& sku : skus)
    if (memory_.done) memory_.failures.try_emplace(sku, episodes::FailureCode::not_found);
  return {};
}

collect::GoodsNow AisleOracle::goods_now() const {
  collect::GoodsNow goods(world_->store().scene);
  for (const std::uint32_t row : world_->world().moved_products())
    goods.move(row, world_->world().product_pose(row));
  if (world_->store().doors != episodes::Doors::none) goods.set_joints(world_->joint_positions());
  return goods;
}

Result<collect::CollectOptions> AisleOracle::collect_options(std::uint32_t product) {
  collect::CollectOptions options;
  std::vector<motion::GraspCandidate>& known = grasps_[sku_of(product)];
  if (known.empty()) {
    MARKETGEN_TRY(known, world_->known_grasps(product, tool_));
  }
  options.grasps = known;
  // Once more by another one, if there is one.
  const std::vector<Vec3>& missed = memory_.missed[product];
  std::ranges::stable_partition(options.grasps, [&](const motion::GraspCandidate& grasp) {
    return std::ranges::find(missed, grasp.grasp.product_from_tool.position) == missed.end();
  });
  options.posture = world_->store().station.posture;
  options.carried = world_->store().basket.walls;
  options.speed = skills::carrying_speed;
  options.acceleration = skills::carrying_acceleration;
  return options;
}

motion::FloorPlace AisleOracle::axle_place(const Pose& world_from_base) const {
  const Vec3 axle = episodes::axle_of(robot_, world_from_base);
  const Vec3 ahead = rotate(world_from_base.rotation, {1, 0, 0});
  return {{axle.x, axle.y}, std::atan2(ahead.y, ahead.x)};
}

Result<motion::BaseFollower> AisleOracle::way_of(const Pose& world_from_base) {
  const PointMm stands = ways().space().nearest_free(
      floor_mm(episodes::axle_of(robot_, world_->world_from_base())), max_off_mm);
  memory_.goes_to = axle_place(world_from_base);
  memory_.waited = false;
  MARKETGEN_TRY(motion::DrivePlan plan,
                motion::plan_drive(ways(),
                                   robot_,
                                   world_->store().driving,
                                   {{stands[0] * 1e-3, stands[1] * 1e-3}, now_.base.heading},
                                   memory_.goes_to));
  return std::move(plan.follower);
}

// People have held it up on its way: it goes there round them, or lets them out and comes back.
Result<void> AisleOracle::make_way() {
  const Vec3 axle = episodes::axle_of(robot_, world_->world_from_base());
  MARKETGEN_TRY(motion::WayRound way,
                motion::plan_way_round(ways(),
                                       robot_,
                                       world_->store().driving,
                                       {{axle.x, axle.y}, now_.base.heading},
                                       memory_.goes_to,
                                       skills::people_about(now_),
                                       memory_.waited));
  // What was in vain is not tried twice running.
  memory_.waited = way.wait_s > 0 && !memory_.waited;
  say(way.aside ? "makes room for somebody" : way.wait_s > 0 ? "waits for somebody" : "goes round");
  memory_.executor.drive(std::move(way));
  return memory_.phase == Phase::arrived ? rise_and_open() : Result<void>{};
}

Result<void> AisleOracle::rise_and_open() {
  MARKETGEN_CHECK(memory_.executor.raise(lift_height(), agent::Subtask::reach));
  memory_.executor.open(memory_.plan.tool, opened());
  return {};
}

void AisleOracle::note_plan(std::uint32_t product, const Error& error) {
  say("no way to it: " + to_string(error));
  note(sku_of(product),
       value_named<episodes::FailureCode>(skills::failure_of_plan(error))
           .value_or(episodes::FailureCode::no_path));
}

bool AisleOracle::go_to(std::uint32_t product) {
  const Seed seed = next_seed("place");
  const auto options = options_from_afar(product);
  if (!options.ok()) {
    note_plan(product, options.error());
    return false;
  }
  auto plan = collect::plan_collect(goods_, product, robot_, tool_, seed, *options);
  if (!plan.ok()) {
    note_plan(product, plan.error());
    return false;
  }
  if (const auto door = shut_door_before(product)) return go_to_door(*door, product);
  auto drive = way_of(plan->world_from_base);
  if (!drive.ok()) {
    note(sku_of(product), episodes::FailureCode::no_path);
    return false;
  }
  memory_.executor.drive(std::move(*drive));
  memory_.plan = std::move(*plan);
  if (const auto raised = rise_and_open(); !raised.ok()) {
    note_plan(product, raised.error());
    return false;
  }
  memory_.phase = Phase::arrived;
  return true;
}

// Planned anew from where the base came to stand, and rehearsed; what does no harm is done.
// Otherwise another grasp is tried. Where each does harm the robot comes once more, perhaps to
// stand elsewhere and with its other hand, and then does the one that does least; none of those
// that would not bring the item into the basket.
Result<void> AisleOracle::reach() {
  const std::uint32_t product = memory_.plan.product;
  const Memory before = memory_;
  std::optional<Memory> best;
  int least = harm_of_not_placed;
  for (int rehearsal = 0; rehearsal < search_.max_rehearsals_here; ++rehearsal) {
    const Result<void> begun = begin_taking();
    if (!begun.ok()) {
      note_plan(product, begun.error());
      break;
    }
    if (!search_.rehearses) return {};
    MARKETGEN_TRY(const int harm, rehearse());
    if (harm == 0) return {};
    say(fmt::format("rehearsed with harm of {}", harm));
    if (harm < least) {
      least = harm;
      best = memory_;
    }
    Memory next = before;
    next.moves = memory_.moves;
    next.missed = memory_.missed;
    next.missed[product].push_back(memory_.plan.grasp.grasp.product_from_tool.position);
    next.failures = memory_.failures;
    memory_ = std::move(next);
  }
  if (best && memory_.unreached[product] > 0)
    memory_ = std::move(*best);
  else
    come_in_vain(product);
  return {};
}

void AisleOracle::come_in_vain(std::uint32_t product) {
  if (++memory_.unreached[product] == search_.max_unreached) refused_.insert(product);
  memory_.phase = Phase::choose;
}

Result<void> AisleOracle::begin_taking() {
  MARKETGEN_TRY(collect::CollectOptions options, collect_options(memory_.plan.product));
  options.world_from_base = world_->world_from_base();
  const Seed seed = next_seed("reach");
  MARKETGEN_TRY(memory_.plan,
                collect::plan_collect(goods_, memory_.plan.product, robot_, tool_, seed, options));
  ++memory_.tries[sku_of(memory_.plan.product)];
  const robots::Tool& tool = robot_.tools[static_cast<std::size_t>(memory_.plan.tool)];
  memory_.force_n = skills::carrying_grasp({}, memory_.plan.grasp, tool.force).force_n;
  say(fmt::format("takes {} with {}, {}, {:.0f} N, try {}",
                  scene::product_id(world_->store().scene, memory_.plan.product),
                  memory_.plan.group,
                  name_of(memory_.plan.grasp.strategy),
                  memory_.force_n,
                  memory_.tries[sku_of(memory_.plan.product)]));
  memory_.phase = Phase::pressed;
  return memory_.executor.take({.ways = static_cast<const skills::PickWays&>(memory_.plan),
                                .group = memory_.plan.group,
                                .tool = memory_.plan.tool,
                                .lift_m = lift_height(),
                                .open = opened(),
                                .close = {0, memory_.force_n}});
}

// From here until something else is to be fetched.
Result<int> AisleOracle::rehearse() {
  MARKETGEN_CHECK(twin_->restore(world_->save()));
  AisleOracle actor(*this);
  actor.world_ = twin_.get();
  actor.twin_.reset();
  actor.is_rehearsal_ = true;
  const int before = actor.harm();
  MARKETGEN_CHECK(rehearse_in(*twin_, actor));
  const std::string& sku = sku_of(memory_.plan.product);
  if (const auto why = actor.memory_.failures.find(sku); why != actor.memory_.failures.end())
    note(sku, why->second);
  MARKETGEN_TRY(const bool placed, twin_->in_place(memory_.plan.product));
  return actor.harm() - before + (placed ? 0 : harm_of_not_placed);
}

int AisleOracle::harm() const {
  episodes::SideEffects effects = world_->watch().effects();
  effects.strayed = world_->strayed();
  effects.protective_stops = world_->controller().stops();
  effects.person_contacts = world_->watch().person_contacts();
  return harm_in(effects);
}

}  // namespace marketgen::oracle
