#include "collect/collect_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/interrupt.h"
#include "collect/scene_obstacles.h"
#include "motion/standing_robot.h"

namespace marketgen {
namespace {

constexpr double reach_m = 1.3;       // obstacles farther from the product are of no account
constexpr double push_aside_m = 0.2;  // neighbours within it may be pushed by the fingers
// Places in front of the product: from its front to the base's middle, and to the side.
constexpr std::array distances_m{0.62, 0.68, 0.74, 0.55, 0.48};
constexpr std::array sides_m{0.30, 0.26, 0.34, 0.0, 0.12, -0.12};
constexpr double lift_below_m = 0.9;  // height of the grasp over the lift's zero
constexpr int most_blocked = 12;      // places from which a grasp is in reach and cannot be had

Result<std::vector<GraspCandidate>> grasps_of(const Product& goods,
                                              const GraspTool& tool,
                                              const CollectOptions& options) {
  if (!options.grasps.empty()) return options.grasps;
  MARKETGEN_TRY(const ProductBody body, make_product_body(goods));
  GraspQuery query;
  query.friction = options.fingers_friction;
  query.from_front = true;
  MARKETGEN_TRY(GraspCandidates grasps, grasp_candidates(goods, body, tool, query));
  if (grasps.found.empty()) return Error{"motion.no_grasp", goods.sku, grasps.reason};
  return std::move(grasps.found);
}

// The arm comes to the grasp, but something is in its way.
bool is_blocked(const Error& error) {
  return error.code == "motion.line_blocked" || error.code == "motion.goal_in_collision" ||
         error.code == "motion.no_path";
}

class Planner {
 public:
  Planner(const Scene& scene,
          std::uint32_t product,
          const Robot& robot,
          const Hand& hand,
          Seed seed,
          const CollectOptions& options)
      : scene_(scene),
        product_(product),
        robot_(robot),
        hand_(hand),
        seed_(seed),
        options_(options),
        world_from_product_(world_from_product(scene.products[product])),
        out_(rotate(world_from_product_.rotation, {0, -1, 0})) {}

  Result<void> look_around() {
    const Vec3 middle = world_from_product_.position;
    around_.way = around_.line = fixture_obstacles(scene_, middle, reach_m);
    around_.carried = options_.carried;
    MARKETGEN_CHECK(add_product_obstacles(scene_, middle, reach_m, {}, around_.way));
    MARKETGEN_CHECK(add_product_obstacles(scene_, middle, reach_m, neighbours(), around_.line));
    MARKETGEN_TRY(model_, make_arm_model(robot_, hand_.arm->name));
    return {};
  }

  // The plan at the first place that serves; otherwise the error of the last one tried.
  Result<CollectPlan> plan(const GraspCandidate& grasp) const {
    if (options_.world_from_base) return at_place(grasp, *options_.world_from_base);
    Error error{"collect.no_place", where(), "the robot can stand nowhere in front of it"};
    int blocked = 0;
    for (const double side : sides_m) {
      if (robot_.drive && side == 0) break;
      for (const double distance : distances_m) {
        if (blocked == most_blocked) return error;
        auto found =
            at_place(grasp, base_at(distance, robot_.drive ? side * arm_side() : side * 0.5));
        if (found.ok()) return found;
        blocked += is_blocked(found.error()) ? 1 : 0;
        error.message =
            fmt::format("at {:.2f} m from its front: {}", distance, found.error().message);
      }
    }
    return error;
  }

 private:
  std::string where() const { return product_id(scene_, product_); }

  std::vector<std::uint32_t> neighbours() const {
    std::vector<std::uint32_t> rows;
    for (std::uint32_t row = 0; row < scene_.products.size(); ++row) {
      if (length(world_from_product(scene_.products[row]).position - world_from_product_.position) <
          push_aside_m)
        rows.push_back(row);
    }
    return rows;
  }

  // 1 for an arm on the left of its robot, -1 on the right.
  double arm_side() const {
    const auto base = static_cast<std::size_t>(hand_.arm->base);
    return link_poses(robot_, neutral_state(robot_))[base].position.y < -1e-6 ? -1 : 1;
  }

  // The product `side` to the left of the robot.
  Pose base_at(double distance, double side) const {
    const double depth = scene_.catalog[scene_.products[product_].sku].depth_m();
    return place_before_shelf(world_from_product_.position, depth, out_, distance, side);
  }

  Result<CollectPlan> at_place(const GraspCandidate& grasp, const Pose& world_from_base) const {
    CollectPlan plan;
    plan.product = product_;
    plan.group = hand_.arm->name;
    plan.tool = hand_.tool;
    plan.grasp = grasp;
    plan.world_from_base = world_from_base;
    const Pose world_from_tip = world_from_product_ * grasp.grasp.product_from_tool;
    plan.state = stowed_state(
        robot_, options_.posture, world_from_tip.position.z - lift_below_m, grasp.grasp.opening_m);
    const PlacedRobot placed{where(), robot_, plan.state, plan.world_from_base};
    MARKETGEN_CHECK(check_standing(scene_, {&placed, 1}));
    const PickPlace place{world_from_base, plan.state, world_from_tip, out_};
    MARKETGEN_TRY(PickWays ways, plan_pick_ways(model_, place, around_, options_, seed_));
    static_cast<PickWays&>(plan) = std::move(ways);
    return plan;
  }

  const Scene& scene_;
  std::uint32_t product_;
  const Robot& robot_;
  Hand hand_;
  Seed seed_;
  const CollectOptions& options_;
  Pose world_from_product_;
  Vec3 out_;  // from the shelf into the aisle
  PickSurroundings around_;
  ArmModel model_;
};

}  // namespace

Result<std::string> gripper_row(const Robot& robot) {
  for (const Tool& tool : robot.tools)
    if (tool.kind == ToolKind::gripper && !hands_with(robot, tool.row).empty()) return tool.row;
  return Error{"robot.unknown", robot.name, "no arm of this robot ends in a gripper"};
}

std::vector<double> stowed_state(const Robot& robot,
                                 const std::string& posture,
                                 double lift_m,
                                 double opening_m) {
  std::vector<double> q = neutral_state(robot);
  const Posture* stow = robot.find_posture(posture);
  if (stow == nullptr && !robot.postures.empty()) stow = &robot.postures.front();
  if (stow != nullptr) q = with_posture(*stow, std::move(q));
  if (const int lift = robot.find_dof("lift"); lift >= 0) {
    const Joint& joint = robot.joint_of_dof(static_cast<std::size_t>(lift));
    q[static_cast<std::size_t>(lift)] = std::clamp(lift_m, joint.lower, joint.upper);
  }
  for (const Tool& tool : robot.tools) {
    const JointGroup* fingers = robot.find_group(tool.prefix + "fingers");
    if (tool.kind != ToolKind::gripper || fingers == nullptr) continue;
    for (const int dof : fingers->dofs) {
      const Joint& joint = robot.joint_of_dof(static_cast<std::size_t>(dof));
      q[static_cast<std::size_t>(dof)] = std::min(opening_m / tool.opening, 1.0) * joint.upper;
    }
  }
  return with_followers(robot, std::move(q));
}

Result<CollectPlan> plan_collect(const Scene& scene,
                                 std::uint32_t product,
                                 const Robot& robot,
                                 const GraspTool& tool,
                                 Seed seed,
                                 const CollectOptions& options) {
  if (product >= scene.products.size())
    return Error{
        "collect.no_product", fmt::format("row {}", product), "the store has no such product"};
  const std::vector<Hand> hands = hands_with(robot, tool.id);
  if (hands.empty())
    return Error{"robot.unknown", robot.name, "no arm of this robot ends in a " + tool.id};
  const Product& goods = scene.catalog[scene.products[product].sku];
  MARKETGEN_TRY(const std::vector<GraspCandidate> grasps, grasps_of(goods, tool, options));
  std::vector<Planner> planners;
  for (const Hand& hand : hands) {
    planners.emplace_back(scene, product, robot, hand, seed, options);
    MARKETGEN_CHECK(planners.back().look_around());
  }
  Error error{"collect.no_place", goods.sku, ""};
  for (const GraspCandidate& grasp : grasps) {
    for (const Planner& planner : planners) {
      interrupt_point();
      auto plan = planner.plan(grasp);
      if (plan.ok()) return plan;
      error = plan.error();
    }
  }
  return error;
}

}  // namespace marketgen
