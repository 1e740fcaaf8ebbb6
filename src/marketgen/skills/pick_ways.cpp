#include "skills/pick_ways.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace marketgen::skills {
namespace {

constexpr double with_product = 0.25;  // share of the speed

motion::ArmPlanOptions pick_options(const PickMotion& motion, double share) {
  motion::ArmPlanOptions options;
  options.speed = motion.speed * share;
  options.acceleration = motion.acceleration;
  return options;
}

Result<motion::CollisionWorld> world_of(motion::Obstacles obstacles,
                                        const std::vector<motion::BoxObstacle>& carried,
                                        const Pose& world_from_base) {
  for (const motion::BoxObstacle& box : carried_at(carried, world_from_base))
    obstacles.boxes.push_back(box);
  return motion::CollisionWorld::make(obstacles);
}

// Up from the grasp, and out of the shelf.
Result<void> add_way_out(const motion::ArmChecker& line,
                         const PickPlace& place,
                         const Pose& base_from_world,
                         const PickMotion& motion,
                         PickWays& ways) {
  Pose world_from_tip = place.world_from_tip;
  world_from_tip.position.z += motion.lift_m;
  MARKETGEN_TRY(const motion::JointPath rising,
                motion::tool_line(line, ways.reach.line.back(), base_from_world * world_from_tip));
  world_from_tip.position += place.out * motion.retreat_m;
  MARKETGEN_TRY(const motion::JointPath leaving,
                motion::tool_line(line, rising.back(), base_from_world * world_from_tip));
  MARKETGEN_TRY(const auto limits,
                motion::motion_limits(line.model(), pick_options(motion, with_product)));
  MARKETGEN_TRY(ways.lift, motion::timed_curve(rising, limits));
  MARKETGEN_TRY(ways.retreat, motion::timed_curve(leaving, limits));
  return {};
}

// Of the reach's line, whatever stands about: worlds of thousands of measured points are made only
// where there is a posture to try in them. Errors: as plan_reach.
Result<void> can_begin(const motion::ArmModel& model, const motion::ReachQuestion& question) {
  const Pose begin = question.base_from_grasp * Pose{-question.approach, {}};
  const auto postures = motion::arm_goals(*model.robot, model.group, begin, question.start);
  return postures.ok() ? Result<void>() : Result<void>(postures.error());
}

}  // namespace

Result<PickWays> plan_pick_ways(const motion::ArmModel& model,
                                const PickPlace& place,
                                const PickSurroundings& around,
                                const PickMotion& motion,
                                Seed seed) {
  const Pose& base = place.world_from_base;
  const std::vector<Pose> links = robots::link_poses(*model.robot, place.state);
  const Pose base_from_world = inverse(base * links[static_cast<std::size_t>(model.group.base)]);
  motion::ReachQuestion question;
  question.start = robots::values_of(model.group, place.state);
  question.base_from_grasp = base_from_world * place.world_from_tip;
  question.approach = {0, 0, motion.approach_m};
  MARKETGEN_CHECK(can_begin(model, question));
  MARKETGEN_TRY(const motion::CollisionWorld way_world, world_of(around.way, around.carried, base));
  MARKETGEN_TRY(const motion::CollisionWorld line_world,
                world_of(around.line, around.carried, base));
  MARKETGEN_TRY(const motion::ArmChecker way,
                motion::ArmChecker::make(model, place.state, base, way_world));
  MARKETGEN_TRY(const motion::ArmChecker line,
                motion::ArmChecker::make(model, place.state, base, line_world));
  PickWays ways;
  MARKETGEN_TRY(ways.reach, motion::plan_reach(way, line, question, seed, pick_options(motion, 1)));
  MARKETGEN_CHECK(add_way_out(line, place, base_from_world, motion, ways));
  return ways;
}

std::vector<double> raised_state(const robots::Robot& robot,
                                 std::vector<double> driving,
                                 double lift_m,
                                 double opening_m) {
  std::vector<double>& q = driving;
  if (const int lift = robot.find_dof("lift"); lift >= 0) {
    const robots::Joint& joint = robot.joint_of_dof(static_cast<std::size_t>(lift));
    q[static_cast<std::size_t>(lift)] = std::clamp(lift_m, joint.lower, joint.upper);
  }
  for (const robots::Tool& tool : robot.tools) {
    const robots::JointGroup* fingers = robot.find_group(tool.prefix + "fingers");
    if (tool.kind != robots::ToolKind::gripper || fingers == nullptr) continue;
    for (const int dof : fingers->dofs) {
      const robots::Joint& joint = robot.joint_of_dof(static_cast<std::size_t>(dof));
      q[static_cast<std::size_t>(dof)] = std::min(opening_m / tool.opening, 1.0) * joint.upper;
    }
  }
  return robots::with_followers(robot, std::move(q));
}

std::vector<double> stowed_state(const robots::Robot& robot,
                                 const std::string& posture,
                                 double lift_m,
                                 double opening_m) {
  std::vector<double> q = robots::neutral_state(robot);
  const robots::Posture* stow = robot.find_posture(posture);
  if (stow == nullptr && !robot.postures.empty()) stow = &robot.postures.front();
  if (stow != nullptr) q = robots::with_posture(*stow, std::move(q));
  return raised_state(robot, std::move(q), lift_m, opening_m);
}

Pose place_before_shelf(Vec3 product, double depth_m, Vec3 out, double distance_m, double side_m) {
  const Vec3 left{out.y, -out.x, 0};  // of one who looks at the shelf
  Vec3 at = product + out * (distance_m + depth_m / 2) - left * side_m;
  at.z = 0;
  return {at, rotation_about({0, 0, 1}, std::atan2(-out.y, -out.x))};
}

Result<std::vector<Hand>> hands_with(const robots::Robot& robot, const std::string& tool_row) {
  std::vector<Hand> hands;
  for (std::size_t t = 0; t < robot.tools.size(); ++t) {
    if (robot.tools[t].row != tool_row) continue;
    for (const robots::JointGroup& group : robot.groups)
      if (!group.solver.empty() && group.tip == robot.tools[t].frame)
        hands.push_back({&group, static_cast<int>(t)});
  }
  if (hands.empty())
    return Error{
        "robot.unknown", robot.name, fmt::format("no arm of this robot ends in a {}", tool_row)};
  return hands;
}

std::vector<motion::BoxObstacle> carried_at(const std::vector<motion::BoxObstacle>& carried,
                                            const Pose& world_from_base) {
  std::vector<motion::BoxObstacle> boxes = carried;
  for (motion::BoxObstacle& box : boxes)
    box.pose = world_from_base * box.pose;
  return boxes;
}

Result<motion::JointTrajectory> way_back(const robots::Robot& robot,
                                         const std::string& group,
                                         const motion::JointPath& line) {
  MARKETGEN_TRY(const motion::ArmModel model, motion::make_arm_model(robot, group));
  motion::ArmPlanOptions slow;
  slow.speed = carrying_speed / 2;
  slow.acceleration = carrying_acceleration;
  MARKETGEN_TRY(const auto limits, motion::motion_limits(model, slow));
  return motion::timed_curve({line.rbegin(), line.rend()}, limits);
}

}  // namespace marketgen::skills
