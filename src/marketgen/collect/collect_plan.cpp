#include "collect/collect_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

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

// An arm that ends in a gripper.
struct Hand {
  const JointGroup* arm = nullptr;
  int tool = -1;
};

// All of them end in the same gripper.
Result<std::vector<Hand>> hands_of(const Robot& robot) {
  std::vector<Hand> hands;
  for (std::size_t t = 0; t < robot.tools.size(); ++t) {
    const Tool& tool = robot.tools[t];
    if (tool.kind != ToolKind::gripper) continue;
    for (const JointGroup& group : robot.groups) {
      const bool same =
          hands.empty() || robot.tools[static_cast<std::size_t>(hands[0].tool)].row == tool.row;
      if (!group.solver.empty() && group.tip == tool.frame && same)
        hands.push_back({&group, static_cast<int>(t)});
    }
  }
  if (hands.empty())
    return Error{"robot.unknown", robot.name, "no arm of this robot ends in a gripper"};
  return hands;
}

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

Pose lifted(Pose pose, Vec3 by) {
  pose.position += by;
  return pose;
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
    Obstacles still = fixture_obstacles(scene_, middle, reach_m);
    Obstacles way = still, line = std::move(still);
    MARKETGEN_CHECK(add_product_obstacles(scene_, middle, reach_m, {}, way));
    MARKETGEN_CHECK(add_product_obstacles(scene_, middle, reach_m, neighbours(), line));
    way_ = std::move(way), line_ = std::move(line);
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

  Result<CollisionWorld> around(Obstacles obstacles, const Pose& world_from_base) const {
    for (const BoxObstacle& box : carried_at(options_.carried, world_from_base))
      obstacles.boxes.push_back(box);
    return CollisionWorld::make(obstacles);
  }

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

  // Facing the shelf, the product `side` to the left of the robot.
  Pose base_at(double distance, double side) const {
    const Vec3 left{out_.y, -out_.x, 0};  // of one who looks at the shelf
    const Product& product = scene_.catalog[scene_.products[product_].sku];
    Vec3 at =
        world_from_product_.position + out_ * (distance + product.depth_m() / 2) - left * side;
    at.z = 0;
    return {at, rotation_about({0, 0, 1}, std::atan2(-out_.y, -out_.x))};
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
    MARKETGEN_TRY(const CollisionWorld way_world, around(way_, world_from_base));
    MARKETGEN_TRY(const CollisionWorld line_world, around(line_, world_from_base));
    MARKETGEN_TRY(const ArmChecker way,
                  ArmChecker::make(model_, plan.state, plan.world_from_base, way_world));
    MARKETGEN_TRY(const ArmChecker line,
                  ArmChecker::make(model_, plan.state, plan.world_from_base, line_world));
    const Pose base_from_world =
        inverse(plan.world_from_base *
                link_poses(robot_, plan.state)[static_cast<std::size_t>(model_.group.base)]);
    ReachQuestion question;
    for (const int dof : model_.group.dofs)
      question.start.push_back(plan.state[static_cast<std::size_t>(dof)]);
    question.base_from_grasp = base_from_world * world_from_tip;
    question.approach = {0, 0, options_.approach_m};
    ArmPlanOptions arm;
    arm.speed = options_.speed;
    arm.acceleration = options_.acceleration;
    MARKETGEN_TRY(plan.reach, plan_reach(way, line, question, seed_, arm));
    return with_way_out(std::move(plan), line, base_from_world, world_from_tip);
  }

  Result<CollectPlan> with_way_out(CollectPlan plan,
                                   const ArmChecker& line,
                                   const Pose& base_from_world,
                                   const Pose& world_from_tip) const {
    const Pose up = lifted(world_from_tip, {0, 0, options_.lift_m});
    const Pose out = lifted(up, out_ * options_.retreat_m);
    MARKETGEN_TRY(const JointPath rising,
                  tool_line(line, plan.reach.line.back(), base_from_world * up));
    MARKETGEN_TRY(const JointPath leaving, tool_line(line, rising.back(), base_from_world * out));
    ArmPlanOptions slow;
    slow.speed = options_.speed * 0.25;
    slow.acceleration = options_.acceleration;
    MARKETGEN_TRY(const auto limits, motion_limits(model_, slow));
    MARKETGEN_TRY(plan.lift, timed_curve(rising, limits));
    MARKETGEN_TRY(plan.retreat, timed_curve(leaving, limits));
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
  Obstacles way_, line_;
  ArmModel model_;
};

}  // namespace

Result<std::string> gripper_row(const Robot& robot) {
  MARKETGEN_TRY(const std::vector<Hand> hands, hands_of(robot));
  return robot.tools[static_cast<std::size_t>(hands.front().tool)].row;
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

std::vector<BoxObstacle> carried_at(const std::vector<BoxObstacle>& carried,
                                    const Pose& world_from_base) {
  std::vector<BoxObstacle> boxes = carried;
  for (BoxObstacle& box : boxes)
    box.pose = world_from_base * box.pose;
  return boxes;
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
  MARKETGEN_TRY(const std::vector<Hand> hands, hands_of(robot));
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
      auto plan = planner.plan(grasp);
      if (plan.ok()) return plan;
      error = plan.error();
    }
  }
  return error;
}

}  // namespace marketgen
