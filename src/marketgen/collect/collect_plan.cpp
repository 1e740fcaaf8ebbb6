#include "collect/collect_plan.h"

#include <fmt/format.h>

#include "collect/scene_obstacles.h"
#include "collect/standing_robot.h"
#include "skills/shelf_pick.h"

namespace marketgen::collect {
namespace {

constexpr double reach_m = 1.3;       // obstacles farther from the product are of no account
constexpr double push_aside_m = 0.2;  // neighbours within it may be pushed by the fingers

Result<std::vector<motion::GraspCandidate>> grasps_of(const catalog::Product& goods,
                                                      const robots::GraspTool& tool,
                                                      const CollectOptions& options) {
  if (!options.grasps.empty()) return options.grasps;
  MARKETGEN_TRY(const auto body, assets::product_body(goods));
  motion::GraspQuery query;
  query.friction = options.fingers_friction;
  query.from_front = true;
  MARKETGEN_TRY(motion::GraspCandidates grasps,
                motion::grasp_candidates(goods, *body, tool, query));
  if (grasps.found.empty()) return Error{"motion.no_grasp", goods.sku, grasps.reason};
  return std::move(grasps.found);
}

// The product itself and what stands so near to it.
std::vector<std::uint32_t> neighbours(const GoodsNow& goods, Vec3 middle) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t row = 0; row < goods.scene().products.size(); ++row)
    if (length(goods.pose(row).position - middle) < push_aside_m) rows.push_back(row);
  return rows;
}

Result<skills::PickSurroundings> surroundings_of(const GoodsNow& goods,
                                                 Vec3 middle,
                                                 const std::vector<motion::BoxObstacle>& carried) {
  skills::PickSurroundings around;
  around.way = around.line = fixture_obstacles(goods, middle, reach_m);
  around.carried = carried;
  MARKETGEN_CHECK(add_product_obstacles(goods, middle, reach_m, {}, around.way));
  MARKETGEN_CHECK(
      add_product_obstacles(goods, middle, reach_m, neighbours(goods, middle), around.line));
  return around;
}

Result<skills::ShelfPickQuestion> pick_question(const GoodsNow& goods,
                                                std::uint32_t product,
                                                const robots::Robot& robot,
                                                const CollectOptions& options) {
  const scene::Scene& scene = goods.scene();
  skills::ShelfPickQuestion question;
  static_cast<skills::PickMotion&>(question) = static_cast<const skills::PickMotion&>(options);
  question.where = scene::product_id(scene, product);
  question.world_from_product = goods.pose(product);
  question.depth_m = scene.catalog[scene.products[product].sku].depth_m();
  question.driving = skills::stowed_state(robot, options.posture, 0, 0);
  question.world_from_base = options.world_from_base;
  MARKETGEN_TRY(question.around,
                surroundings_of(goods, question.world_from_product.position, options.carried));
  question.may_stand = [&scene, &robot, &options, where = question.where](
                           const Pose& world_from_base,
                           const std::vector<double>& state) -> Result<void> {
    const robots::PlacedRobot placed{where, robot, state, world_from_base};
    MARKETGEN_CHECK(check_standing(scene, {&placed, 1}));
    return options.may_stand ? options.may_stand(world_from_base, state) : Result<void>();
  };
  return question;
}

}  // namespace

Result<std::string> gripper_row(const robots::Robot& robot) {
  for (const robots::Tool& tool : robot.tools)
    if (tool.kind == robots::ToolKind::gripper && skills::hands_with(robot, tool.row).ok())
      return tool.row;
  return Error{"robot.unknown", robot.name, "no arm of this robot ends in a gripper"};
}

Result<CollectPlan> plan_collect(const GoodsNow& goods,
                                 std::uint32_t product,
                                 const robots::Robot& robot,
                                 const robots::GraspTool& tool,
                                 Seed seed,
                                 const CollectOptions& options) {
  const scene::Scene& scene = goods.scene();
  if (product >= scene.products.size())
    return Error{
        "collect.no_product", fmt::format("row {}", product), "the store has no such product"};
  MARKETGEN_CHECK(skills::hands_with(robot, tool.id));
  const catalog::Product& row = scene.catalog[scene.products[product].sku];
  MARKETGEN_TRY(const std::vector<motion::GraspCandidate> grasps, grasps_of(row, tool, options));
  MARKETGEN_TRY(skills::ShelfPickQuestion question, pick_question(goods, product, robot, options));
  question.tool_row = tool.id;
  for (const motion::GraspCandidate& grasp : grasps)
    question.grasps.push_back(grasp.grasp);
  MARKETGEN_TRY(skills::ShelfPick pick, skills::plan_shelf_pick(robot, question, seed));
  CollectPlan plan;
  static_cast<skills::PickWays&>(plan) = std::move(static_cast<skills::PickWays&>(pick));
  plan.product = product;
  plan.group = pick.group;
  plan.tool = pick.tool;
  plan.world_from_base = pick.world_from_base;
  plan.state = std::move(pick.state);
  plan.grasp = grasps[pick.number];
  return plan;
}

}  // namespace marketgen::collect
