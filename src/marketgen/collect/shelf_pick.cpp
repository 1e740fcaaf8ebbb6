#include "collect/shelf_pick.h"

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
constexpr double slow_share = 0.25;      // of the speed, with the product

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
                   const JointGroup& arm,
                   int tool,
                   Seed seed)
      : robot_(robot),
        question_(question),
        arm_(arm),
        tool_(tool),
        seed_(seed),
        out_(rotate(question.world_from_product.rotation, {0, -1, 0})) {}

  Result<void> make_model() {
    MARKETGEN_TRY(model_, make_arm_model(robot_, arm_.name));
    const std::vector<Pose> links = link_poses(robot_, question_.driving);
    side_ = links[static_cast<std::size_t>(arm_.base)].position.y < 0 ? -1 : 1;
    return {};
  }

  // At the first place that serves; otherwise the error of the last one tried.
  Result<ShelfPick> plan(const Grasp& grasp) const {
    if (question_.world_from_base) return at_place(grasp, *question_.world_from_base);
    Error error{"collect.no_place", robot_.name, "there is no room to stand in front of it"};
    for (const double side : pick_sides_m) {
      for (const double distance : pick_distances_m) {
        const Pose place = place_before(distance, side * side_);
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
  // Facing the shelf, the product `side` to the left of the robot.
  Pose place_before(double distance, double side) const {
    const Vec3 left{out_.y, -out_.x, 0};  // of one who looks at the shelf
    Vec3 at = question_.world_from_product.position + out_ * (distance + question_.depth_m / 2) -
              left * side;
    at.z = 0;
    return {at, rotation_about({0, 0, 1}, std::atan2(-out_.y, -out_.x))};
  }

  Result<CollisionWorld> around(Obstacles obstacles, const Pose& world_from_base) const {
    for (const BoxObstacle& box : question_.carried)
      obstacles.boxes.push_back({world_from_base * box.pose, box.half_size});
    return CollisionWorld::make(obstacles);
  }

  Result<ShelfPick> at_place(const Grasp& grasp, const Pose& world_from_base) const {
    const Tool& tool = robot_.tools[static_cast<std::size_t>(tool_)];
    const Pose world_from_tip = question_.world_from_product * grasp.product_from_tool;
    ShelfPick pick;
    pick.group = arm_.name;
    pick.tool = tool_;
    pick.grasp = grasp;
    pick.world_from_base = world_from_base;
    pick.state = raised_state(robot_,
                              tool,
                              question_.driving,
                              world_from_tip.position.z - tip_over_lift_m,
                              grasp.opening_m);
    const Pose base_from_world =
        inverse(world_from_base *
                link_poses(robot_, pick.state)[static_cast<std::size_t>(model_.group.base)]);
    ReachQuestion reach;
    for (const int dof : model_.group.dofs)
      reach.start.push_back(pick.state[static_cast<std::size_t>(dof)]);
    reach.base_from_grasp = base_from_world * world_from_tip;
    reach.approach = {0, 0, question_.approach_m};
    MARKETGEN_TRY(const CollisionWorld way_world, around(question_.way, world_from_base));
    MARKETGEN_TRY(const CollisionWorld line_world, around(question_.line, world_from_base));
    MARKETGEN_TRY(const ArmChecker way,
                  ArmChecker::make(model_, pick.state, world_from_base, way_world));
    MARKETGEN_TRY(const ArmChecker line,
                  ArmChecker::make(model_, pick.state, world_from_base, line_world));
    MARKETGEN_TRY(pick.reach, plan_reach(way, line, reach, seed_, arm_options(1)));
    MARKETGEN_CHECK(add_way_out(line, base_from_world, world_from_tip, pick));
    return pick;
  }

  ArmPlanOptions arm_options(double share) const {
    ArmPlanOptions options;
    options.speed = question_.speed * share;
    options.acceleration = question_.acceleration;
    return options;
  }

  Result<void> add_way_out(const ArmChecker& line,
                           const Pose& base_from_world,
                           Pose world_from_tip,
                           ShelfPick& pick) const {
    world_from_tip.position.z += question_.lift_m;
    MARKETGEN_TRY(const JointPath rising,
                  tool_line(line, pick.reach.line.back(), base_from_world * world_from_tip));
    world_from_tip.position += out_ * question_.retreat_m;
    MARKETGEN_TRY(const JointPath leaving,
                  tool_line(line, rising.back(), base_from_world * world_from_tip));
    MARKETGEN_TRY(const auto limits, motion_limits(model_, arm_options(slow_share)));
    MARKETGEN_TRY(pick.lift, timed_curve(rising, limits));
    MARKETGEN_TRY(pick.retreat, timed_curve(leaving, limits));
    return {};
  }

  const Robot& robot_;
  const ShelfPickQuestion& question_;
  const JointGroup& arm_;
  int tool_;
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
  for (std::size_t t = 0; t < robot.tools.size(); ++t) {
    for (const JointGroup& group : robot.groups) {
      const Tool& tool = robot.tools[t];
      if (tool.row != question.tool_row || group.solver.empty() || group.tip != tool.frame)
        continue;
      planners.emplace_back(robot, question, group, static_cast<int>(t), seed);
      MARKETGEN_CHECK(planners.back().make_model());
    }
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
