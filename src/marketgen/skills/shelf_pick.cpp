#include "skills/shelf_pick.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/interrupt.h"

namespace marketgen::skills {
namespace {

// From the product's front to the base's middle, and to the side of the arm. A robot that stands
// still has its arm in its middle: half as far, straight in front, and on the other side.
constexpr std::array pick_distances_m{0.62, 0.68, 0.74, 0.55, 0.48};
constexpr std::array driving_sides_m{0.30, 0.26, 0.34};
constexpr std::array standing_sides_m{0.15, 0.13, 0.17, 0.0, 0.06, -0.06};
constexpr double tip_over_lift_m = 0.9;  // height of the grasp over the lift's zero
constexpr int max_blocked = 12;          // places from which a grasp is in reach and cannot be had
constexpr double to_the_right_m = -1e-6;

// The arm comes to the grasp, but something is in its way.
bool is_blocked(const Error& error) {
  return error.code == "motion.line_blocked" || error.code == "motion.goal_in_collision" ||
         error.code == "motion.no_path";
}

class ShelfPickPlanner {
 public:
  ShelfPickPlanner(const robots::Robot& robot,
                   const ShelfPickQuestion& question,
                   const Hand& hand,
                   Seed seed)
      : robot_(robot),
        question_(question),
        hand_(hand),
        seed_(seed),
        out_(rotate(question.world_from_product.rotation, {0, -1, 0})) {}

  Result<void> make_model() {
    MARKETGEN_TRY(model_, motion::make_arm_model(robot_, hand_.arm->name));
    const std::vector<Pose> links = robots::link_poses(robot_, question_.driving);
    const double left = links[static_cast<std::size_t>(hand_.arm->base)].position.y;
    for (const double side : driving_sides_m)
      if (robot_.drive) sides_m_.push_back(left < to_the_right_m ? -side : side);
    if (!robot_.drive) sides_m_.assign(standing_sides_m.begin(), standing_sides_m.end());
    return {};
  }

  // At the first place that serves; otherwise the error of the last one tried.
  Result<ShelfPick> plan(std::size_t number) const {
    if (question_.world_from_base) return at_place(number, *question_.world_from_base);
    Error error{"collect.no_place", question_.where, "the robot can stand nowhere in front of it"};
    int blocked = 0;
    for (const double side : sides_m_) {
      for (const double distance : pick_distances_m) {
        if (blocked == max_blocked) return error;
        auto found = at_place(
            number,
            place_before_shelf(
                question_.world_from_product.position, question_.depth_m, out_, distance, side));
        if (found.ok()) return found;
        blocked += is_blocked(found.error()) ? 1 : 0;
        error.message =
            fmt::format("at {:.2f} m from its front: {}", distance, found.error().message);
      }
    }
    return error;
  }

 private:
  // Error: of the first height of the lift.
  Result<ShelfPick> at_place(std::size_t number, const Pose& world_from_base) const {
    std::optional<Error> first;
    for (const double offset : question_.lift_offsets_m) {
      auto pick = at_height(number, world_from_base, offset);
      if (pick.ok()) return pick;
      if (!first) first = pick.error();
    }
    return *first;
  }

  Result<ShelfPick> at_height(std::size_t number,
                              const Pose& world_from_base,
                              double lift_offset_m) const {
    const robots::Grasp& grasp = question_.grasps[number];
    const Pose world_from_tip = question_.world_from_product * grasp.product_from_tool;
    ShelfPick pick;
    pick.group = hand_.arm->name;
    pick.tool = hand_.tool;
    pick.grasp = grasp;
    pick.number = number;
    pick.world_from_base = world_from_base;
    pick.state = raised_state(robot_,
                              question_.driving,
                              world_from_tip.position.z - tip_over_lift_m + lift_offset_m,
                              grasp.opening_m);
    if (question_.may_stand) MARKETGEN_CHECK(question_.may_stand(world_from_base, pick.state));
    const PickPlace place{world_from_base, pick.state, world_from_tip, out_};
    MARKETGEN_TRY(PickWays ways, plan_pick_ways(model_, place, question_.around, question_, seed_));
    static_cast<PickWays&>(pick) = std::move(ways);
    return pick;
  }

  const robots::Robot& robot_;
  const ShelfPickQuestion& question_;
  Hand hand_;
  Seed seed_;
  Vec3 out_;                     // from the shelf into the aisle
  std::vector<double> sides_m_;  // to the left of the robot, at which the product is
  motion::ArmModel model_;
};

}  // namespace

Result<ShelfPick> plan_shelf_pick(const robots::Robot& robot,
                                  const ShelfPickQuestion& question,
                                  Seed seed) {
  MARKETGEN_TRY(std::vector<Hand> hands, hands_with(robot, question.tool_row));
  // Either hand comes first as often: of a robot with two none is there in vain.
  if (seed.child("first hand").stream().chance(0.5)) std::ranges::reverse(hands);
  std::vector<ShelfPickPlanner> planners;
  for (const Hand& hand : hands) {
    planners.emplace_back(robot, question, hand, seed);
    MARKETGEN_CHECK(planners.back().make_model());
  }
  Error error{"collect.no_place", question.where, "there is no grasp to try"};
  bool was_reached = false;
  for (std::size_t number = 0; number < question.grasps.size(); ++number) {
    for (const ShelfPickPlanner& planner : planners) {
      interrupt_point();
      auto pick = planner.plan(number);
      if (!pick.ok()) {
        if (!was_reached) error = pick.error();
        continue;
      }
      const Result<void> held = question.may_hold ? question.may_hold(*pick) : Result<void>();
      if (held.ok()) return pick;
      error = held.error();
      was_reached = true;
    }
  }
  return error;
}

}  // namespace marketgen::skills
