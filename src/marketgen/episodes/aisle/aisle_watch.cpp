#include "episodes/aisle/aisle_watch.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "episodes/goal_judge.h"
#include "physics/goods/contact_shape.h"

namespace marketgen::episodes {
namespace {

constexpr std::string_view basket_prefix = "basket/";

std::uint64_t key_of(const physics::ContactSide& side) {
  return (static_cast<std::uint64_t>(side.kind) << 32U) | side.row;
}

}  // namespace

AisleWatch::GeomRole AisleWatch::role_of(const robots::Robot& robot, std::string_view link) {
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

AisleWatch::AisleWatch(const physics::World& world, const robots::Robot& robot) {
  const mjModel& m = world.model();
  roles_.resize(static_cast<std::size_t>(m.ngeom));
  for (int geom = 0; geom < m.ngeom; ++geom) {
    const char* name = mj_id2name(&m, mjOBJ_GEOM, geom);
    const char* body = mj_id2name(&m, mjOBJ_BODY, m.geom_bodyid[geom]);
    GeomRole& role = roles_[static_cast<std::size_t>(geom)];
    if (name != nullptr && std::string_view(name).starts_with(basket_prefix))
      role.part = Part::basket;
    else if (body != nullptr)
      role = role_of(robot, body);
  }
}

bool AisleWatch::is_held(std::uint32_t product) const {
  const auto item = items_.find(product);
  return item != items_.end() && item->second.held_by >= 0;
}

// What was taken, on the basket or on the deck on which that stands.
bool AisleWatch::lies_in_basket(std::uint32_t geom, std::uint32_t product) const {
  const Part part = roles_[geom].part;
  const auto item = items_.find(product);
  return (part == Part::basket || part == Part::base) && item != items_.end() &&
         item->second.was_held;
}

// What the robot, or what it holds, presses on. Not what it holds itself, nor what lies in its
// basket.
void AisleWatch::add_push(const physics::WorldContact& contact, Touches& seen) const {
  for (const auto& [a, b] : {std::pair{contact.a, contact.b}, {contact.b, contact.a}}) {
    const bool robot = a.kind == physics::BodyKind::actor;
    if (!robot && !(a.kind == physics::BodyKind::product && is_held(a.row))) continue;
    if (robot && b.kind == physics::BodyKind::product && lies_in_basket(a.row, b.row)) continue;
    if (b.kind == physics::BodyKind::product && is_held(b.row)) continue;
    if (b.kind == physics::BodyKind::actor && !robot) continue;  // in the hand, or over the basket
    const bool still = b.kind == physics::BodyKind::room || b.kind == physics::BodyKind::fixture;
    if (robot && roles_[a.row].part == Part::base && b.kind == physics::BodyKind::fixture)
      seen.base_hit = seen.base_hit || contact.normal_n > 0;
    seen.force_n[still ? key_of({b.kind, 0}) : key_of(b)] += contact.normal_n;
    if (b.kind == physics::BodyKind::actor) return;  // on itself: once
  }
}

AisleWatch::Touches AisleWatch::touches(const physics::World& world) const {
  Touches seen;
  for (const physics::WorldContact& contact : world.contacts()) {
    if (contact.normal_n <= 0) continue;
    add_push(contact, seen);
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

void AisleWatch::follow_item(std::uint32_t product,
                             Item& item,
                             const physics::World& world,
                             const BaseMotion& base) {
  const physics::ProductMotion motion = world.product_motion(product);
  const Vec3 arm = motion.pose.position - base.axle;
  const Vec3 carried =
      base.velocity_m_s + Vec3{-arm.y * base.turn_rad_s, arm.x * base.turn_rad_s, 0};
  item.speed_m_s = length(motion.velocity_m_s - carried);
  item.rested_s = item.speed_m_s < rest_m_s ? item.rested_s + physics::time_step_s : 0;
}

// What was taken is let down with the arm; it is dropped when it falls hard (look()).
void AisleWatch::follow_events(physics::World& world) {
  for (const physics::WorldEvent& event : world.take_events()) {
    const auto item = items_.find(event.product);
    const bool taken = item != items_.end() && item->second.was_held;
    if (event.kind == physics::EventKind::dropped && !taken) dropped_.insert(event.product);
    if (event.kind == physics::EventKind::toppled && !taken) toppled_.insert(event.product);
    if (event.kind == physics::EventKind::displaced && !taken) displaced_.insert(event.product);
  }
}

void AisleWatch::find_holder(Item& item,
                             const std::set<std::pair<int, int>>& fingers,
                             int sealed_by) const {
  item.touched_by = item.held_by = -1;
  for (const auto& [tool, finger] : fingers) {
    item.touched_by = tool;
    if (fingers.contains({tool, 1 - finger})) item.held_by = tool;
  }
  if (sealed_by >= 0) item.touched_by = item.held_by = sealed_by;
}

void AisleWatch::look(physics::World& world,
                      const BaseMotion& base,
                      std::span<const std::optional<std::uint32_t>> sealed) {
  const Touches seen = touches(world);
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
    if (item.was_held && item.impact_m_s > max_impact_m_s) dropped_.insert(product);
    follow_item(product, item, world, base);
  }
  pushes_.follow(seen.force_n, physics::time_step_s);
  base_collisions_ += seen.base_hit && !base_touches_ ? 1 : 0;
  base_touches_ = seen.base_hit;
  follow_events(world);
}

SideEffects AisleWatch::effects() const {
  SideEffects effects;
  pushes_.add_to(effects);
  effects.toppled = static_cast<int>(toppled_.size());
  effects.dropped = static_cast<int>(dropped_.size());
  effects.displaced = static_cast<int>(displaced_.size());
  effects.base_collisions = base_collisions_;
  return effects;
}

}  // namespace marketgen::episodes
