#include "grasping/grasp_hold.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/goods/contact_shape.h"
#include "physics/soft/soft_pieces.h"

namespace marketgen::grasping {
namespace {

constexpr char hold_where[] = "grasp";
constexpr Vec3 out_of_the_way{3, 0, 1};
constexpr double smoothing = physics::time_step_s / 0.010;  // of forces: a mean over about 10 ms

Vec3 vector_of(const mjtNum* v) {
  return {v[0], v[1], v[2]};
}

double share_of_way(double t) {  // minimum jerk, 0..1
  return t * t * t * (10 + t * (6 * t - 15));
}

int steps_of(double seconds) {
  return std::max(1, static_cast<int>(std::lround(seconds / physics::time_step_s)));
}

}  // namespace

Result<GraspHold> GraspHold::start(const GraspTrial& trial) {
  MARKETGEN_TRY(GraspScene scene, grasp_scene(trial));
  MARKETGEN_TRY(physics::MujocoData data, physics::make_data(*scene.model, hold_where));
  GraspHold hold(trial, std::move(scene), std::move(data));
  hold.put_tool({out_of_the_way, {}});
  return hold;
}

GraspHold::GraspHold(const GraspTrial& trial, GraspScene scene, physics::MujocoData data)
    : trial_(&trial), scene_(std::move(scene)), data_(std::move(data)) {
  const mjModel& m = *scene_.model;
  base_offset_ = vector_of(m.body_pos + 3 * m.body_parentid[scene_.tool_body]);
  neighbour_n_.assign(scene_.products.size(), 0);
  const robots::GraspTool& tool = trial.tool;
  const bool cup = tool.kind == robots::ToolKind::suction;
  const double x = cup ? tool.cup_radius_m : tool.pad_x_m,
               z = cup ? tool.cup_radius_m : tool.pad_z_m;
  slip_points_.push_back(tool.pad_center);
  for (const double i : {-1.0, 1.0}) {
    for (const double k : {-1.0, 1.0})
      slip_points_.push_back(tool.pad_center +
                             (cup ? Vec3{i * x, k * z, 0} : Vec3{i * x, 0, k * z}));
  }
}

void GraspHold::put_tool(const Pose& world_from_tool) {
  position_ = world_from_tool.position;
  rotation_ = world_from_tool.rotation;
  mjtNum* q = scene_.model->body_quat + 4 * scene_.tool_body;
  q[0] = rotation_.w, q[1] = rotation_.x, q[2] = rotation_.y, q[3] = rotation_.z;
}

Result<void> GraspHold::step(Vec3 next_position) {
  mjData& d = *data_;
  const Vec3 at = position_ - base_offset_,
             velocity = (next_position - position_) / physics::time_step_s;
  const double q[3] = {at.x, at.y, at.z}, v[3] = {velocity.x, velocity.y, velocity.z};
  std::copy(q, q + 3, d.qpos + scene_.model->jnt_qposadr[scene_.model->dof_jntid[scene_.base_dof]]);
  std::copy(v, v + 3, d.qvel + scene_.base_dof);
  if (scene_.finger_dof >= 0) {
    const int first = scene_.model->jnt_qposadr[scene_.model->dof_jntid[scene_.finger_dof]];
    for (int finger = 0; finger < 2; ++finger) {
      d.qfrc_applied[scene_.finger_dof + finger] = held_open_m_ >= 0 ? 0 : finger_force_n_;
      if (held_open_m_ < 0) continue;
      d.qpos[first + finger] = held_open_m_ / 2;
      d.qvel[scene_.finger_dof + finger] = 0;
    }
  }
  MARKETGEN_CHECK(physics::guarded(hold_where, [&] { mj_step(scene_.model.get(), data_.get()); }));
  position_ = next_position;
  for (const int warning : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC, mjWARN_CONTACTFULL}) {
    if (d.warning[warning].number > 0)
      return Error{"physics.failed",
                   hold_where,
                   fmt::format("{} in {}: the simulation did not stay finite",
                               trial_->tool.id,
                               trial_->goods.product.sku)};
  }
  look();
  return {};
}

Result<void> GraspHold::wait(double seconds) {
  for (int i = steps_of(seconds); i > 0; --i)
    MARKETGEN_CHECK(step(position_));
  return {};
}

Result<void> GraspHold::move_tool(Vec3 by, double seconds) {
  const Vec3 from = position_;
  const int steps = steps_of(seconds);
  for (int i = 1; i <= steps; ++i)
    MARKETGEN_CHECK(step(from + by * share_of_way(static_cast<double>(i) / steps)));
  return {};
}

Result<void> GraspHold::shake_tool(Vec3 axis, double amplitude_m, double seconds) {
  const Vec3 middle = position_;
  const int steps = steps_of(seconds);
  for (int i = 1; i <= steps; ++i) {
    const double t = std::numbers::pi * i / steps, swell = std::sin(t) * std::sin(t);
    MARKETGEN_CHECK(step(middle + axis * (amplitude_m * swell * std::sin(4 * t))));
  }
  return {};
}

void GraspHold::open_fingers(double opening_m) {
  held_open_m_ = opening_m;
}

Result<void> GraspHold::squeeze(double force_n, double seconds) {
  held_open_m_ = -1;
  const int steps = steps_of(seconds);
  for (int i = 1; i <= steps; ++i) {
    finger_force_n_ = -force_n * std::min(1.0, 2.0 * i / steps);  // full half-way
    MARKETGEN_CHECK(step(position_));
  }
  return {};
}

Result<void> GraspHold::release(double seconds) {
  if (sealed_) physics::let_go(*data_, scene_.lip);
  sealed_ = false;
  marked_ = false;
  const double most = trial_->grasp.opening_m / 2;
  const int first = scene_.finger_dof < 0
                        ? 0
                        : scene_.model->jnt_qposadr[scene_.model->dof_jntid[scene_.finger_dof]];
  for (int i = steps_of(seconds); i > 0; --i) {
    const bool open = scene_.finger_dof >= 0 && data_->qpos[first] < most;
    finger_force_n_ = open ? trial_->grasp.force_n : 0;
    MARKETGEN_CHECK(step(position_));
  }
  return {};
}

bool GraspHold::seal() {
  const mjModel& m = *scene_.model;
  mj_kinematics(&m, data_.get());
  const physics::CupShape cup{trial_->tool.cup_radius_m, trial_->tool.seal_depth_m};
  const auto under = physics::look_under_lip(m, *data_, tool(), cup, scene_.product_geoms);
  const auto of_target = [&](int geom) {
    return scene_.owner_index[static_cast<std::size_t>(geom)] == 0;
  };
  if (!under || !std::ranges::all_of(under->geoms, of_target)) return false;
  const Pose product_from_tool = inverse(product()) * tool();
  for (const int point : scene_.lip)
    physics::hold_point(*scene_.model,
                        *data_,
                        point,
                        scene_.target[0],
                        product_from_tool * physics::place_of_point(m, point));
  sealed_ = true;
  lip_load_ = {};
  return true;
}

void GraspHold::lean_product(Vec3 axis, double angle_rad) {
  const mjModel& m = *scene_.model;
  const Quaternion turned = rotation_about(axis, angle_rad);
  // On its lower edge rather than into the table.
  const double lift = std::sin(std::abs(angle_rad)) *
                      std::max(trial_->goods.product.width_m(), trial_->goods.product.depth_m()) /
                      2;
  const Vec3 at = Vec3{0, 0, lift} + rotate(turned, scene_.target_origin);
  const double pose[7] = {at.x, at.y, at.z, turned.w, turned.x, turned.y, turned.z};
  mjtNum* q = data_->qpos + m.jnt_qposadr[m.body_jntadr[scene_.products[0]]];
  const std::size_t hinges = scene_.target.size() - 1;
  std::copy(pose, pose + 7, q);
  std::fill_n(q + 7, hinges, 0.0);
  std::fill_n(data_->qvel + m.body_dofadr[scene_.products[0]], 6 + hinges, 0.0);
}

void GraspHold::mark() {
  held_part_ = static_cast<int>(std::ranges::max_element(part_n_) - part_n_.begin());
  tool_from_product_ = inverse(tool()) * held();
  marked_ = true;
}

Pose GraspHold::product(std::size_t index) const {
  const mjModel& m = *scene_.model;
  const mjtNum* q = data_->qpos + m.jnt_qposadr[m.body_jntadr[scene_.products[index]]];
  const Pose body{vector_of(q), {q[3], q[4], q[5], q[6]}};
  return index == 0 ? body * Pose{-scene_.target_origin, {}} : body;
}

Pose GraspHold::part(int index) const {
  if (trial_->soft == nullptr) return product();
  const mjModel& m = *scene_.model;
  const mjtNum* q = data_->qpos + m.jnt_qposadr[m.body_jntadr[scene_.products[0]]];
  const Pose middle{scene_.target_origin, {}};
  return product() * middle * physics::bent_part(*trial_->soft, index, {q[7], q[8]}) *
         inverse(middle);
}

int GraspHold::part_near(Vec3 point) const {
  return trial_->soft == nullptr ? 0
                                 : physics::part_at(*trial_->soft, point - scene_.target_origin);
}

double GraspHold::speed(std::size_t index) const {
  return length(vector_of(data_->qvel + scene_.model->body_dofadr[scene_.products[index]]));
}

void GraspHold::look() {
  look_at_contacts();
  if (sealed_) look_at_lip();
  if (marked_) look_at_slip();
}

void GraspHold::look_at_contacts() {
  const mjData& d = *data_;
  std::vector<double> on_neighbour(scene_.products.size(), 0);
  double on_still = 0;
  watch_.pad_n = {};
  part_n_ = {};
  for (int i = 0; i < d.ncon; ++i) {
    const mjContact& contact = d.contact[i];
    if (contact.efc_address < 0) continue;
    mjtNum force[6];
    mj_contactForce(scene_.model.get(), data_.get(), i, force);
    for (int side = 0; side < 2; ++side) {
      const auto a = static_cast<std::size_t>(contact.geom[side]);
      const auto b = static_cast<std::size_t>(contact.geom[1 - side]);
      const GraspOwner owner = scene_.owners[a], other = scene_.owners[b];
      const bool by_tool = other == GraspOwner::tool || other == GraspOwner::pad;
      const auto index = static_cast<std::size_t>(scene_.owner_index[a]);
      const bool target = other == GraspOwner::product && scene_.owner_index[b] == 0;
      if (owner == GraspOwner::product && index > 0 && (by_tool || target))
        on_neighbour[index] += force[0];
      if (owner == GraspOwner::product && index == 0 && other == GraspOwner::pad) {
        watch_.pad_n[static_cast<std::size_t>(scene_.owner_index[b])] += force[0];
        const int part = scene_.model->geom_bodyid[contact.geom[side]] - scene_.target[0];
        part_n_[static_cast<std::size_t>(part)] += force[0];
      }
      if (owner == GraspOwner::still && by_tool) on_still += force[0];
    }
  }
  for (std::size_t i = 0; i < neighbour_n_.size(); ++i) {
    neighbour_n_[i] += smoothing * (on_neighbour[i] - neighbour_n_[i]);
    watch_.neighbour_n = std::max(watch_.neighbour_n, neighbour_n_[i]);
  }
  still_n_ += smoothing * (on_still - still_n_);
  watch_.still_n = std::max(watch_.still_n, still_n_);
}

void GraspHold::look_at_slip() {
  const Pose now = inverse(tool()) * held();
  const Pose moved = now * inverse(tool_from_product_);
  for (const Vec3& point : slip_points_)
    watch_.slip_m = std::max(watch_.slip_m, length(moved * point - point));
  const Quaternion& q = moved.rotation;
  const double turned = 2 * std::atan2(length(Vec3{q.x, q.y, q.z}), std::abs(q.w));
  watch_.turned_rad = std::max(watch_.turned_rad, turned);
}

void GraspHold::look_at_lip() {
  const Vec3 ahead = rotate(rotation_, {0, 0, 1});
  const double pull_n = trial_->grasp.force_n;
  if (!lip_load_.breaks(*data_, scene_.lip, ahead, pull_n, trial_->pad_friction)) return;
  physics::let_go(*data_, scene_.lip);
  sealed_ = false;
}

}  // namespace marketgen::grasping
