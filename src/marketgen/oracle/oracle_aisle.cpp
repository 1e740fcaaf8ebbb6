#include "oracle/oracle_aisle.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include <fmt/format.h>

#include "base/progress.h"
#include "collect/collect_plan.h"
#include "collect/scene_obstacles.h"
#include "skills/aisle_executor.h"
#include "skills/drop_plan.h"
#include "skills/hand_grasp.h"
#include "skills/plan_failure.h"

namespace marketgen::oracle {
namespace {

constexpr int max_item_tries = 3, max_unreached = 2;
constexpr std::size_t max_items_looked_at = 4;  // of a SKU at a time
constexpr double way_reach_m = 1.4;             // obstacles farther from the robot do not count
constexpr double let_go_wider_m = 0.02;         // than what was held, when it is let go
constexpr double min_item_s = 25;               // no new item with less time left
constexpr double cup_acceleration = 0.1;  // share of the joints' limits, with something on the cup
constexpr double max_aside_m = 0.10, min_upright = 0.99;  // of what may be tried once more

enum class AislePhase { choose, arrived, pressed, out, away, dropped };

class AisleOracle : public agent::Policy {
 public:
  AisleOracle(const episodes::AisleWorld& world, robots::GraspTool tool, Seed seed)
      : world_(world),
        robot_(world.robot()),
        tool_(std::move(tool)),
        seed_(seed),
        goods_(world.store().scene),
        executor_(world.robot(), episodes::commanded_dofs(world.robot())) {}

  Result<void> begin(const agent::Task& task, const agent::Observation& first) override {
    task_ = task;
    executor_.start(first);
    return {};
  }

  Result<agent::Action> act(const agent::Observation& now) override {
    if (plan_.tool < static_cast<int>(now_.sealed.size()) &&
        tool_.kind == robots::ToolKind::suction) {
      const auto cup = static_cast<std::size_t>(plan_.tool);
      if (now_.sealed[cup] && !now.sealed[cup] && now.openings_m[cup] == 0) say("the cup came off");
    }
    now_ = now;
    if (executor_.idle()) MARKETGEN_CHECK(decide());
    agent::Action action = executor_.next(now);
    action.stop = done_;
    return action;
  }

  std::string failure() const override {
    for (const std::string& sku : unmet())
      if (const auto why = failures_.find(sku); why != failures_.end())
        return std::string(name_of(why->second));
    return "None";
  }

 private:
  // The arm or what it holds was pressed on, and has been moved back a second of its way: what was
  // planned is given up, and goes on from here by another plan.
  Result<void> recover() {
    say("was stopped");
    switch (phase_) {
      case AislePhase::choose:  // on its way to its stowed posture
        return go_home();
      case AislePhase::arrived:
        phase_ = AislePhase::choose;
        return choose();
      case AislePhase::pressed:
        note(episodes::FailureCode::collision);
        held_ = false;
        missed_[plan_.product].push_back(plan_.grasp.grasp.product_from_tool.position);
        return back_off();
      case AislePhase::out:
        return back_off();
      case AislePhase::away:
      case AislePhase::dropped:
        phase_ = AislePhase::away;
        return drop();
    }
    return {};
  }

  Result<void> decide() {
    if (executor_.take_stop()) return recover();
    switch (phase_) {
      case AislePhase::choose:
        return choose();
      case AislePhase::arrived:
        return reach();
      case AislePhase::pressed:
        return pull_out();
      case AislePhase::out:
        return back_off();
      case AislePhase::away:
        return drop();
      case AislePhase::dropped:
        return check();
    }
    return {};
  }

  void note(const std::string& sku, episodes::FailureCode why) { failures_[sku] = why; }
  void note(episodes::FailureCode why) { note(sku_of(plan_.product), why); }
  void say(const std::string& what) const {
    log_debug(fmt::format("oracle {:.2f} s: {}", now_.time_s, what));
  }

  // ---- What to fetch next ----

  // Of which too few lie in the basket.
  std::vector<std::string> unmet() const {
    std::vector<std::string> skus;
    const std::vector<std::uint32_t> inside = world_.in_basket();
    for (const episodes::EpisodeGoal& goal : world_.spec().goals) {
      const auto there =
          std::ranges::count_if(inside, [&](std::uint32_t row) { return sku_of(row) == goal.sku; });
      if (there < goal.count) skus.push_back(goal.sku);
    }
    return skus;
  }
  std::vector<std::string> missing() const {
    std::vector<std::string> skus = unmet();
    std::erase_if(skus, [&](const std::string& sku) {
      const auto tried = tries_.find(sku);
      return tried != tries_.end() && tried->second >= max_item_tries;
    });
    return skus;
  }

  const std::string& sku_of(std::uint32_t product) const {
    const scene::Scene& scene = world_.store().scene;
    return scene.catalog[scene.products[product].sku].sku;
  }

  // Length of the way to where it could stand; empty when it could not.
  std::optional<double> way_to(std::uint32_t product) const {
    const auto place = world_.store().standing_place(product);
    if (!place) return std::nullopt;
    const Vec3 at = episodes::axle_of(robot_, world_.world_from_base());
    const auto path = world_.store().ways.shortest_path(episodes::floor_point_mm(at), *place);
    return path.ok() ? std::optional(path->length_m) : std::nullopt;
  }

  // No longer about where it stood on its shelf, upright.
  bool was_moved(std::uint32_t product) const {
    const Pose stood = scene::world_from_product(world_.store().scene.products[product]),
               now = world_.world().product_pose(product);
    return length(now.position - stood.position) > max_aside_m ||
           rotate(now.rotation, {0, 0, 1}).z < min_upright;
  }

  struct Fetch {
    double way_m = 0;
    std::uint32_t product = 0;
  };
  // Items of all missing goals, nearest first; of a facing only the first one.
  std::vector<Fetch> fetches(const std::vector<std::string>& skus) const {
    std::vector<Fetch> found;
    for (const std::string& sku : skus) {
      std::set<std::uint32_t> seen;
      for (const std::uint32_t row : world_.store().front_items(sku)) {
        if (refused_.contains(row) || was_moved(row)) continue;
        if (!seen.insert(world_.store().scene.products[row].facing).second) continue;
        if (const auto way = way_to(row)) found.push_back({*way, row});
      }
    }
    std::ranges::stable_sort(found, {}, &Fetch::way_m);
    return found;
  }

  Result<void> choose() {
    const std::vector<std::string> skus = missing();
    if (skus.empty() || now_.time_s + min_item_s > task_.limit_s) {
      for (const std::string& sku : skus)
        note(sku, episodes::FailureCode::timeout);
      done_ = true;
      return {};
    }
    std::map<std::string, std::size_t> looked_at;
    for (const Fetch& fetch : fetches(skus)) {
      if (looked_at[sku_of(fetch.product)]++ >= max_items_looked_at) continue;
      if (go_to(fetch.product)) return {};
      refused_.insert(fetch.product);
    }
    // The others at the next step: one answer must not take for ever.
    done_ = looked_at.empty();
    for (const std::string& sku : skus)
      if (done_) failures_.try_emplace(sku, episodes::FailureCode::not_found);
    return {};
  }

  collect::GoodsNow goods_now() const {
    collect::GoodsNow goods(world_.store().scene);
    for (const std::uint32_t row : world_.world().moved_products())
      goods.move(row, world_.world().product_pose(row));
    return goods;
  }

  Result<collect::CollectOptions> collect_options(std::uint32_t product) {
    collect::CollectOptions options;
    std::vector<motion::GraspCandidate>& known = grasps_[sku_of(product)];
    if (known.empty()) {
      MARKETGEN_TRY(known, world_.known_grasps(product, tool_));
    }
    options.grasps = known;
    // Once more by another one, if there is one.
    const std::vector<Vec3>& missed = missed_[product];
    std::ranges::stable_partition(options.grasps, [&](const motion::GraspCandidate& grasp) {
      return std::ranges::find(missed, grasp.grasp.product_from_tool.position) == missed.end();
    });
    options.posture = world_.store().station.posture;
    options.carried = world_.store().basket.walls;
    options.speed = skills::carrying_speed;
    options.acceleration = skills::carrying_acceleration;
    return options;
  }

  void note_plan(std::uint32_t product, const Error& error) {
    say("no way to it: " + to_string(error));
    note(sku_of(product),
         value_named<episodes::FailureCode>(skills::failure_of_plan(error))
             .value_or(episodes::FailureCode::no_path));
  }

  bool go_to(std::uint32_t product) {
    const Seed seed = seed_.child("place", static_cast<std::uint64_t>(moves_++));
    goods_ = goods_now();
    const auto options = collect_options(product);
    if (!options.ok()) {
      note_plan(product, options.error());
      return false;
    }
    auto plan = collect::plan_collect(goods_, product, robot_, tool_, seed, *options);
    if (!plan.ok()) {
      note_plan(product, plan.error());
      return false;
    }
    const Vec3 from = episodes::axle_of(robot_, world_.world_from_base()),
               to = episodes::axle_of(robot_, plan->world_from_base);
    const Vec3 ahead = rotate(plan->world_from_base.rotation, {1, 0, 0});
    auto drive = motion::plan_drive(world_.store().ways,
                                    robot_,
                                    world_.store().driving,
                                    {{from.x, from.y}, now_.base.heading},
                                    {{to.x, to.y}, std::atan2(ahead.y, ahead.x)});
    if (!drive.ok()) {
      note(sku_of(product), episodes::FailureCode::no_path);
      return false;
    }
    executor_.drive(std::move(drive->follower));
    plan_ = std::move(*plan);
    if (!executor_.raise(lift_height()).ok()) return false;
    executor_.open(plan_.tool, opened());
    phase_ = AislePhase::arrived;
    return true;
  }

  // ---- Taking it ----

  // Planned anew from where the base came to stand.
  Result<void> reach() {
    MARKETGEN_TRY(collect::CollectOptions options, collect_options(plan_.product));
    options.world_from_base = world_.world_from_base();
    const Seed seed = seed_.child("reach", static_cast<std::uint64_t>(moves_++));
    auto plan = collect::plan_collect(goods_, plan_.product, robot_, tool_, seed, options);
    if (!plan.ok()) {
      note_plan(plan_.product, plan.error());
      if (++unreached_[plan_.product] == max_unreached) refused_.insert(plan_.product);
      phase_ = AislePhase::choose;
      return {};
    }
    ++tries_[sku_of(plan_.product)];
    plan_ = std::move(*plan);
    const robots::Tool& tool = robot_.tools[static_cast<std::size_t>(plan_.tool)];
    force_n_ = skills::carrying_grasp({}, plan_.grasp, tool.force).force_n;
    say(fmt::format("takes {} with {}, {}, {:.0f} N, try {}",
                    scene::product_id(world_.store().scene, plan_.product),
                    plan_.group,
                    name_of(plan_.grasp.strategy),
                    force_n_,
                    tries_[sku_of(plan_.product)]));
    phase_ = AislePhase::pressed;
    return executor_.take({.ways = static_cast<const skills::PickWays&>(plan_),
                           .group = plan_.group,
                           .tool = plan_.tool,
                           .lift_m = lift_height(),
                           .open = opened(),
                           .close = {0, force_n_}});
  }

  // On the way to the grasp: the fingers apart, the cup off.
  agent::ToolCommand opened() const {
    return {tool_.kind == robots::ToolKind::suction ? agent::cup_off_m
                                                    : plan_.grasp.grasp.opening_m};
  }
  agent::ToolCommand let_go() const {
    if (tool_.kind == robots::ToolKind::suction) return {agent::cup_off_m};
    const double held = now_.openings_m[static_cast<std::size_t>(plan_.tool)];
    return {held + let_go_wider_m, force_n_};
  }

  double lift_height() const {
    return plan_.state[static_cast<std::size_t>(robot_.find_dof("lift"))];
  }

  bool holds_it() const { return world_.watch().is_held(plan_.product); }

  Result<void> pull_out() {
    phase_ = AislePhase::out;
    held_ = holds_it();
    if (held_) {
      executor_.pull_out();
      return {};
    }
    const Pose from_shelf =
        inverse(scene::world_from_product(world_.store().scene.products[plan_.product])) *
        world_.world().product_pose(plan_.product);
    say(fmt::format("took hold of nothing; it was moved by {:.3f} m, its upright is {:.2f}",
                    length(from_shelf.position),
                    rotate(from_shelf.rotation, {0, 0, 1}).z));
    note(episodes::FailureCode::missed);
    missed_[plan_.product].push_back(plan_.grasp.grasp.product_from_tool.position);
    return executor_.go_back();
  }

  Result<void> back_off() {
    const double room = world_.store().room_behind_m(world_.world_from_base());
    MARKETGEN_CHECK(executor_.back_off(room));
    if (!holds_it() && held_) {
      say("lost it while it pulled it out");
      note(episodes::FailureCode::slipped);
    }
    drop_lift_ = 0;
    phase_ = AislePhase::away;
    if (!holds_it()) return {};
    return executor_.raise(skills::drop_lifts_m[drop_lift_]);
  }

  // ---- Into the basket ----

  std::vector<double> state_now() const {
    std::vector<double> q = world_.robot_state();
    for (std::size_t dof = 0; dof < q.size(); ++dof) {
      const robots::Joint& joint = robot_.joint_of_dof(dof);
      q[dof] = std::clamp(q[dof], joint.lower, joint.upper);
    }
    for (const int dof : robot_.find_group("base")->dofs)
      q[static_cast<std::size_t>(dof)] = 0;
    return robots::with_followers(robot_, std::move(q));
  }

  Result<motion::Obstacles> around() const {
    const Vec3 middle = world_.world_from_base().position + Vec3{0, 0, 0.9};
    motion::Obstacles obstacles =
        collect::fixture_obstacles(world_.store().scene, middle, way_reach_m);
    std::vector<std::uint32_t> carried = world_.in_basket();
    carried.push_back(plan_.product);
    MARKETGEN_CHECK(
        collect::add_product_obstacles(goods_now(), middle, way_reach_m, carried, obstacles));
    return obstacles;
  }

  Result<std::vector<skills::CarriedItem>> inside() const {
    std::vector<skills::CarriedItem> items;
    const Pose base_from_world = inverse(world_.world_from_base());
    for (const std::uint32_t row : world_.in_basket()) {
      if (row == plan_.product && holds_it()) continue;
      const scene::Scene& scene = world_.store().scene;
      MARKETGEN_TRY(const assets::ProductBody body,
                    skills::make_store_body(scene.catalog[scene.products[row].sku]));
      items.push_back({body.pieces, base_from_world * world_.world().product_pose(row)});
    }
    return items;
  }

  Pose base_from_tip() const {
    const int frame = robot_.tools[static_cast<std::size_t>(plan_.tool)].frame;
    return robots::frame_pose(robot_, state_now(), frame);
  }

  Result<skills::StowQuestion> stow_question() const {
    const robots::JointGroup& arm = *robot_.find_group(plan_.group);
    skills::StowQuestion question{.state = state_now(),
                                  .world_from_base = world_.world_from_base(),
                                  .group = plan_.group,
                                  .around = {},
                                  .stow = robots::values_of(arm, world_.store().driving)};
    MARKETGEN_TRY(question.around, around());
    MARKETGEN_TRY(question.inside, inside());
    return question;
  }

  Result<void> drop() {
    if (!holds_it()) return go_home();
    const scene::Scene& scene = world_.store().scene;
    MARKETGEN_TRY(const assets::ProductBody body,
                  skills::make_store_body(scene.catalog[scene.products[plan_.product].sku]));
    skills::DropQuestion question;
    MARKETGEN_TRY(static_cast<skills::StowQuestion&>(question), stow_question());
    question.tool = plan_.tool;
    if (tool_.kind == robots::ToolKind::suction) question.acceleration = cup_acceleration;
    question.held = &body;
    question.tip_from_product = inverse(world_.world_from_base() * base_from_tip()) *
                                world_.world().product_pose(plan_.product);
    const Seed seed = seed_.child("drop", static_cast<std::uint64_t>(moves_++));
    auto plan = skills::plan_drop(robot_, world_.store().basket, question, seed);
    if (!plan.ok()) {
      say("no way into the basket: " + to_string(plan.error()));
      return try_other_lift();
    }
    executor_.let_down(std::move(*plan), let_go());
    phase_ = AislePhase::dropped;
    return {};
  }

  Result<void> try_other_lift() {
    note(episodes::FailureCode::no_path);
    if (++drop_lift_ >= skills::drop_lifts_m.size()) {
      done_ = true;  // with the item in its hand: it cannot go on
      return {};
    }
    return executor_.raise(skills::drop_lifts_m[drop_lift_]);
  }

  // The arm to its stowed posture, empty.
  Result<void> go_home() {
    phase_ = AislePhase::choose;
    MARKETGEN_TRY(const skills::StowQuestion question, stow_question());
    const Seed seed = seed_.child("home", static_cast<std::uint64_t>(moves_++));
    auto way = skills::plan_stow(robot_, world_.store().basket, question, seed);
    if (!way.ok()) {
      note(episodes::FailureCode::no_path);
      done_ = true;
      return {};
    }
    executor_.stow(std::move(*way));
    return {};
  }

  Result<void> check() {
    phase_ = AislePhase::choose;
    const std::vector<std::uint32_t> inside = world_.in_basket();
    const bool there = std::ranges::count(inside, plan_.product) > 0;
    say(there ? "it is in the basket" : "lost it on its way into the basket");
    if (there)
      tries_[sku_of(plan_.product)] = 0;
    else
      note(episodes::FailureCode::dropped);
    return {};
  }

  const episodes::AisleWorld& world_;
  const robots::Robot& robot_;
  robots::GraspTool tool_;
  Seed seed_;
  collect::GoodsNow goods_;  // as they stood when the plan was made
  skills::AisleExecutor executor_;
  agent::Task task_;
  agent::Observation now_;
  AislePhase phase_ = AislePhase::choose;
  collect::CollectPlan plan_;
  double force_n_ = 0;
  std::size_t drop_lift_ = 0;
  std::map<std::string, int> tries_;                                   // by SKU
  std::map<std::string, std::vector<motion::GraspCandidate>> grasps_;  // by SKU
  std::set<std::uint32_t> refused_;
  std::map<std::uint32_t, std::vector<Vec3>> missed_;  // where the tip was in vain, product frame
  std::map<std::uint32_t, int> unreached_;             // times that it came and could not reach it
  int moves_ = 0;
  bool done_ = false;
  bool held_ = false;                                      // when the tool had closed
  std::map<std::string, episodes::FailureCode> failures_;  // by SKU, the last one
};

}  // namespace

Result<std::unique_ptr<agent::Policy>> make_aisle_oracle(const episodes::AisleWorld& world,
                                                         const std::filesystem::path& data,
                                                         Seed seed) {
  const std::string& row = world.store().station.tools().picks_with;
  MARKETGEN_TRY(robots::GraspTool tool, robots::load_grasp_tool(data, row));
  return std::unique_ptr<agent::Policy>(
      std::make_unique<AisleOracle>(world, std::move(tool), seed));
}

}  // namespace marketgen::oracle
