#include "skills/drop_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

namespace marketgen::skills {
namespace {

constexpr double off_walls_m = 0.008;  // of what is let down
constexpr int drop_yaws = 16;
constexpr std::array drop_tilts{0.0, 0.35, 0.7, 1.05};  // of the tool from straight down, rad
constexpr int drop_columns = 5;                         // places along each side of the basket
constexpr std::size_t max_drops = 800;                  // that are looked at
constexpr double mixed_m = 0.06;
constexpr int max_searches = 3;  // in vain, before the basket is given up
constexpr double let_go_back_m = 0.12;
constexpr int max_lines = 4;                  // down to one place that are tried
constexpr int max_descents = 2;               // ways down to one place
constexpr std::size_t descents_at_once = 16;  // goals of one search
constexpr double way_margin_m = 0.004, line_margin_m = 0.002;
constexpr double over_rim_m = 0.06;  // where the line down begins, of the lowest point held
constexpr double of_tilt = 0.03, of_offset = 0.1,
                 of_rim = 2;  // metres of height that they are worth
constexpr double line_speed_share = 0.25, felt_speed_share = 0.15;
constexpr double off_floor_m = 0.006;                    // where a way down that is felt ends
constexpr std::array felt_shares{1.0, 0.75, 0.5, 0.25};  // of the rest of the way down
constexpr int max_drop_samples = 8000;

std::vector<int> links_of(const robots::Robot& robot, const robots::Tool& tool) {
  std::vector<int> links;
  for (std::size_t link = 0; link < robot.links.size(); ++link)
    if (robot.links[link].name.starts_with(tool.prefix)) links.push_back(static_cast<int>(link));
  return links;
}

motion::ArmPlanOptions carrying(double acceleration) {
  motion::ArmPlanOptions options;
  options.speed = carrying_speed;
  options.acceleration = acceleration;
  return options;
}

// At so much of the speed.
Result<std::vector<motion::MotionLimits>> slowed(const motion::ArmModel& model,
                                                 motion::ArmPlanOptions options,
                                                 double speed_share) {
  options.speed *= speed_share;
  return motion::motion_limits(model, options);
}

// The store, the basket and what lies in it.
Result<motion::CollisionWorld> around_robot(const CarriedBasket& basket,
                                            const StowQuestion& question,
                                            const std::vector<CarriedItem>& inside) {
  std::vector<motion::BoxObstacle> carried = basket.walls;
  for (const CarriedItem& item : inside)
    carried.push_back(box_of(item));
  motion::Obstacles all = question.around;
  for (const motion::BoxObstacle& box : carried_at(carried, question.world_from_base))
    all.boxes.push_back(box);
  return motion::CollisionWorld::make(all);
}

// An arm by its basket, with the walls of that and what is minded inside.
struct ArmInBasket {
  motion::ArmModel model;
  motion::CollisionWorld world;
  std::optional<motion::ArmChecker> checker;
  motion::Configuration start;
  Pose arm_from_tip, arm_from_base;

  ArmInBasket() = default;
  ArmInBasket(const ArmInBasket&) = delete;  // its checker refers to it
  ArmInBasket& operator=(const ArmInBasket&) = delete;

  Result<void> look(const robots::Robot& robot,
                    const CarriedBasket& basket,
                    const StowQuestion& question,
                    const std::vector<CarriedItem>& inside) {
    MARKETGEN_TRY(model, motion::make_arm_model(robot, question.group));
    MARKETGEN_TRY(world, around_robot(basket, question, inside));
    MARKETGEN_TRY(checker,
                  motion::ArmChecker::make(
                      model, question.state, question.world_from_base, world, {line_margin_m, {}}));
    start = robots::values_of(model.group, question.state);
    arm_from_base = inverse(
        robots::link_poses(robot, question.state)[static_cast<std::size_t>(model.group.base)]);
    arm_from_tip = arm_from_base * robots::frame_pose(robot, question.state, model.group.tip);
    return {};
  }
  Result<motion::JointPath> up(double up_m) const {
    Pose end = arm_from_tip;
    end.position += rotate(arm_from_base.rotation, {0, 0, up_m});
    return motion::tool_line(*checker, start, end);
  }
  Result<motion::JointPath> back() const {
    Pose end = arm_from_tip;
    end.position += rotate(end.rotation, {0, 0, -let_go_back_m});
    return motion::tool_line(*checker, start, end);
  }
  Result<motion::JointTrajectory> stow(const motion::Configuration& from,
                                       const StowQuestion& question,
                                       Seed seed) const {
    MARKETGEN_TRY(
        motion::ArmPlan plan,
        motion::plan_arm(*checker, from, {question.stow}, seed, carrying(carrying_acceleration)));
    return std::move(plan.trajectory);
  }
  Result<motion::JointTrajectory> slowly(const motion::JointPath& line) const {
    MARKETGEN_TRY(const auto limits,
                  slowed(model, carrying(carrying_acceleration), line_speed_share));
    return motion::timed_curve(line, limits);
  }
};

struct Drop {
  Pose base_from_tip;
  double lowest_m = 0;  // of what is held, over the basket's floor, when it has come to rest
  double fall_m = 0;    // to there
  double cost = 0;
};

class DropSearch {
 public:
  DropSearch(const CarriedBasket& basket, const DropQuestion& question)
      : basket_(basket), question_(question), fill_(basket, question.inside) {}

  // Best first, but mixed: neighbours of what cannot be reached cannot be reached either.
  std::vector<Drop> drops(Seed seed) const {
    std::vector<Drop> found;
    for (const double tilt : drop_tilts) {
      for (int yaw = 0; yaw < drop_yaws; ++yaw) {
        for (int side = 0; side < (tilt > 0 ? 4 : 1); ++side)
          add(turned(tilt, side * std::numbers::pi / 2, 2 * std::numbers::pi * yaw / drop_yaws),
              tilt,
              found);
      }
    }
    Stream draw = seed.child("mixed").stream();
    for (Drop& drop : found)
      drop.cost += draw.uniform(0, mixed_m);
    std::ranges::stable_sort(found, {}, &Drop::cost);
    if (found.size() > max_drops) found.resize(max_drops);
    return found;
  }

 private:
  // Basket's frame: straight down, leaning towards `side`, turned about its own axis.
  static Quaternion turned(double tilt, double side, double yaw) {
    return rotation_about({std::cos(side), std::sin(side), 0}, tilt) *
           rotation_about({0, 0, 1}, yaw) * rotation_about({1, 0, 0}, std::numbers::pi);
  }

  void add(const Quaternion& tip, double tilt, std::vector<Drop>& found) const {
    const Pose product = Pose{{}, tip} * question_.tip_from_product;
    const TurnedBox box = turned_box(*question_.held, product);
    const double x = basket_.size.x / 2 - off_walls_m - box.half.x,
                 y = basket_.size.y / 2 - off_walls_m - box.half.y;
    if (x < 0 || y < 0) return;
    const Underside held(*question_.held, product.rotation);
    for (int i = 0; i < drop_columns; ++i) {
      for (int j = 0; j < drop_columns; ++j) {
        const double at_x = x * (2.0 * i / (drop_columns - 1) - 1),
                     at_y = y * (2.0 * j / (drop_columns - 1) - 1);
        const double support = fill_.rest_m(held, at_x, at_y);
        const double above = std::max(0.0, support + 2 * box.half.z - basket_.size.z);
        for (const double fall : drop_heights_m) {
          const Vec3 tip_at = Vec3{at_x, at_y, support + fall + box.half.z} - box.middle;
          found.push_back({basket_.base_from_floor * Pose{tip_at, tip},
                           support,
                           fall,
                           support + fall + of_tilt * tilt + of_offset * std::hypot(at_x, at_y) +
                               of_rim * above});
        }
      }
    }
  }

  const CarriedBasket& basket_;
  const DropQuestion& question_;
  BasketFill fill_;
};

// A place over the basket that the arm can reach, and its straight way down from there.
struct Descent {
  Drop drop;
  motion::JointPath line, out;
};

class DropPlanner {
 public:
  DropPlanner(const robots::Robot& robot, const CarriedBasket& basket, const DropQuestion& question)
      : robot_(robot),
        basket_(basket),
        question_(question),
        options_(carrying(question.acceleration)) {
    options_.search.max_iterations = max_drop_samples;
  }
  DropPlanner(const DropPlanner&) = delete;  // its checkers refer to it
  DropPlanner& operator=(const DropPlanner&) = delete;

  // Before anything else. Errors: those of make_arm_model and of the checkers.
  Result<void> look_around() {
    MARKETGEN_TRY(world_, around_robot(basket_, question_, question_.inside));
    MARKETGEN_TRY(model_, motion::make_arm_model(robot_, question_.group));
    const std::vector<double>& state = question_.state;
    start_ = robots::values_of(model_.group, state);
    base_from_arm_ = robots::link_poses(robot_, state)[static_cast<std::size_t>(model_.group.base)];
    const robots::Tool& tool = robot_.tools[static_cast<std::size_t>(question_.tool)];
    const std::vector<motion::AttachedObject> held{held_product(
        robot_, tool.frame, *question_.held, question_.tip_from_product, links_of(robot_, tool))};
    const Pose& at = question_.world_from_base;
    MARKETGEN_TRY(way_, motion::ArmChecker::make(model_, state, at, world_, {way_margin_m, held}));
    MARKETGEN_TRY(line_, motion::ArmChecker::make(model_, state, at, world_, {line_margin_m, {}}));
    return {};
  }

  // At most max_descents for one place; the arm's postures nearest to the start first.
  Result<void> add_descents(const Drop& drop, std::vector<Descent>& found) {
    const double up = over_m(drop);
    const Pose end = inverse(base_from_arm_) * drop.base_from_tip;
    Pose begin = end;
    begin.position += rotate(inverse(base_from_arm_.rotation), {0, 0, up});
    const auto postures = motion::arm_goals(robot_, model_.group, begin, start_);
    if (!postures.ok()) return postures.error();
    Error error{"motion.goal_in_collision", "over the basket", "the arm has no room"};
    int added = 0, tried = 0;
    for (const motion::Configuration& q : *postures) {
      if (!way_->free(q)) continue;
      if (++tried > max_lines) break;
      auto line = motion::tool_line(*line_, q, end);
      if (!line.ok()) {
        error = line.error();
        continue;
      }
      motion::JointPath out = way_out(*line, end);
      found.push_back({drop, std::move(*line), std::move(out)});
      if (++added == max_descents) break;
    }
    if (added == 0) return error;
    return {};
  }

  // By the first of the descents that is reached and that `finish` makes a plan of.
  template <class Plan>
  Result<Plan> plan(std::vector<Descent> descents,
                    Seed seed,
                    Result<Plan> (DropPlanner::*finish)(const motion::JointPath& way,
                                                        const Descent& descent,
                                                        Seed seed) const) const {
    while (true) {
      std::vector<motion::Configuration> goals;
      for (const Descent& descent : descents)
        goals.push_back(descent.line.front());
      MARKETGEN_TRY(const motion::JointPath way,
                    motion::plan_arm_path(*way_, start_, goals, seed, options_));
      const auto reached = std::ranges::find(goals, way.back()) - goals.begin();
      auto plan = (this->*finish)(way, descents[static_cast<std::size_t>(reached)], seed);
      if (plan.ok() || descents.size() == 1) return plan;
      descents.erase(descents.begin() + reached);
    }
  }

  // With the way out, if the arm gets home by it.
  Result<DropPlan> by_way(const motion::JointPath& way, const Descent& descent, Seed seed) const {
    MARKETGEN_TRY(const auto quick, motion::motion_limits(model_, options_));
    MARKETGEN_TRY(const auto slow, slowed(model_, options_, line_speed_share));
    DropPlan plan;
    plan.base_from_tip = descent.drop.base_from_tip;
    MARKETGEN_TRY(plan.way, motion::timed_path(way, quick));
    MARKETGEN_TRY(const motion::JointTrajectory down, motion::timed_curve(descent.line, slow));
    plan.way.append(down);
    MARKETGEN_TRY(plan.retreat, motion::timed_curve(descent.out, slow));
    MARKETGEN_TRY(const motion::ArmPlan home,
                  motion::plan_arm(
                      *line_, descent.out.back(), {question_.stow}, seed.child("home"), options_));
    plan.home = home.trajectory;
    return plan;
  }

  // Down as far as the basket goes, whatever is taken to lie there.
  Result<FeltDrop> felt(const motion::JointPath& way, const Descent& descent, Seed) const {
    ArmInBasket arm;
    MARKETGEN_CHECK(arm.look(robot_, basket_, question_, {}));
    motion::JointPath down = descent.line;
    FeltDrop plan;
    plan.base_from_tip = descent.drop.base_from_tip;
    const double rest = descent.drop.lowest_m + descent.drop.fall_m - off_floor_m;
    for (const double share : felt_shares) {
      Pose end = descent.drop.base_from_tip;
      end.position.z -= std::max(0.0, rest) * share;
      const auto on = motion::tool_line(*arm.checker, down.back(), inverse(base_from_arm_) * end);
      if (!on.ok()) continue;
      down.insert(down.end(), on->begin() + 1, on->end());
      plan.base_from_tip = end;
      break;
    }
    MARKETGEN_TRY(const auto quick, motion::motion_limits(model_, options_));
    MARKETGEN_TRY(const auto gentle, slowed(model_, options_, felt_speed_share));
    MARKETGEN_TRY(plan.way, motion::timed_path(way, quick));
    MARKETGEN_TRY(plan.down, motion::timed_curve(down, gentle));
    return plan;
  }

 private:
  // Of the place over the basket over where it lets go.
  double over_m(const Drop& drop) const {
    return std::max(0.05, basket_.size.z + over_rim_m - drop.lowest_m);
  }

  // Fingers that lean would lift what they let go: back along the tool, or else the way it came.
  motion::JointPath way_out(const motion::JointPath& line, Pose end) const {
    end.position += rotate(end.rotation, {0, 0, -let_go_back_m});
    auto back = motion::tool_line(*line_, line.back(), end);
    if (back.ok()) return std::move(*back);
    return {line.rbegin(), line.rend()};
  }

  const robots::Robot& robot_;
  const CarriedBasket& basket_;
  const DropQuestion& question_;
  motion::ArmPlanOptions options_;
  motion::ArmModel model_;
  motion::CollisionWorld world_;
  std::optional<motion::ArmChecker> way_, line_;  // with what is held, and without it
  motion::Configuration start_;
  Pose base_from_arm_;
};

template <class Plan>
Result<Plan> plan_down(const robots::Robot& robot,
                       const CarriedBasket& basket,
                       const DropQuestion& question,
                       Seed seed,
                       Result<Plan> (DropPlanner::*finish)(const motion::JointPath& way,
                                                           const Descent& descent,
                                                           Seed seed) const) {
  DropPlanner planner(robot, basket, question);
  MARKETGEN_CHECK(planner.look_around());
  const std::vector<Drop> drops = DropSearch(basket, question).drops(seed);
  Error error{"collect.no_drop", robot.name, "the basket has no room for what is held"};
  std::vector<Descent> descents;
  int searches = 0;
  for (std::size_t i = 0; i < drops.size() && searches < max_searches; ++i) {
    if (const auto added = planner.add_descents(drops[i], descents); !added.ok())
      error.message = fmt::format("in the last place that was tried: {}", added.error().message);
    const bool last = i + 1 == drops.size();
    if (descents.empty() || (descents.size() < descents_at_once && !last)) continue;
    auto plan = planner.plan(std::move(descents), seed.child("drop", i), finish);
    if (plan.ok()) return plan;
    error.message = plan.error().message;
    if (plan.error().code == "motion.start_in_collision") break;
    descents.clear();
    ++searches;
  }
  return error;
}

}  // namespace

Result<DropPlan> plan_drop(const robots::Robot& robot,
                           const CarriedBasket& basket,
                           const DropQuestion& question,
                           Seed seed) {
  return plan_down(robot, basket, question, seed, &DropPlanner::by_way);
}

Result<FeltDrop> plan_felt_drop(const robots::Robot& robot,
                                const CarriedBasket& basket,
                                const DropQuestion& question,
                                Seed seed) {
  return plan_down(robot, basket, question, seed, &DropPlanner::felt);
}

Result<BasketExit> plan_basket_exit(const robots::Robot& robot,
                                    const CarriedBasket& basket,
                                    const StowQuestion& question,
                                    Seed seed) {
  ArmInBasket arm;
  MARKETGEN_CHECK(arm.look(robot, basket, question, {}));
  auto line = arm.back();
  if (!line.ok()) line = arm.up(basket.size.z);
  if (!line.ok()) return line.error();
  BasketExit exit;
  MARKETGEN_TRY(exit.retreat, arm.slowly(*line));
  MARKETGEN_TRY(exit.home, arm.stow(line->back(), question, seed));
  return exit;
}

Result<motion::JointTrajectory> plan_rise(const robots::Robot& robot,
                                          const CarriedBasket& basket,
                                          const StowQuestion& question,
                                          double up_m) {
  ArmInBasket arm;
  MARKETGEN_CHECK(arm.look(robot, basket, question, {}));
  MARKETGEN_TRY(const motion::JointPath line, arm.up(up_m));
  return arm.slowly(line);
}

Result<motion::JointTrajectory> plan_stow(const robots::Robot& robot,
                                          const CarriedBasket& basket,
                                          const StowQuestion& question,
                                          Seed seed) {
  ArmInBasket arm;
  MARKETGEN_CHECK(arm.look(robot, basket, question, question.inside));
  return arm.stow(arm.start, question, seed);
}

}  // namespace marketgen::skills
