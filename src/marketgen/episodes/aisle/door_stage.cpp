#include "episodes/aisle/door_stage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include <fmt/format.h>

#include "episodes/aisle/aisle_stage.h"
#include "episodes/aisle/aisle_world.h"
#include "episodes/proved_names.h"
#include "robots/dexterity.h"
#include "scene/articulation.h"
#include "skills/plan_failure.h"

namespace marketgen::episodes {
namespace {

constexpr double before_bar_m = 0.06;
constexpr FloorPlaceRow max_off{0.01, 0.01, 1};  // from where the door is pulled from
// The arm follows so far when the robot stands as it was planned: some is lost where it stands a
// little off, and by a policy that turns the hand otherwise.
constexpr double followed_rad = 62 * std::numbers::pi / 180;
constexpr double room_worth = 0.2;  // a rad from a limit, as a gain
constexpr double way_back_step_s = 0.05;

// By door the first product behind it that is within reach.
std::map<std::uint32_t, std::uint32_t> goods_behind_doors(const AisleStore& store) {
  std::map<std::uint32_t, std::uint32_t> goods;
  for (std::uint32_t row = 0; row < store.scene.products.size(); ++row) {
    if (store.shelf_refusal(row) != ShelfRefusal::none) continue;
    if (const auto joint = collect::door_before(store.scene, row)) goods.try_emplace(*joint, row);
  }
  return goods;
}

Vec3 tip_of(const robots::Robot& robot,
            const robots::JointGroup& arm,
            const std::vector<double>& state,
            const motion::Configuration& q) {
  return robots::frame_pose(robot, skills::with_arm(arm, state, q), arm.tip).position;
}

// Back from the bar along the way by which the hand comes to it.
motion::Configuration before_the_bar(const robots::Robot& robot,
                                     const robots::JointGroup& arm,
                                     const std::vector<double>& state,
                                     const motion::JointTrajectory& reach) {
  const double end_s = reach.duration_s();
  const Vec3 bar = tip_of(robot, arm, state, reach.at(end_s).position);
  for (double time_s = end_s; time_s > 0; time_s -= way_back_step_s) {
    motion::Configuration q = reach.at(time_s).position;
    if (length(tip_of(robot, arm, state, q) - bar) >= before_bar_m) return q;
  }
  return reach.at(0).position;
}

// How freely the arm moves its tool there: half a radian to the nearest limit is as good as a gain
// of 0.1.
double freedom_of(const robots::Robot& robot,
                  const robots::JointGroup& arm,
                  const std::vector<double>& state) {
  return std::min(robots::min_gain(robot, state, arm.tip, arm.dofs),
                  room_worth * robots::min_room(robot, state, arm.dofs));
}

bool is_about_the_door(const Error& error) {
  return skills::is_of_planning(error) || error.code == "collect.no_door";
}

}  // namespace

DoorStages::DoorStages(const std::shared_ptr<const AisleStore>& store)
    : store_(store), book_(store), goods_(goods_behind_doors(*store)) {}

Result<DoorStages::Ready> DoorStages::ready(std::uint32_t joint) {
  const std::scoped_lock lock(mutex_);
  const auto known = known_.find(joint);
  return known != known_.end() ? known->second
                               : known_.emplace(joint, planned(joint)).first->second;
}

// Opened by a hand whose tool can be moved every way from each posture on its way.
Result<DoorStages::Ready> DoorStages::planned(std::uint32_t joint) const {
  const robots::Robot& robot = store_->robot;
  MARKETGEN_TRY(skills::DoorQuestion question, store_->door_question(store_->scene, joint));
  question.min_pulled_rad = followed_rad;
  question.worth_of_pull = [&robot, &state = question.driving](const robots::JointGroup& arm,
                                                               const motion::JointPath& way) {
    double least = std::numeric_limits<double>::infinity();
    for (const motion::Configuration& q : way)
      least = std::min(least, freedom_of(robot, arm, skills::with_arm(arm, state, q)));
    return least;
  };
  MARKETGEN_TRY(const skills::DoorPull plan,
                skills::plan_pull_door(robot, question, Seed(0).child("pull " + question.where)));
  const skills::HandOnDoor& pull = plan.hand;
  const robots::JointGroup& arm = *robot.find_group(pull.group);
  return Ready{
      pull.group,
      skills::with_arm(arm, plan.state, before_the_bar(robot, arm, plan.state, pull.reach)),
      floor_place_row(plan.world_from_base)};
}

Result<std::optional<EpisodeSpec>> DoorStages::before(std::uint32_t joint,
                                                      EpisodeSpec spec,
                                                      Stream& draw) {
  const std::uint32_t row = goods_.at(joint);
  MARKETGEN_TRY(const OpenDoor open, book_.before(row));
  if (!open.row) return std::optional<EpisodeSpec>{};
  const auto begins = ready(joint);
  if (!begins.ok() && !is_about_the_door(begins.error())) return begins.error();
  if (!begins.ok()) return std::optional<EpisodeSpec>{};
  const auto start = a_little_off(*store_, begins->stand, draw, max_off);
  if (!start) return std::optional<EpisodeSpec>{};
  const catalog::Product& product = store_->scene.catalog[store_->scene.products[row].sku];
  WitnessPick pick;
  pick.sku = product.sku;
  pick.product = scene::product_id(store_->scene, row);
  pick.arm = begins->arm;
  pick.base = begins->stand;
  pick.lift_m = begins->state[static_cast<std::size_t>(store_->robot.find_dof("lift"))];
  pick.door = open.row;
  pick.door->opened_from = begins->stand;
  spec.certificate.witness = {std::move(pick)};
  spec.instruction = fmt::format("Open the door before {}.", spoken_product(product));
  spec.goals = {{product.sku, 1}};
  spec.start = {start->x_m, start->y_m, std::remainder(start->heading_deg, 360)};
  return std::optional(std::move(spec));
}

Result<EpisodeSpec> DoorStages::draw(const EpisodeOrigin& origin, Seed seed) {
  const std::string kind = fmt::format("aisle/{}/open", store_->station.tools().id);
  EpisodeSpec spec = begun_spec(kind, origin, seed, 0, seed);
  spec.track = Track::aisle;
  spec.robot = store_->station.robot;
  spec.tools = store_->station.tools().id;
  spec.doors = Doors::hinged;
  spec.cameras = {aisle_cameras.begin(), aisle_cameras.end()};
  spec.limit_s = stage_limit_s;
  spec.certificate.proved.assign(shown_before_a_door.begin(), shown_before_a_door.end());
  std::vector<std::uint32_t> doors;
  for (const auto& [joint, row] : goods_)
    doors.push_back(joint);
  Stream draw = seed.child("door_stage").stream();
  draw.shuffle(std::span(doors));
  for (const std::uint32_t joint : doors) {
    MARKETGEN_TRY(std::optional<EpisodeSpec> made, before(joint, spec, draw));
    if (made) return *std::move(made);
  }
  return Error{"episode.impossible",
               spec.id,
               "the store has no door on a hinge, with goods behind it, that the robot opens"};
}

Result<std::uint32_t> witnessed_door(const AisleStore& store, const EpisodeSpec& spec) {
  MARKETGEN_TRY(const WitnessPick pick, witness_of(spec));
  const scene::Scene& scene = store.scene;
  for (std::uint32_t joint = 0; pick.door && joint < scene.joints.size(); ++joint)
    if (scene::joint_id(scene, scene.joints[joint]) == pick.door->id) return joint;
  return Error{"episode.impossible",
               spec.id,
               pick.door
                   ? fmt::format("its witness opens \"{}\", which is no door here", pick.door->id)
                   : "its witness opens no door"};
}

Result<std::vector<double>> DoorStages::hand_before_bar(const EpisodeSpec& spec) {
  MARKETGEN_TRY(const std::uint32_t joint, witnessed_door(*store_, spec));
  MARKETGEN_TRY(const Ready begins, ready(joint));
  return begins.state;
}

Result<DoorSeen> door_seen(const AisleWorld& world) {
  const AisleStore& store = world.store();
  MARKETGEN_TRY(const std::uint32_t joint, witnessed_door(store, world.spec()));
  MARKETGEN_TRY(const skills::HingedDoor door, collect::known_door(store.scene, joint));
  DoorSeen seen;
  seen.arm = world.spec().certificate.witness.front().arm;
  const robots::JointGroup* const arm = store.robot.find_group(seen.arm);
  if (arm == nullptr)
    return Error{"episode.impossible", world.spec().id, "its witness has no arm of the robot"};
  seen.position_rad = world.world().joint_position(joint);
  seen.asked_rad = opened_rad;
  seen.speed_rad_s = world.world().joint_velocity(joint);
  const double height = (door.bar.low_m + door.bar.high_m) / 2;
  const Vec3 bar = door.point_at(seen.position_rad, door.bar.along_m, door.bar.out_m, height);
  const Pose tool = robots::frame_pose(store.robot, world.robot_state(), arm->tip);
  const Pose base_from_world = inverse(world.world_from_base());
  seen.side = -door.turn();
  seen.tool = base_from_world * tool.position;
  seen.to_bar = base_from_world * bar - seen.tool;
  const Vec3 points = rotate(tool.rotation, {0, 0, 1}),
             into = rotate(door.turned(seen.position_rad), door.out * -1.0);
  seen.behind_rad =
      door.turn() * std::remainder(std::atan2(into.y, into.x) - std::atan2(points.y, points.x),
                                   2 * std::numbers::pi);
  const Vec3 push = rotate(base_from_world.rotation, into);
  seen.into_rad = std::atan2(push.y, push.x);
  seen.held = world.watch().is_joint_held(world.world(), joint);
  seen.clean = is_clean(world.side_effects());
  return seen;
}

}  // namespace marketgen::episodes
