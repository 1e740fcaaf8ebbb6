#include "skills/shelf_pick.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace marketgen {
namespace {

// From the product's front to the base's middle, and to the side of the arm.
constexpr std::array pick_distances_m{0.62, 0.68, 0.74, 0.55};
constexpr std::array pick_sides_m{0.30, 0.26, 0.34, 0.20};
constexpr double tip_over_lift_m = 0.9;  // height of the grasp over the lift's zero

// The robot as it drives, its lift and one of its grippers set.
std::vector<double> raised_state(
    const Robot& robot, const Tool& tool, std::vector<double> q, double lift_m, double opening_m) {
  const auto set = [&](int dof, double value) {
    const Joint& joint = robot.joint_of_dof(static_cast<std::size_t>(dof));
    q[static_cast<std::size_t>(dof)] = std::clamp(value, joint.lower, joint.upper);
  };
  if (const int lift = robot.find_dof("lift"); lift >= 0) set(lift, lift_m);
  if (const JointGroup* fingers = robot.find_group(tool.prefix + "fingers"))
    for (const int dof : fingers->dofs)
      set(dof, opening_m / 2);
  return with_followers(robot, std::move(q));
}

class ShelfPickPlanner {
 public:
  ShelfPickPlanner(const Robot& robot,
                   const ShelfPickQuestion& question,
                   const Hand& hand,
                   Seed seed)
      : robot_(robot),
        question_(question),
        hand_(hand),
        seed_(seed),
        out_(rotate(question.world_from_product.rotation, {0, -1, 0})) {}

  Result<void> make_model() {
    MARKETGEN_TRY(model_, make_arm_model(robot_, hand_.arm->name));
    const std::vector<Pose> links = link_poses(robot_, question_.driving);
    side_ = links[static_cast<std::size_t>(hand_.arm->base)].position.y < 0 ? -1 : 1;
    return {};
  }

  // At the first place that serves; otherwise the error of the last one tried.
  Result<ShelfPick> plan(const Grasp& grasp) const {
    if (question_.world_from_base) return at_place(grasp, *question_.world_from_base);
    Error error{"collect.no_place", robot_.name, "there is no room to stand in front of it"};
    for (const double side : pick_sides_m) {
      for (const double distance : pick_distances_m) {
        const Pose place = place_before_shelf(
            question_.world_from_product.position, question_.depth_m, out_, distance, side * side_);
        if (!question_.may_stand(place)) continue;
        auto found = at_place(grasp, place);
        if (found.ok()) return found;
        error.message =
            fmt::format("at {:.2f} m from its front: {}", distance, found.error().message);
      }
    }
    return error;
  }

 private:
  Result<ShelfPick> at_place(const Grasp& grasp, const Pose& world_from_base) const {
    const Tool& tool = robot_.tools[static_cast<std::size_t>(hand_.tool)];
    const Pose world_from_tip = question_.world_from_product * grasp.product_from_tool;
    ShelfPick pick;
    pick.group = hand_.arm->name;
    pick.tool = hand_.tool;
    pick.grasp = grasp;
    pick.world_from_base = world_from_base;
    pick.state = raised_state(robot_,
                              tool,
                              question_.driving,
                              world_from_tip.position.z - tip_over_lift_m,
                              grasp.opening_m);
    const PickPlace place{world_from_base, pick.state, world_from_tip, out_};
    MARKETGEN_TRY(PickWays ways, plan_pick_ways(model_, place, question_.around, question_, seed_));
    static_cast<PickWays&>(pick) = std::move(ways);
    return pick;
  }

  const Robot& robot_;
  const ShelfPickQuestion& question_;
  Hand hand_;
  Seed seed_;
  Vec3 out_;         // from the shelf into the aisle
  double side_ = 1;  // 1 for an arm on the left of its robot, -1 on the right
  ArmModel model_;
};

}  // namespace

Result<ShelfPick> plan_shelf_pick(const Robot& robot,
                                  const ShelfPickQuestion& question,
                                  Seed seed) {
  std::vector<ShelfPickPlanner> planners;
  for (const Hand& hand : hands_with(robot, question.tool_row)) {
    planners.emplace_back(robot, question, hand, seed);
    MARKETGEN_CHECK(planners.back().make_model());
  }
  if (planners.empty())
    return Error{"robot.unknown",
                 robot.name,
                 fmt::format("no arm of this robot ends in a {}", question.tool_row)};
  Error error{"collect.no_place", robot.name, "there is no grasp to try"};
  for (const Grasp& grasp : question.grasps) {
    for (const ShelfPickPlanner& planner : planners) {
      auto pick = planner.plan(grasp);
      if (pick.ok()) return pick;
      error = pick.error();
    }
  }
  return error;
}

}  // namespace marketgen
