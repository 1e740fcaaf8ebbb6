#include "episodes/checkout/checkout_watch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/goods/contact_shape.h"

namespace marketgen::episodes {
namespace {

constexpr double toppled_rad = std::numbers::pi / 4;
constexpr double stands_after_s = 0.3;
constexpr double in_basket_m = 0.03;  // lower than this over the counter only goods outside lie

double degrees(double rad) {
  return rad * 180 / std::numbers::pi;
}

double angle_between(const Quaternion& a, const Quaternion& b) {
  const Quaternion turn = inverse(a) * b;
  return 2 * std::atan2(std::hypot(turn.x, turn.y, turn.z), std::abs(turn.w));
}

}  // namespace

Pose body_pose(const mjData& data, int body) {
  const mjtNum *p = data.xpos + 3 * body, *q = data.xquat + 4 * body;
  return {{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}};
}

CheckoutWatch::CheckoutWatch(const CheckoutModel& model, const mjData& data)
    : items_(model.items.size()) {
  const Pose basket = body_pose(data, model.basket);
  for (std::size_t i = 0; i < items_.size(); ++i) {
    items_[i].first = inverse(basket) * body_pose(data, model.items[i]);
    items_[i].met = true;
  }
}

CheckoutWatch::Touches CheckoutWatch::touches(const CheckoutModel& model,
                                              const mjData& data) const {
  const std::size_t count = items_.size();
  Touches seen{std::vector<std::array<bool, 2>>(count), std::vector<bool>(count), {}};
  const auto row = [&](int geom) {
    const CheckoutOwner owner = model.owners[static_cast<std::size_t>(geom)];
    if (owner == CheckoutOwner::item)
      return static_cast<std::size_t>(model.owner_index[static_cast<std::size_t>(geom)]);
    return owner == CheckoutOwner::basket ? count : count + 1;
  };
  const auto is_arm = [&](int geom) {
    const CheckoutOwner owner = model.owners[static_cast<std::size_t>(geom)];
    return owner == CheckoutOwner::arm || owner == CheckoutOwner::finger;
  };
  const auto is_held = [&](int geom) {
    return model.owners[static_cast<std::size_t>(geom)] == CheckoutOwner::item &&
           items_[row(geom)].held;
  };
  for (int c = 0; c < data.ncon; ++c) {
    const mjContact& contact = data.contact[c];
    if (contact.efc_address < 0) continue;
    for (const auto& [a, b] : {std::pair{contact.geom[0], contact.geom[1]},
                               std::pair{contact.geom[1], contact.geom[0]}}) {
      const auto owner = model.owners[static_cast<std::size_t>(a)];
      if (row(b) < count && owner == CheckoutOwner::finger)
        seen.fingers[row(b)]
                    [static_cast<std::size_t>(model.owner_index[static_cast<std::size_t>(a)])] =
            true;
      if (row(b) < count && !is_arm(a)) seen.met[row(b)] = true;
      if (is_arm(b) || is_held(b) || (!is_arm(a) && !is_held(a))) continue;
      mjtNum force[6];
      mj_contactForce(model.model.get(), &data, c, force);
      seen.force_n[row(b)] += force[0];
    }
  }
  return seen;
}

void CheckoutWatch::follow_item(std::size_t index, const CheckoutModel& model, const mjData& data) {
  Item& item = items_[index];
  const int body = model.items[index];
  mjtNum velocity[6];
  mj_objectVelocity(model.model.get(), &data, mjOBJ_BODY, body, velocity, 0);
  item.speed_m_s = std::hypot(velocity[3], velocity[4], velocity[5]);
  item.rested_s = item.speed_m_s < rest_m_s ? item.rested_s + physics::time_step_s : 0;
  if (item.held) item.stood.reset();
  const Pose pose = body_pose(data, body);
  const bool outside = data.xipos[3 * body + 2] < in_basket_m ||
                       length(pose.position - body_pose(data, model.basket).position) > 0.3;
  if (!item.stood && outside && !item.touched && item.rested_s > stands_after_s)
    item.stood = pose.rotation;
  if (item.stood && angle_between(*item.stood, pose.rotation) > toppled_rad) item.toppled = true;
}

void CheckoutWatch::look(const CheckoutModel& model, const mjData& data) {
  const Touches seen = touches(model, data);
  for (std::size_t i = 0; i < items_.size(); ++i) {
    Item& item = items_[i];
    const bool flew = !item.met && !item.touched;
    if (flew && seen.met[i]) item.impact_m_s = std::max(item.impact_m_s, item.speed_m_s);
    item.dropped = item.dropped || item.impact_m_s > max_impact_m_s;
    item.touched = seen.fingers[i][0] || seen.fingers[i][1];
    item.held = seen.fingers[i][0] && seen.fingers[i][1];
    item.met = seen.met[i];
    if (item.held) item.impact_m_s = 0;
    follow_item(i, model, data);
  }
  pushes_.follow(seen.force_n, physics::time_step_s);
  const Vec3 up = rotate(body_pose(data, model.basket).rotation, {0, 0, 1});
  tilt_deg_ = std::max(tilt_deg_, degrees(std::atan2(std::hypot(up.x, up.y), up.z)));
}

SideEffects CheckoutWatch::effects() const {
  SideEffects effects;
  pushes_.add_to(effects);
  for (const Item& item : items_) {
    effects.toppled += item.toppled ? 1 : 0;
    effects.dropped += item.dropped ? 1 : 0;
  }
  effects.basket_tilt_deg = tilt_deg_;
  return effects;
}

}  // namespace marketgen::episodes
