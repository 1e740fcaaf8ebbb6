#include "episodes/episode_watch.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "episodes/goal_judge.h"
#include "physics/goods/contact_shape.h"

namespace marketgen::episodes {
namespace {

constexpr std::string_view basket_prefix = "basket/";

constexpr double toppled_rad = std::numbers::pi / 4;
constexpr double stands_after_s = 0.3;

double angle_between(const Quaternion& a, const Quaternion& b) {
  const Quaternion turn = inverse(a) * b;
  return 2 * std::atan2(std::hypot(turn.x, turn.y, turn.z), std::abs(turn.w));
}

double lean_deg(const Pose& pose) {
  const Vec3 up = rotate(pose.rotation, {0, 0, 1});
  return std::atan2(std::hypot(up.x, up.y), up.z) * 180 / std::numbers::pi;
}

}  // namespace

EpisodeWatch::GeomRole EpisodeWatch::role_of(const robots::Robot& robot, std::string_view link) {
  for (std::size_t t = 0; t < robot.tools.size(); ++t) {
    const int tool = static_cast<int>(t);
    if (robot.tools[t].kind == robots::ToolKind::suction) {
      const robots::RobotFrame& lip = robot.frames[static_cast<std::size_t>(robot.tools[t].frame)];
      if (robot.links[static_cast<std::size_t>(lip.link)].name == link)
        return {Part::finger, tool, 0};
    }
    const robots::JointGroup* fingers = robot.find_group(robot.tools[t].prefix + "fingers");
    if (fingers == nullptr) continue;
    for (std::size_t f = 0; f < fingers->dofs.size(); ++f) {
      const robots::Joint& joint = robot.joint_of_dof(static_cast<std::size_t>(fingers->dofs[f]));
      if (robot.links[static_cast<std::size_t>(joint.link)].name == link)
        return {Part::finger, tool, static_cast<int>(f)};
    }
  }
  return {link == "base" ? Part::base : Part::body};
}

EpisodeWatch::EpisodeWatch(const physics::World& world,
                           const robots::Robot& robot,
                           const std::vector<std::uint32_t>& loose) {
  const mjModel& m = world.model();
  roles_.resize(static_cast<std::size_t>(m.ngeom));
  for (int geom = 0; geom < m.ngeom; ++geom) {
    const char* name = mj_id2name(&m, mjOBJ_GEOM, geom);
    const char* body = mj_id2name(&m, mjOBJ_BODY, m.geom_bodyid[geom]);
    GeomRole& role = roles_[static_cast<std::size_t>(geom)];
    if (name != nullptr && std::string_view(name).starts_with(basket_prefix))
      role.part = Part::basket;
    else if (body != nullptr && std::string_view(body).starts_with(person_prefix))
      role.part = Part::person;
    else if (body != nullptr)
      role = role_of(robot, body);
    role.of_robot = body != nullptr &&
                    std::ranges::find(robot.links, body, &robots::Link::name) != robot.links.end();
    role.body = static_cast<std::uint32_t>(m.geom_bodyid[geom]);
  }
  for (const std::uint32_t product : loose)
    items_[product].loose = true;
}

bool EpisodeWatch::is_robot(const physics::ContactSide& side) const {
  return side.kind == physics::BodyKind::actor && roles_[side.row].of_robot;
}

std::uint64_t EpisodeWatch::key_of(const physics::ContactSide& side) const {
  std::uint32_t row = side.row;
  if (side.kind == physics::BodyKind::room || side.kind == physics::BodyKind::fixture) row = 0;
  if (side.kind == physics::BodyKind::actor && !is_robot(side)) row = roles_[side.row].body;
  return (static_cast<std::uint64_t>(side.kind) << 32U) | row;
}

physics::ContactSide EpisodeWatch::pushed_by(const Push& push) {
  return {static_cast<physics::BodyKind>(push.thing >> 32U),
          static_cast<std::uint32_t>(push.thing)};
}

bool EpisodeWatch::is_held(std::uint32_t product) const {
  const auto item = items_.find(product);
  return item != items_.end() && item->second.held_by >= 0;
}

// What was taken, on the basket or on the deck on which that stands.
bool EpisodeWatch::lies_in_basket(std::uint32_t geom, std::uint32_t product) const {
  const Part part = roles_[geom].part;
  const auto item = items_.find(product);
  return (part == Part::basket || part == Part::base) && item != items_.end() &&
         item->second.was_held;
}

// What the robot, or what it holds, presses on. Not what it holds itself, nor what lies in the
// basket that it carries.
void EpisodeWatch::add_push(const physics::WorldContact& contact, Touches& seen) const {
  for (const auto& [a, b] : {std::pair{contact.a, contact.b}, {contact.b, contact.a}}) {
    const bool robot = is_robot(a);
    if (!robot && !(a.kind == physics::BodyKind::product && is_held(a.row))) continue;
    if (robot && b.kind == physics::BodyKind::product && lies_in_basket(a.row, b.row)) continue;
    if (b.kind == physics::BodyKind::product && is_held(b.row)) continue;
    if (is_robot(b) && !robot) continue;  // in the hand, or over the basket
    if (robot && roles_[a.row].part == Part::base && b.kind == physics::BodyKind::fixture)
      seen.base_hit = seen.base_hit || contact.normal_n > 0;
    if (b.kind == physics::BodyKind::actor && roles_[b.row].part == Part::person)
      seen.people_n[static_cast<std::uint64_t>(roles_[b.row].body)] += contact.normal_n;
    seen.force_n[key_of(b)] += contact.normal_n;
    if (is_robot(b)) return;  // on itself: once
  }
}

std::int32_t EpisodeWatch::joint_of(const physics::ContactSide& side) const {
  return side.kind == physics::BodyKind::fixture && side.row < joints_.size() ? joints_[side.row]
                                                                              : -1;
}

std::map<std::int32_t, EpisodeWatch::Fingers> EpisodeWatch::fingers_on_joints(
    const physics::World& world) const {
  std::map<std::int32_t, Fingers> on_joints;
  if (joints_.empty()) return on_joints;
  for (const physics::WorldContact& contact : world.contacts()) {
    const std::int32_t joint = joint_of(contact.a);  // a fixture's kind is before an actor's
    if (joint < 0 || contact.normal_n <= 0 || !is_robot(contact.b)) continue;
    const GeomRole& role = roles_[contact.b.row];
    if (role.part == Part::finger) on_joints[joint].insert({role.tool, role.finger});
  }
  return on_joints;
}

bool EpisodeWatch::holds_joint(const physics::WorldContact& contact,
                               const std::map<std::int32_t, Fingers>& on_joints) const {
  const auto fingers = on_joints.find(joint_of(contact.a));
  if (fingers == on_joints.end() || !is_robot(contact.b)) return false;
  const GeomRole& role = roles_[contact.b.row];
  return role.part == Part::finger && fingers->second.contains({role.tool, 1 - role.finger});
}

bool EpisodeWatch::is_joint_held(const physics::World& world, std::uint32_t joint) const {
  const auto on_joints = fingers_on_joints(world);
  const auto fingers = on_joints.find(static_cast<std::int32_t>(joint));
  return fingers != on_joints.end() &&
         std::ranges::any_of(fingers->second, [&](const std::pair<int, int>& one) {
           return fingers->second.contains({one.first, 1 - one.second});
         });
}

EpisodeWatch::Touches EpisodeWatch::touches(const physics::World& world) const {
  Touches seen;
  const std::map<std::int32_t, Fingers> on_joints = fingers_on_joints(world);
  for (const physics::WorldContact& contact : world.contacts()) {
    if (contact.normal_n <= 0) continue;
    if (!holds_joint(contact, on_joints)) add_push(contact, seen);
    for (const auto& [a, b] : {std::pair{contact.a, contact.b}, {contact.b, contact.a}}) {
      if (b.kind != physics::BodyKind::product) continue;
      const GeomRole role = a.kind == physics::BodyKind::actor ? roles_[a.row] : GeomRole{};
      if (role.part == Part::finger) {
        seen.fingers[b.row].insert({role.tool, role.finger});
        continue;
      }
      seen.met.insert(b.row);
      if (role.part == Part::basket) seen.basket.insert(b.row);
    }
  }
  return seen;
}

void EpisodeWatch::follow_item(std::uint32_t product,
                               Item& item,
                               const physics::World& world,
                               const Moment& moment) {
  const physics::ProductMotion motion = world.product_motion(product);
  const Vec3 arm = motion.pose.position - moment.axle;
  const Vec3 carried =
      moment.base_velocity_m_s + Vec3{-arm.y * moment.turn_rad_s, arm.x * moment.turn_rad_s, 0};
  item.speed_m_s = length(motion.velocity_m_s - carried);
  item.rested_s = item.speed_m_s < rest_m_s ? item.rested_s + physics::time_step_s : 0;
  if (item.loose) follow_standing(product, item, motion.pose.rotation, moment);
}

void EpisodeWatch::follow_standing(std::uint32_t product,
                                   Item& item,
                                   const Quaternion& now,
                                   const Moment& moment) {
  if (item.held_by >= 0) item.stood.reset();
  const bool rests = item.touched_by < 0 && item.rested_s > stands_after_s;
  if (!item.stood && rests && moment.is_outside(product)) item.stood = now;
  if (item.stood && angle_between(*item.stood, now) > toppled_rad) toppled_.insert(product);
}

// What was taken is let down with the arm, and what lies loose slides as its neighbours are taken:
// they are dropped when they fall hard (look()), and have toppled when they stood.
void EpisodeWatch::follow_events(physics::World& world) {
  for (const physics::WorldEvent& event : world.take_events()) {
    const auto item = items_.find(event.product);
    const bool taken = item != items_.end() && (item->second.was_held || item->second.loose);
    if (event.kind == physics::EventKind::dropped && !taken) dropped_.insert(event.product);
    if (event.kind == physics::EventKind::toppled && !taken) toppled_.insert(event.product);
    if (event.kind == physics::EventKind::displaced && !taken) displaced_.insert(event.product);
  }
}

void EpisodeWatch::find_holder(Item& item,
                               const std::set<std::pair<int, int>>& fingers,
                               int sealed_by) const {
  item.touched_by = item.held_by = -1;
  for (const auto& [tool, finger] : fingers) {
    item.touched_by = tool;
    if (fingers.contains({tool, 1 - finger})) item.held_by = tool;
  }
  if (sealed_by >= 0) item.touched_by = item.held_by = sealed_by;
}

void EpisodeWatch::look(physics::World& world, const Moment& moment) {
  const Touches seen = touches(world);
  const auto& sealed = moment.sealed;
  std::map<std::uint32_t, int> sealed_by;
  for (std::size_t tool = 0; tool < sealed.size(); ++tool) {
    if (!sealed[tool]) continue;
    sealed_by.emplace(*sealed[tool], static_cast<int>(tool));
    items_.try_emplace(*sealed[tool]);
  }
  for (const auto& [product, fingers] : seen.fingers)
    items_.try_emplace(product);
  for (const std::uint32_t product : seen.basket)
    items_.try_emplace(product);
  for (auto& [product, item] : items_) {
    const bool flew = !item.met && item.touched_by < 0, meets = seen.met.contains(product);
    if (flew && meets) item.impact_m_s = std::max(item.impact_m_s, item.speed_m_s);
    const auto fingers = seen.fingers.find(product);
    const auto cup = sealed_by.find(product);
    find_holder(item,
                fingers == seen.fingers.end() ? std::set<std::pair<int, int>>{} : fingers->second,
                cup == sealed_by.end() ? -1 : cup->second);
    item.met = meets;
    item.was_held = item.was_held || item.held_by >= 0;
    if (item.held_by >= 0) item.impact_m_s = 0;
    if ((item.was_held || item.loose) && item.impact_m_s > max_impact_m_s) dropped_.insert(product);
    follow_item(product, item, world, moment);
  }
  pushes_.follow(seen.force_n, physics::time_step_s);
  base_collisions_ += seen.base_hit && !base_touches_ ? 1 : 0;
  base_touches_ = seen.base_hit;
  look_at_people(seen);
  tilt_deg_ = std::max(tilt_deg_, lean_deg(moment.world_from_basket));
  follow_events(world);
}

void EpisodeWatch::look_at_people(const Touches& seen) {
  person_pushes_.follow(seen.people_n, physics::time_step_s);
  std::set<std::uint64_t> touched;
  for (const auto& [body, force_n] : seen.people_n) {
    person_contacts_ += touched_people_.contains(body) ? 0 : 1;
    touched.insert(body);
  }
  touched_people_ = std::move(touched);
}

double EpisodeWatch::person_hardest_n() const {
  SideEffects effects;
  person_pushes_.add_to(effects);
  return effects.hardest_n;
}

SideEffects EpisodeWatch::effects() const {
  SideEffects effects;
  pushes_.add_to(effects);
  effects.toppled = static_cast<int>(toppled_.size());
  effects.dropped = static_cast<int>(dropped_.size());
  effects.displaced = static_cast<int>(displaced_.size());
  effects.base_collisions = base_collisions_;
  effects.basket_tilt_deg = tilt_deg_;
  return effects;
}

}  // namespace marketgen::episodes
