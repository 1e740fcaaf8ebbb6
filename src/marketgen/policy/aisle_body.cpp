#include "policy/aisle_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "skills/people_about.h"

namespace marketgen::policy {
namespace {

constexpr double around_m = 1.4;  // what is farther from the robot does not count
constexpr double beside_m = 0.12, over_board_m = 0.02, max_behind_m = 0.2, faced_m = 0.02;
constexpr std::size_t min_strays = 8, stray_share = 15;  // of measured points, one in so many
constexpr double walls_m = 0.35;                         // of a product, what its grasps keep off
constexpr double shoulder_height_m = 0.9;
constexpr double let_go_wider_by_m = 0.02;  // than what was held
constexpr double pressed_aside_m = 0.2;     // what is so near to a product gives way to fingers
constexpr double point_radius_m = 0.006;    // of a measured point
constexpr double min_held_m = 0.004;        // between fingers that hold something
// A base that believes to be where it is not comes to stand some centimetres and a degree off; the
// arm then reaches by another height of its lift.
constexpr std::array standing_lifts_m{0.0, -0.05, 0.05, -0.10, 0.10, -0.15, 0.15, -0.20, 0.20};
constexpr int way_back_points = 16;
// What is let go so high over the basket's floor may roll off what it lies on, and arrives with
// 0.9 m/s; so often another place is sought.
constexpr double max_let_go_m = 0.04;
constexpr double over_rim_m = 0.02;
constexpr std::size_t max_met = 3;
constexpr double max_leave_m = 0.30, leave_step_m = 0.04;

std::vector<Vec3f> near(const std::vector<Vec3f>& points, Vec3 middle, double within_m) {
  std::vector<Vec3f> kept;
  std::ranges::copy_if(points, std::back_inserter(kept), [&](Vec3f p) {
    return length(to_double(p) - middle) < within_m;
  });
  return kept;
}

std::vector<Vec3f> beyond(const std::vector<Vec3f>& points, Vec3 middle, double from_m) {
  std::vector<Vec3f> kept;
  std::ranges::copy_if(points, std::back_inserter(kept), [&](Vec3f p) {
    return length(to_double(p) - middle) >= from_m;
  });
  return kept;
}

// How far what was measured beside it stands out before a product's front: packs that are left of
// the row before it. Strays do not count, nor does what is faced a little farther.
double stands_behind_m(const PickTarget& item, const std::vector<Vec3f>& points) {
  const catalog::Product& product = item.known->product;
  const Pose product_from_store = inverse(item.store_from_product);
  std::vector<double> ahead;
  for (const Vec3f& point : points) {
    const Vec3 at = product_from_store * to_double(point);
    const double before = -at.y - product.depth_m() / 2;
    if (std::abs(at.x) < product.width_m() / 2 + beside_m && at.z > over_board_m &&
        at.z < product.height_m() && std::abs(before) < max_behind_m)
      ahead.push_back(before);
  }
  const std::size_t strays = std::max(min_strays, ahead.size() / stray_share);
  if (ahead.size() <= strays) return 0;
  std::ranges::nth_element(
      ahead, ahead.begin() + static_cast<std::ptrdiff_t>(strays), std::greater<>());
  return ahead[strays] > faced_m ? ahead[strays] : 0;
}

void add_cloud(std::vector<Vec3f> points, motion::Obstacles& obstacles) {
  if (!points.empty()) obstacles.clouds.push_back({std::move(points), point_radius_m});
}

}  // namespace

AisleBody::AisleBody(AisleBodySetup setup, Seed seed)
    : setup_(std::move(setup)), seed_(seed), executor_(*setup_.robot, setup_.commanded) {}

void AisleBody::start(const agent::Observation& now) {
  now_ = now;
  executor_.start(now);
}

Seed AisleBody::next_seed() {
  return seed_.child("move", moves_++);
}

std::vector<double> AisleBody::state() const {
  const robots::Robot& robot = *setup_.robot;
  std::vector<double> q = setup_.driving;
  const auto set = [&](int dof, double value) {
    const robots::Joint& joint = robot.joint_of_dof(static_cast<std::size_t>(dof));
    q[static_cast<std::size_t>(dof)] = std::clamp(value, joint.lower, joint.upper);
  };
  for (std::size_t i = 0; i < setup_.commanded.size(); ++i)
    set(setup_.commanded[i], now_.position[i]);
  for (std::size_t t = 0; t < robot.tools.size(); ++t) {
    const robots::JointGroup* fingers = robot.find_group(robot.tools[t].prefix + "fingers");
    for (const int dof : fingers == nullptr ? std::vector<int>{} : fingers->dofs)
      set(dof, now_.openings_m[t] / 2);
  }
  return robots::with_followers(robot, std::move(q));
}

motion::Configuration AisleBody::stowed_arm(const std::string& group) const {
  return robots::values_of(*setup_.robot->find_group(group), setup_.driving);
}

bool AisleBody::holds_it() const {
  return executor_.presses(pick_.tool) &&
         now_.openings_m[static_cast<std::size_t>(pick_.tool)] > min_held_m;
}

motion::Obstacles AisleBody::around(const std::vector<Vec3f>& points) const {
  const Vec3 middle{now_.base.x_m, now_.base.y_m, shoulder_height_m};
  motion::Obstacles obstacles = setup_.map->fixtures(middle, around_m);
  add_cloud(near(points, middle, around_m), obstacles);
  return obstacles;
}

std::vector<motion::GraspObstacle> AisleBody::walls_about(const Pose& store_from_product) const {
  std::vector<motion::GraspObstacle> walls;
  const Pose product_from_store = inverse(store_from_product);
  for (const motion::BoxObstacle& box :
       setup_.map->fixtures(store_from_product.position, walls_m).boxes)
    walls.push_back({product_from_store * box.pose, box.half_size});
  return walls;
}

Result<void> AisleBody::drive_to(const robots::BasePlace& place) {
  MARKETGEN_TRY(motion::BaseFollower way, setup_.map->way(now_.base, place));
  executor_.drive(std::move(way));
  goes_to_ = place;
  waited_ = false;
  looks_there_.reset();
  return {};
}

Result<void> AisleBody::make_way() {
  MARKETGEN_TRY(motion::WayRound way,
                setup_.map->way_round(now_.base, goes_to_, skills::people_about(now_), waited_));
  waited_ = way.wait_s > 0 && !waited_;  // what was in vain is not tried twice running
  executor_.drive(std::move(way));
  return looks_there_ ? executor_.look(looks_there_->first, looks_there_->second) : Result<void>{};
}

Result<void> AisleBody::look(double pan, double tilt) {
  looks_there_ = {pan, tilt};
  return executor_.look(pan, tilt);
}

Result<void> AisleBody::may_stand(const robots::BasePlace& place) const {
  if (setup_.map->has_room(place) && setup_.map->way_m(now_.base, place)) return {};
  return Error{"motion.base_blocked", setup_.robot->name, "the base has no room or no way there"};
}

// Into the basket as it is filled now, wherever the robot stands.
Result<void> AisleBody::may_hold(const assets::ProductBody& body,
                                 const skills::ShelfPick& pick) const {
  skills::DropQuestion question;
  question.group = pick.group;
  question.stow = stowed_arm(pick.group);
  question.inside = inside_;
  question.tool = pick.tool;
  question.held = &body;
  question.tip_from_product = inverse(pick.grasp.product_from_tool);
  const std::vector<int>& arm = setup_.robot->find_group(pick.group)->dofs;
  const motion::Configuration out = pick.retreat.at(pick.retreat.duration_s()).position;
  Result<void> last;
  for (const double lift : skills::drop_lifts_m) {
    question.state = pick.state;
    for (std::size_t i = 0; i < arm.size(); ++i)
      question.state[static_cast<std::size_t>(arm[i])] = out[i];
    question.state[static_cast<std::size_t>(setup_.robot->find_dof("lift"))] = lift;
    const auto plan =
        skills::plan_drop(*setup_.robot, setup_.basket, question, seed_.child("hold", moves_));
    if (plan.ok()) return {};
    last = plan.error();
  }
  return last;
}

Result<skills::ShelfPick> AisleBody::plan_pick(const PickTarget& item,
                                               const std::vector<Vec3f>& points,
                                               std::optional<robots::BasePlace> from) {
  const Vec3 middle = item.store_from_product.position;
  skills::ShelfPickQuestion question;
  question.world_from_product = item.store_from_product;
  question.depth_m = item.known->product.depth_m();
  question.grasps = item.grasps;
  question.tool_row = item.tool_row;
  question.driving = setup_.driving;
  question.around.carried = setup_.basket.walls;
  question.around.line = question.around.way = setup_.map->fixtures(middle, around_m);
  const std::vector<Vec3f> seen = near(points, middle, around_m);
  add_cloud(seen, question.around.way);
  add_cloud(beyond(seen, middle, pressed_aside_m), question.around.line);
  question.where = item.known->product.sku;
  MARKETGEN_TRY(const assets::ProductBody body, skills::make_store_body(item.known->product));
  question.may_hold = [&](const skills::ShelfPick& pick) { return may_hold(body, pick); };
  if (from) {
    question.world_from_base = agent::store_from_base(*from);
    question.lift_offsets_m.assign(standing_lifts_m.begin(), standing_lifts_m.end());
  } else {
    question.may_stand = [&](const Pose& base, const std::vector<double>&) {
      return may_stand(agent::base_place(base));
    };
  }
  const double behind = stands_behind_m(item, seen);
  question.approach_m += behind;
  question.retreat_m += behind;
  question.speed = skills::carrying_speed;
  question.acceleration = skills::carrying_acceleration;
  return skills::plan_shelf_pick(*setup_.robot, question, next_seed());
}

Result<void> AisleBody::take(const PickTarget& item, skills::ShelfPick pick) {
  MARKETGEN_TRY(carried_, skills::make_store_body(item.known->product));
  put_n_ = skills::putting_force_n(item.known->product);
  met_.clear();
  anywhere_ = false;
  pick_ = std::move(pick);
  return executor_.take(
      {.ways = static_cast<const skills::PickWays&>(pick_),
       .group = pick_.group,
       .tool = pick_.tool,
       .lift_m = pick_.state[static_cast<std::size_t>(setup_.robot->find_dof("lift"))],
       .open = {pick_.grasp.opening_m},
       .close = {0, pick_.grasp.force_n}});
}

Result<void> AisleBody::pull_out() {
  if (holds_it()) {
    executor_.pull_out();
    return {};
  }
  return executor_.go_back();
}

double AisleBody::room_behind_m() const {
  for (double back = max_leave_m; back > leave_step_m / 2; back -= leave_step_m)
    if (setup_.map->has_room(
            agent::base_place(agent::store_from_base(now_.base) * Pose{{-back, 0, 0}, {}})))
      return back;
  return 0;
}

Result<void> AisleBody::back_off() {
  MARKETGEN_CHECK(executor_.back_off(room_behind_m()));
  lift_tried_ = 0;
  if (!holds_it()) return {};
  return executor_.raise(skills::drop_lifts_m[lift_tried_], agent::Subtask::place);
}

skills::StowQuestion AisleBody::stow_question(const std::vector<Vec3f>& points) const {
  return {.state = state(),
          .world_from_base = agent::store_from_base(now_.base),
          .group = pick_.group,
          .around = around(points),
          .stow = stowed_arm(pick_.group),
          .inside = inside_};
}

Result<bool> AisleBody::drop(const std::vector<Vec3f>& points) {
  skills::DropQuestion question;
  static_cast<skills::StowQuestion&>(question) = stow_question(points);
  question.inside.insert(question.inside.end(), met_.begin(), met_.end());
  question.tool = pick_.tool;
  question.held = &carried_;
  question.tip_from_product = inverse(pick_.grasp.product_from_tool);
  auto goes = let_down(question);
  if (!goes.ok() && !met_.empty()) {
    met_.clear();
    anywhere_ = true;
    question.inside = inside_;
    goes = let_down(question);
  }
  if (goes.ok()) return true;
  const bool last = ++lift_tried_ >= skills::drop_lifts_m.size();
  if (last) lift_tried_ = 0;
  MARKETGEN_CHECK(executor_.raise(skills::drop_lifts_m[lift_tried_], agent::Subtask::place));
  if (last) return goes.error();
  return false;
}

agent::ToolCommand AisleBody::letting_go() const {
  return {now_.openings_m[static_cast<std::size_t>(pick_.tool)] + let_go_wider_by_m,
          pick_.grasp.force_n};
}

Result<void> AisleBody::let_down(const skills::DropQuestion& question) {
  down_ = {};
  if (now_.external_force_n.empty()) {
    MARKETGEN_TRY(skills::DropPlan plan,
                  skills::plan_drop(*setup_.robot, setup_.basket, question, next_seed()));
    let_go_ = plan.base_from_tip;
    executor_.let_down(std::move(plan), letting_go());
    return {};
  }
  MARKETGEN_TRY(skills::FeltDrop plan,
                skills::plan_felt_drop(*setup_.robot, setup_.basket, question, next_seed()));
  down_ = plan.down;
  executor_.let_down(std::move(plan), put_n_);
  return {};
}

// Base frame.
skills::TurnedBox AisleBody::box_where_it_is() const {
  const robots::Robot& robot = *setup_.robot;
  const int frame = robot.tools[static_cast<std::size_t>(pick_.tool)].frame;
  const Pose tip = is_felt() ? robots::frame_pose(robot, state(), frame) : let_go_;
  return skills::turned_box(carried_, tip * inverse(pick_.grasp.product_from_tool));
}

Result<bool> AisleBody::lowered() {
  const skills::TurnedBox box = box_where_it_is();
  const double floor_m = setup_.basket.base_from_floor.position.z;
  const double over_m = box.middle.z - box.half.z - floor_m;
  if (is_felt() && over_m > max_let_go_m && !anywhere_ && met_.size() < max_met) {
    met_.push_back(skills::carried_box({{box.middle.x, box.middle.y, floor_m + over_m / 2},
                                        {box.half.x, box.half.y, over_m / 2}}));
    MARKETGEN_TRY(motion::JointTrajectory up, way_up());
    executor_.take_up(std::move(up));
    return false;
  }
  if (is_felt()) executor_.let_go(letting_go());
  inside_.push_back(skills::carried_box(box));
  return true;
}

Result<void> AisleBody::leave_basket(const std::vector<Vec3f>& points) {
  if (!is_felt()) return {};
  auto plan =
      skills::plan_basket_exit(*setup_.robot, setup_.basket, stow_question(points), next_seed());
  if (!plan.ok()) return go_home_from_above(points);
  executor_.leave_basket(std::move(*plan));
  return {};
}

Result<void> AisleBody::rise(const std::vector<Vec3f>& points) {
  if (!is_felt()) return {};
  const skills::TurnedBox box = box_where_it_is();
  const double up_m = setup_.basket.base_from_floor.position.z + setup_.basket.size.z + over_rim_m -
                      (box.middle.z - box.half.z);
  if (up_m <= 0) return {};
  MARKETGEN_TRY(motion::JointTrajectory up,
                skills::plan_rise(*setup_.robot, setup_.basket, stow_question(points), up_m));
  executor_.take_up(std::move(up));
  return {};
}

// Out of the basket, the way that it came.
Result<motion::JointTrajectory> AisleBody::way_up() const {
  const double end_s = down_.duration_s() * executor_.felt_share();
  motion::JointPath line;
  for (int i = 0; i <= way_back_points; ++i)
    line.push_back(down_.at(end_s * i / way_back_points).position);
  return skills::way_back(*setup_.robot, pick_.group, line);
}

Result<void> AisleBody::go_home_from_above(const std::vector<Vec3f>& points) {
  MARKETGEN_TRY(motion::JointTrajectory up, way_up());
  skills::StowQuestion question = stow_question(points);
  const std::vector<int>& arm = setup_.robot->find_group(pick_.group)->dofs;
  const motion::Configuration above = down_.at(0).position;
  for (std::size_t i = 0; i < arm.size(); ++i)
    question.state[static_cast<std::size_t>(arm[i])] = above[i];
  MARKETGEN_TRY(motion::JointTrajectory home,
                skills::plan_stow(*setup_.robot, setup_.basket, question, next_seed()));
  executor_.leave_basket({std::move(up), std::move(home)});
  return {};
}

Result<void> AisleBody::go_home(const std::vector<Vec3f>& points) {
  MARKETGEN_TRY(
      motion::JointTrajectory way,
      skills::plan_stow(*setup_.robot, setup_.basket, stow_question(points), next_seed()));
  executor_.stow(std::move(way));
  return {};
}

}  // namespace marketgen::policy
