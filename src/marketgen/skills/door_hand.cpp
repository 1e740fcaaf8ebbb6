#include "skills/door_hand.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "motion/plan_arm.h"
#include "robots/numeric_ik.h"

namespace marketgen::skills {
namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double step_rad = 0.05;               // of the door, between two postures
constexpr double farthest_rad = 0.35;           // that a joint moves in one of them
constexpr int swivels = 12;                     // of the elbow
constexpr std::size_t max_postures = 24;        // at the beginning
constexpr std::array offs_m{0.10, 0.06, 0.04};  // straight off the leaf: an arm that is folded has
                                                // no room for more
constexpr double leaf_margin_m = 0.004;
constexpr double free_speed = 0.5, door_speed = 0.12, door_acceleration = 0.25;

std::vector<int> finger_links(const robots::Robot& robot, const Hand& hand) {
  std::vector<int> links;
  const robots::Tool& tool = robot.tools[static_cast<std::size_t>(hand.tool)];
  if (const robots::JointGroup* fingers = robot.find_group(tool.prefix + "fingers"))
    for (const int dof : fingers->dofs)
      links.push_back(robot.joint_of_dof(static_cast<std::size_t>(dof)).link);
  return links;
}

motion::ArmPlanOptions free_options() {
  motion::ArmPlanOptions options;
  options.speed = free_speed;
  options.acceleration = door_acceleration;
  return options;
}

Result<motion::JointTrajectory> backwards(const motion::ArmModel& model,
                                          const motion::LeavePlan& plan) {
  const motion::JointPath way(plan.way.rbegin(), plan.way.rend()),
      line(plan.line.rbegin(), plan.line.rend());
  motion::ArmPlanOptions slow = free_options();
  MARKETGEN_TRY(const auto limits, motion::motion_limits(model, slow));
  slow.speed = door_speed;
  MARKETGEN_TRY(const auto slow_limits, motion::motion_limits(model, slow));
  MARKETGEN_TRY(motion::JointTrajectory made, motion::timed_path(way, limits));
  MARKETGEN_TRY(const motion::JointTrajectory last, motion::timed_curve(line, slow_limits));
  made.append(last);
  return made;
}

}  // namespace

std::vector<double> with_arm(const robots::JointGroup& arm,
                             std::vector<double> state,
                             const motion::Configuration& q) {
  for (std::size_t j = 0; j < arm.dofs.size(); ++j)
    state[static_cast<std::size_t>(arm.dofs[j])] = q[j];
  return state;
}

bool is_clear_of_leaf(const robots::Robot& robot,
                      const std::vector<double>& state,
                      const Pose& world_from_base,
                      const HingedDoor& door,
                      double position_rad,
                      const std::vector<int>& without) {
  const auto leaf = motion::CollisionWorld::make(door.leaf_at(position_rad));
  if (!leaf.ok()) return false;
  const std::vector<Pose> links = robots::link_poses(robot, state);
  for (std::size_t link = 0; link < links.size(); ++link) {
    if (std::ranges::count(without, static_cast<int>(link)) > 0) continue;
    for (const robots::Sphere& sphere : robot.links[link].spheres) {
      const Vec3 at = world_from_base * links[link] * sphere.center;
      const double radius = sphere.radius + leaf_margin_m;
      const std::vector<motion::SphereBlock> block =
          motion::packed(std::vector<motion::PlainSphere>{{at, radius}});
      if (leaf->hits(block, to_float(at), static_cast<float>(radius))) return false;
    }
  }
  return true;
}

Result<DoorHand> DoorHand::make(const robots::Robot& robot,
                                const HingedDoor& door,
                                const Hand& hand) {
  DoorHand made;
  made.robot_ = &robot;
  made.door_ = &door;
  made.hand_ = hand;
  MARKETGEN_TRY(made.model_, motion::make_arm_model(robot, hand.arm->name));
  made.fingers_ = finger_links(robot, hand);
  return made;
}

// The arm's next posture on its way with the leaf: near to the last one and free.
std::optional<motion::Configuration> DoorHand::next_posture(
    const DoorStand& stand,
    const motion::ArmChecker& checker,
    const Pose& world_from_tip,
    const motion::Configuration& last) const {
  const robots::JointGroup& arm = model_.group;
  robots::NumericIkOptions descent;
  descent.restarts = 0;
  const auto next = robots::solve_numeric(*robot_,
                                          arm.tip,
                                          arm.dofs,
                                          inverse(stand.world_from_base) * world_from_tip,
                                          with_arm(arm, stand.state, last),
                                          Seed(0),
                                          descent);
  if (!next.ok()) return std::nullopt;
  const motion::Configuration q = robots::values_of(arm, *next);
  double farthest = 0;
  for (std::size_t j = 0; j < q.size(); ++j)
    farthest = std::max(farthest, std::abs(q[j] - last[j]));
  if (farthest > farthest_rad || !checker.motion_free(last, q, 2 * checker.margin_m()))
    return std::nullopt;
  return q;
}

// As far as the arm follows the leaf from a posture.
DoorHand::Followed DoorHand::follow(const DoorStand& stand,
                                    const motion::ArmChecker& checker,
                                    const HandSwing& swing,
                                    const motion::Configuration& start) const {
  Followed followed{{start}, swing.from_rad};
  const double way = swing.to_rad - swing.from_rad;
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(way) / step_rad)));
  const auto clear = [&](const motion::Configuration& q, double position) {
    return is_clear_of_leaf(*robot_,
                            with_arm(model_.group, stand.state, q),
                            stand.world_from_base,
                            *door_,
                            position,
                            fingers_);
  };
  if (!checker.free(start) || !clear(start, swing.from_rad)) return followed;
  for (int i = 1; i <= steps; ++i) {
    const double position = swing.from_rad + way * i / steps;
    const auto q =
        next_posture(stand, checker, swing.world_from_tip(position), followed.path.back());
    if (!q || !clear(*q, position)) return followed;
    followed.path.push_back(*q);
    followed.end_rad = position;
  }
  return followed;
}

// The most worth first, then those from which the arm does not follow far enough.
std::vector<motion::Configuration> DoorHand::by_worth(
    const DoorStand& stand,
    const motion::ArmChecker& checker,
    const HandSwing& swing,
    std::vector<motion::Configuration> starts) const {
  std::vector<std::pair<double, motion::Configuration>> worths;
  for (motion::Configuration& start : starts) {
    const Followed followed = follow(stand, checker, swing, start);
    const bool will_do = std::abs(followed.end_rad - swing.from_rad) >= swing.min_rad - 1e-9;
    worths.emplace_back(
        will_do ? swing.worth(model_.group, followed.path) : std::numeric_limits<double>::lowest(),
        std::move(start));
  }
  std::ranges::stable_sort(worths, std::greater<>(), [](const auto& row) { return row.first; });
  starts.clear();
  for (auto& [worth, start] : worths)
    starts.push_back(std::move(start));
  return starts;
}

// From the leaf where it is to where the arm is stowed: the fingers may touch the leaf on the line.
Result<motion::LeavePlan> DoorHand::off_it(const DoorStand& stand,
                                           const motion::CollisionWorld& still,
                                           const motion::Configuration& at,
                                           double position_rad,
                                           Seed seed) const {
  motion::Obstacles all = stand.around;
  const motion::Obstacles leaf = door_->leaf_at(position_rad);
  all.boxes.insert(all.boxes.end(), leaf.boxes.begin(), leaf.boxes.end());
  all.cylinders.insert(all.cylinders.end(), leaf.cylinders.begin(), leaf.cylinders.end());
  MARKETGEN_TRY(const motion::CollisionWorld world, motion::CollisionWorld::make(all));
  motion::ArmCheckOptions at_work;
  at_work.at_work = fingers_;
  at_work.their_world = &still;
  MARKETGEN_TRY(
      const motion::ArmChecker line,
      motion::ArmChecker::make(model_, stand.state, stand.world_from_base, world, at_work));
  MARKETGEN_TRY(const motion::ArmChecker way,
                motion::ArmChecker::make(model_, stand.state, stand.world_from_base, world));
  const std::vector<Pose> links = robots::link_poses(*robot_, stand.state);
  const Pose tip =
      robots::frame_pose(*robot_, with_arm(model_.group, stand.state, at), model_.group.tip);
  motion::LeaveQuestion question;
  question.grasp = at;
  question.goals = {robots::values_of(model_.group, stand.state)};
  Error error;
  for (const double off_m : offs_m) {
    question.base_from_clear = inverse(links[static_cast<std::size_t>(model_.group.base)]) * tip *
                               Pose{{0, 0, -off_m}, {}};
    auto made = motion::plan_leave(line, way, question, seed, free_options());
    if (made.ok()) return made;
    error = made.error();
  }
  return error;
}

Result<HandOnDoor> DoorHand::timed(const DoorStand& stand,
                                   const motion::CollisionWorld& still,
                                   const HandSwing& swing,
                                   const Followed& followed,
                                   Seed seed) const {
  HandOnDoor made;
  made.group = model_.group.name;
  made.tool = hand_.tool;
  made.end_rad = followed.end_rad;
  if (swing.worth) made.worth = swing.worth(model_.group, followed.path);
  made.at_start = followed.path.front();
  made.at_end = followed.path.back();
  DoorStand before = stand;
  if (!stand.at_reach.empty()) before.state = stand.at_reach;
  MARKETGEN_TRY(
      const motion::LeavePlan there,
      off_it(before, still, followed.path.front(), swing.from_rad, seed.child("to the door")));
  MARKETGEN_TRY(
      const motion::LeavePlan back,
      off_it(stand, still, followed.path.back(), followed.end_rad, seed.child("off the door")));
  MARKETGEN_TRY(made.reach, backwards(model_, there));
  made.leave = back.trajectory;
  motion::ArmPlanOptions slow;
  slow.speed = door_speed;
  slow.acceleration = door_acceleration;
  MARKETGEN_TRY(const auto limits, motion::motion_limits(model_, slow));
  MARKETGEN_TRY(made.swing, motion::timed_curve(followed.path, limits));
  return made;
}

Result<motion::JointTrajectory> DoorHand::leave(const DoorStand& stand,
                                                const motion::Configuration& at,
                                                double position_rad,
                                                Seed seed) const {
  MARKETGEN_TRY(const motion::CollisionWorld still, motion::CollisionWorld::make(stand.around));
  MARKETGEN_TRY(const motion::LeavePlan plan, off_it(stand, still, at, position_rad, seed));
  return plan.trajectory;
}

Result<HandOnDoor> DoorHand::plan(const DoorStand& stand, const HandSwing& swing, Seed seed) const {
  MARKETGEN_TRY(const motion::CollisionWorld still, motion::CollisionWorld::make(stand.around));
  MARKETGEN_TRY(const motion::ArmChecker checker,
                motion::ArmChecker::make(model_, stand.state, stand.world_from_base, still));
  const std::vector<Pose> links = robots::link_poses(*robot_, stand.state);
  const Pose base_from_world =
      inverse(stand.world_from_base * links[static_cast<std::size_t>(model_.group.base)]);
  MARKETGEN_TRY(std::vector<motion::Configuration> starts,
                motion::arm_goals(*robot_,
                                  model_.group,
                                  base_from_world * swing.world_from_tip(swing.from_rad),
                                  robots::values_of(model_.group, stand.state),
                                  swivels));
  if (starts.size() > max_postures) starts.resize(max_postures);
  if (swing.worth) starts = by_worth(stand, checker, swing, std::move(starts));
  Error error{"robot.unreachable", model_.group.name, "the arm cannot follow the door"};
  double farthest = -1;
  for (const motion::Configuration& start : starts) {
    Followed followed = follow(stand, checker, swing, start);
    const double share = std::abs(followed.end_rad - swing.from_rad);
    if (share < swing.min_rad - 1e-9) {
      if (share <= farthest) continue;
      farthest = share;
      error.message = fmt::format("the arm follows the door by {:.0f} of {:.0f} degrees",
                                  share * degrees,
                                  std::abs(swing.to_rad - swing.from_rad) * degrees);
      continue;
    }
    auto made = timed(stand, still, swing, followed, seed);
    if (made.ok()) return made;
    error = made.error();
  }
  return error;
}

}  // namespace marketgen::skills
