#include "physics/settle/pour.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/goods/contact_shape.h"

namespace marketgen::physics {
namespace {

constexpr int never = std::numeric_limits<int>::max();

}  // namespace

// By Shoemake's rule without its sines: four normal numbers made a unit.
Quaternion any_rotation(Stream& draw) {
  const double w = draw.normal(), x = draw.normal(), y = draw.normal(), z = draw.normal();
  const double norm = std::sqrt(w * w + x * x + y * y + z * z);
  if (norm < 1e-3) return {};
  return {w / norm, x / norm, y / norm, z / norm};
}

Pour::Pour(const mjModel& model,
           mjData& data,
           std::vector<PouredBody> bodies,
           const PourRules& rules)
    : model_(model), data_(data), bodies_(std::move(bodies)), rules_(rules) {
  for (const PouredBody& body : bodies_)
    last_turn_ = std::max(last_turn_, body.turn);
}

bool Pour::over() const {
  if (steps_ >= static_cast<int>(rules_.longest_s / time_step_s)) return true;
  return turn_ == last_turn_ && data_.time > turn_began_s_ + rules_.settle_s && rests();
}

Result<void> Pour::step(const std::string& where) {
  MARKETGEN_CHECK(guarded(where, [&] { mj_step(&model_, &data_); }));
  ++steps_;
  if (data_.warning[mjWARN_BADQACC].number > 0)
    return Error{"physics.failed", where, "what is poured flies apart"};
  begin_turns();
  hold();
  still_steps_ = fastest() < rules_.rest_m_s ? still_steps_ + 1 : 0;
  return {};
}

void Pour::begin_turns() {
  if (turn_ == last_turn_) return;
  if (data_.time >= turn_began_s_ + rules_.max_pause_s) {
    turn_began_s_ += rules_.max_pause_s;
  } else if (data_.time >= turn_began_s_ + rules_.min_pause_s && rests()) {
    turn_began_s_ = data_.time;
  } else {
    return;
  }
  ++turn_;
  still_steps_ = 0;
}

void Pour::take_away(std::size_t body) {
  bodies_[body].turn = never;
}

void Pour::hold() const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (poured(i)) continue;
    const int q = model_.jnt_qposadr[i], v = model_.jnt_dofadr[i];
    std::copy(model_.qpos0 + q, model_.qpos0 + q + 7, data_.qpos + q);
    std::fill(data_.qvel + v, data_.qvel + v + 6, 0);
  }
}

double Pour::fastest() const {
  double speed = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!poured(i)) continue;
    const mjtNum* v = data_.qvel + model_.jnt_dofadr[i];
    const double turning = std::sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5]);
    speed = std::max(
        {speed, std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]), turning * bodies_[i].radius_m});
  }
  return speed;
}

}  // namespace marketgen::physics
