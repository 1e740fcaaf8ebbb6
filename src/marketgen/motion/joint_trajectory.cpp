#include "motion/joint_trajectory.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace marketgen::motion {
namespace {

// Second derivatives of the natural cubic spline through evenly spaced knots (Thomas algorithm).
JointPath natural_bends(const JointPath& knots) {
  const std::size_t count = knots.size(), joints = knots.front().size();
  JointPath bends(count, Configuration(joints, 0.0));
  std::vector<double> upper(count, 0.0);
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double pivot = 4 - upper[i - 1];
    upper[i] = 1 / pivot;
    for (std::size_t j = 0; j < joints; ++j) {
      const double bend = 6 * (knots[i + 1][j] - 2 * knots[i][j] + knots[i - 1][j]);
      bends[i][j] = (bend - bends[i - 1][j]) / pivot;
    }
  }
  for (std::size_t i = count - 1; i-- > 1;) {
    for (std::size_t j = 0; j < joints; ++j)
      bends[i][j] -= upper[i] * bends[i + 1][j];
  }
  return bends;
}

// Largest magnitudes of the three derivatives of one joint by the spline's parameter.
struct Steepness {
  double first = 0, second = 0, third = 0;
};
Steepness steepness(const JointPath& knots, const JointPath& bends, std::size_t joint) {
  Steepness most;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double rise = knots[i + 1][joint] - knots[i][joint];
    const double a = bends[i][joint], b = bends[i + 1][joint];
    // The first derivative is a parabola: its ends, and its turning point where a bend is zero.
    const double at_start = rise - (2 * a + b) / 6, at_end = rise + (a + 2 * b) / 6;
    most.first = std::max({most.first, std::abs(at_start), std::abs(at_end)});
    if (a * b < 0) most.first = std::max(most.first, std::abs(at_start + a * a / (2 * (a - b))));
    most.second = std::max({most.second, std::abs(a), std::abs(b)});
    most.third = std::max(most.third, std::abs(b - a));
  }
  return most;
}

// Limits of the parameter s that keep every joint q(s(t)) in its own:
//   q'  = f s',   q'' = f' s'^2 + f s'',   q''' = f'' s'^3 + 3 f' s' s'' + f s'''.
MotionLimits parameter_limits(const std::vector<Steepness>& most,
                              const std::vector<MotionLimits>& limits) {
  MotionLimits allowed{1e6, 1e9, 1e12};
  double &v = allowed.velocity, &a = allowed.acceleration;
  for (std::size_t j = 0; j < most.size(); ++j) {
    const auto& [f1, f2, f3] = most[j];
    if (f1 > 0) v = std::min(v, limits[j].velocity / f1);
    // Half of the acceleration and a third of the jerk at most go into the bends.
    if (f2 > 0) v = std::min(v, std::sqrt(limits[j].acceleration / (2 * f2)));
    if (f3 > 0) v = std::min(v, std::cbrt(limits[j].jerk / (3 * f3)));
  }
  for (std::size_t j = 0; j < most.size(); ++j) {
    const auto& [f1, f2, f3] = most[j];
    if (f1 > 0) a = std::min(a, (limits[j].acceleration - f2 * v * v) / f1);
    if (f2 > 0) a = std::min(a, (limits[j].jerk - f3 * v * v * v) / (2 * 3 * f2 * v));
  }
  for (std::size_t j = 0; j < most.size(); ++j) {
    const auto& [f1, f2, f3] = most[j];
    const double left = limits[j].jerk - f3 * v * v * v - 3 * f2 * v * a;
    if (f1 > 0) allowed.jerk = std::min(allowed.jerk, left / f1);
  }
  return allowed;
}

Result<void> check(const JointPath& path, const std::vector<MotionLimits>& limits) {
  if (path.empty() || path.front().empty())
    return Error{"motion.bad_configuration", "joint path", "the path is empty"};
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto finite = [](double q) { return std::isfinite(q); };
    if (path[i].size() == path.front().size() &&
        std::all_of(path[i].begin(), path[i].end(), finite))
      continue;
    return Error{"motion.bad_configuration",
                 fmt::format("joint path/{}", i),
                 "another number of joints than at the start, or not finite"};
  }
  const auto bad = [](double limit) { return !(limit > 0) || !std::isfinite(limit); };
  for (const MotionLimits& l : limits) {
    if (bad(l.velocity) || bad(l.acceleration) || bad(l.jerk))
      return Error{"motion.bad_limits", "joint limits", "each must be positive and finite"};
  }
  if (limits.size() != path.front().size())
    return Error{"motion.bad_limits",
                 "joint limits",
                 fmt::format("{} for {} joints", limits.size(), path.front().size())};
  return {};
}

}  // namespace

void JointTrajectory::add(JointPath knots, const std::vector<MotionLimits>& limits) {
  JointPath bends = natural_bends(knots);
  std::vector<Steepness> most;
  for (std::size_t j = 0; j < joints_; ++j)
    most.push_back(steepness(knots, bends, j));
  const bool moves =
      std::any_of(most.begin(), most.end(), [](const Steepness& s) { return s.first > 0; });
  const double length = moves ? static_cast<double>(knots.size() - 1) : 0;
  const SCurve motion(length, parameter_limits(most, limits));
  pieces_.push_back({std::move(knots), std::move(bends), motion, duration_s()});
}

double JointTrajectory::duration_s() const {
  return pieces_.empty() ? 0 : pieces_.back().start_s + pieces_.back().motion.duration_s();
}

void JointTrajectory::append(const JointTrajectory& next) {
  const double start_s = duration_s();
  joints_ = std::max(joints_, next.joints_);
  for (Piece piece : next.pieces_) {
    piece.start_s += start_s;
    pieces_.push_back(std::move(piece));
  }
}

TrajectoryState JointTrajectory::at(double time_s) const {
  TrajectoryState state{Configuration(joints_), Configuration(joints_), Configuration(joints_)};
  if (pieces_.empty()) return state;
  std::size_t k = 0;
  while (k + 1 < pieces_.size() && time_s >= pieces_[k + 1].start_s)
    ++k;
  const Piece& piece = pieces_[k];
  const MotionState s = piece.motion.at(time_s - piece.start_s);
  const std::size_t last = piece.knots.size() - 1;
  const std::size_t i =
      std::min(static_cast<std::size_t>(std::max(s.position, 0.0)), last > 0 ? last - 1 : 0);
  const std::size_t next = std::min(i + 1, last);
  const double u = s.position - static_cast<double>(i), w = 1 - u;
  for (std::size_t j = 0; j < joints_; ++j) {
    const double p = piece.knots[i][j], q = piece.knots[next][j];
    const double a = piece.bends[i][j], b = piece.bends[next][j];
    const double first = q - p + ((1 - 3 * w * w) * a + (3 * u * u - 1) * b) / 6;
    const double second = w * a + u * b;
    state.position[j] = w * p + u * q + ((w * w * w - w) * a + (u * u * u - u) * b) / 6;
    state.velocity[j] = first * s.velocity;
    state.acceleration[j] = second * s.velocity * s.velocity + first * s.acceleration;
  }
  return state;
}

Result<JointTrajectory> timed_path(const JointPath& path, const std::vector<MotionLimits>& limits) {
  MARKETGEN_CHECK(check(path, limits));
  JointTrajectory trajectory;
  trajectory.joints_ = path.front().size();
  if (path.size() == 1) trajectory.add(path, limits);
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    trajectory.add({path[i], path[i + 1]}, limits);
  return trajectory;
}

Result<JointTrajectory> timed_curve(const JointPath& knots,
                                    const std::vector<MotionLimits>& limits) {
  MARKETGEN_CHECK(check(knots, limits));
  JointTrajectory trajectory;
  trajectory.joints_ = knots.front().size();
  trajectory.add(knots, limits);
  return trajectory;
}

}  // namespace marketgen::motion
