#include "motion/arm_checker.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "motion/lanes.h"

namespace marketgen::motion {
namespace {

// frame * (rotation, position), which are the same in every lane.
LaneFrame moved(const LaneFrame& frame,
                const std::array<float, 9>& rotation,
                const std::array<float, 3>& position) {
  LaneFrame out;
  for (std::size_t i = 0; i < 3; ++i) {
    const Lanes &x = frame.r[3 * i], &y = frame.r[3 * i + 1], &z = frame.r[3 * i + 2];
    for (std::size_t k = 0; k < 3; ++k)
      out.r[3 * i + k] = x * rotation[k] + y * rotation[3 + k] + z * rotation[6 + k];
    out.p[i] = x * position[0] + y * position[1] + z * position[2] + frame.p[i];
  }
  return out;
}

LaneFrame standing(const std::array<float, 9>& rotation, const std::array<float, 3>& position) {
  LaneFrame out;
  for (std::size_t i = 0; i < 9; ++i)
    out.r[i] = Lanes(rotation[i]);
  for (std::size_t i = 0; i < 3; ++i)
    out.p[i] = Lanes(position[i]);
  return out;
}

void turn_about_z(LaneFrame& frame, const Lanes& angle) {
  const auto [s, c] = xsimd::sincos(angle);
  for (std::size_t i = 0; i < 9; i += 3) {
    const Lanes x = frame.r[i], y = frame.r[i + 1];
    frame.r[i] = x * c + y * s;
    frame.r[i + 1] = y * c - x * s;
  }
}

template <class Ball>
void place_ball(const LaneFrame& frame, const Ball& ball, SphereBlock& block) {
  const auto row = [&](std::size_t i) {
    const Lanes* r = &frame.r[3 * i];
    return r[0] * ball.x + r[1] * ball.y + r[2] * ball.z + frame.p[i];
  };
  row(0).store_aligned(block.x.data());
  row(1).store_aligned(block.y.data());
  row(2).store_aligned(block.z.data());
  block.radius.fill(ball.radius);
}

// Lanes in which two spheres are nearer than their radii less `spare`.
std::uint32_t meeting(const SphereBlock& a, const SphereBlock& b, float spare) {
  const Lanes x = load(a.x) - load(b.x), y = load(a.y) - load(b.y), z = load(a.z) - load(b.z);
  const Lanes reach(a.radius[0] + b.radius[0] - spare);
  return bits_of(x * x + y * y + z * z < reach * reach);
}

}  // namespace

// Where the robot stands in eight postures.
struct ArmChecker::Rake {
  std::array<std::array<float, lane_count>, 16> joints alignas(32);
  std::array<LaneFrame, 16> frames;
  std::vector<SphereBlock> bounds, balls;  // of each part, each ball
  std::vector<bool> placed;                // whether the part's balls are in `balls`
  std::vector<std::uint32_t> shapes;
};

ArmChecker::Rake& ArmChecker::scratch() const {
  thread_local Rake rake;
  rake.bounds.resize(parts_.size());
  rake.balls.resize(balls_.size());
  rake.placed.resize(parts_.size());
  return rake;
}

void ArmChecker::place(Rake& rake) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Body& body = bodies_[i];
    LaneFrame& frame = rake.frames[i];
    frame = body.parent < 0 ? standing(body.rotation, body.position)
                            : moved(rake.frames[static_cast<std::size_t>(body.parent)],
                                    body.rotation,
                                    body.position);
    const Lanes value = load(rake.joints[body.column]) * body.ratio + body.offset;
    if (body.turns) {
      turn_about_z(frame, value);
    } else {
      for (std::size_t k = 0; k < 3; ++k)
        frame.p[k] = frame.p[k] + frame.r[3 * k + 2] * value;
    }
  }
  static const LaneFrame world = standing({1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0});
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const int body = parts_[i].body;
    place_ball(body < 0 ? world : rake.frames[static_cast<std::size_t>(body)],
               parts_[i].bound,
               rake.bounds[i]);
  }
  rake.placed.assign(parts_.size(), false);
}

void ArmChecker::place_balls(std::size_t part, Rake& rake) const {
  if (rake.placed[part]) return;
  rake.placed[part] = true;
  const Part& of = parts_[part];
  const LaneFrame frame = of.body < 0 ? standing({1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0})
                                      : rake.frames[static_cast<std::size_t>(of.body)];
  for (std::size_t i = of.first_ball; i < of.end_ball; ++i)
    place_ball(frame, balls_[i], rake.balls[i]);
}

// From the tip backwards: hands and what they hold are what hits most often.
bool ArmChecker::hits_world(Rake& rake, Hit* hit) const {
  for (std::size_t part = parts_.size(); part-- > 0;) {
    const Part& of = parts_[part];
    if (of.body < 0) continue;
    of.world->touched(rake.bounds[part], rake.shapes);
    if (rake.shapes.empty()) continue;
    place_balls(part, rake);
    for (std::size_t i = of.first_ball; i < of.end_ball; ++i) {
      for (const std::uint32_t shape : rake.shapes) {
        if (!of.world->hits_shape(shape, rake.balls[i])) continue;
        if (hit != nullptr) *hit = {of.name, of.world->name(shape)};
        return true;
      }
    }
  }
  return false;
}

std::uint32_t ArmChecker::lanes_that_meet(const PartPair& pair, Rake& rake) const {
  const auto spare = static_cast<float>(margin_m_);  // radii hold it twice
  if (meeting(rake.bounds[pair.a], rake.bounds[pair.b], spare) == 0) return 0;
  place_balls(pair.a, rake);
  place_balls(pair.b, rake);
  std::uint32_t lanes = 0;
  for (std::size_t i = parts_[pair.a].first_ball; i < parts_[pair.a].end_ball; ++i) {
    if (meeting(rake.balls[i], rake.bounds[pair.b], spare) == 0) continue;
    for (std::size_t k = parts_[pair.b].first_ball; k < parts_[pair.b].end_ball; ++k)
      lanes |= meeting(rake.balls[i], rake.balls[k], spare);
  }
  return lanes;
}

bool ArmChecker::balls_meet(const PartPair& pair, Rake& rake) const {
  std::uint32_t lanes = lanes_that_meet(pair, rake);
  if (!pair.exact || lanes == 0) return lanes != 0;
  const robots::LinkPair links{parts_[pair.a].link, parts_[pair.b].link};
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
    Configuration q(model_->lower.size());
    for (std::size_t j = 0; j < q.size(); ++j)
      q[j] = static_cast<double>(rake.joints[j][lane]);
    const std::vector<Pose> poses = robots::link_poses(*model_->robot, state_with(q));
    if (robots::link_distance(*model_->robot, poses, links) < margin_m_) return true;
  }
  return false;
}

bool ArmChecker::hits_itself(Rake& rake, Hit* hit) const {
  for (const PartPair& pair : pairs_) {
    if (!balls_meet(pair, rake)) continue;
    if (hit != nullptr) *hit = {parts_[pair.a].name, parts_[pair.b].name};
    return true;
  }
  return false;
}

bool ArmChecker::hits(Rake& rake, Hit* hit) const {
  place(rake);
  return hits_world(rake, hit) || hits_itself(rake, hit);
}

bool ArmChecker::free(std::span<const double> q) const {
  Rake& rake = scratch();
  for (std::size_t j = 0; j < q.size(); ++j)
    rake.joints[j].fill(static_cast<float>(q[j]));
  return !hits(rake, nullptr);
}

std::string ArmChecker::collision(std::span<const double> q) const {
  Rake& rake = scratch();
  for (std::size_t j = 0; j < q.size(); ++j)
    rake.joints[j].fill(static_cast<float>(q[j]));
  Hit hit;
  return hits(rake, &hit) ? hit.a + " with " + hit.b : std::string{};
}

double ArmChecker::travel_m(std::span<const double> a, std::span<const double> b) const {
  double sum = 0;
  for (std::size_t j = 0; j < reach_.size(); ++j)
    sum += reach_[j] * std::abs(a[j] - b[j]);
  return sum;
}

bool ArmChecker::motion_free(std::span<const double> a,
                             std::span<const double> b,
                             double step_m) const {
  Rake& rake = scratch();
  const double steps = std::ceil(travel_m(a, b) / step_m / lane_count);
  const int rows = static_cast<int>(std::clamp(steps, 1.0, 1e6));
  for (int row = rows; row >= 1; --row) {  // the first look has `b` in its last lane
    for (std::size_t j = 0; j < a.size(); ++j) {
      for (std::size_t lane = 0; lane < lane_count; ++lane) {
        const double share = (static_cast<double>(lane) * rows + row) / (rows * 8.0);
        rake.joints[j][lane] = static_cast<float>(a[j] + share * (b[j] - a[j]));
      }
    }
    if (hits(rake, nullptr)) return false;
  }
  return true;
}

ConfigurationSpace ArmChecker::space(double step_m) const {
  return {model_->lower,
          model_->upper,
          [this](std::span<const double> q) { return free(q); },
          [this, step_m](std::span<const double> a, std::span<const double> b) {
            return motion_free(a, b, step_m);
          }};
}

std::vector<double> ArmChecker::state_with(std::span<const double> q) const {
  std::vector<double> state = state_;
  for (std::size_t j = 0; j < q.size(); ++j)
    state[static_cast<std::size_t>(model_->group.dofs[j])] = q[j];
  return robots::with_followers(*model_->robot, std::move(state));
}

}  // namespace marketgen::motion
