#include "collect/floor_way.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace marketgen::collect {
namespace {

constexpr double cut_window_m = 0.12, turn_window_m = 0.40;  // either side
constexpr double even_window_m = 0.50;
constexpr int window_samples = 8;

// Of the straight pieces within the window, in the mean. Before its beginning and past its end the
// way goes straight on. `lengths`: to each point.
double even_heading_rad(const std::vector<Vec2>& points,
                        const std::vector<double>& lengths,
                        double walked_m) {
  constexpr double beyond_m = 2 * even_window_m;
  double sum = 0, heading = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 piece = points[i] - points[i - 1];
    const double own = std::atan2(piece.y, piece.x);
    heading = i == 1 ? own : heading + std::remainder(own - heading, 2 * std::numbers::pi);
    const double from = i == 1 ? -beyond_m : lengths[i - 1];
    const double to = i + 1 == points.size() ? lengths[i] + beyond_m : lengths[i];
    const double inside =
        std::min(to, walked_m + even_window_m) - std::max(from, walked_m - even_window_m);
    sum += heading * std::max(inside, 0.0);
  }
  return sum / (2 * even_window_m);
}

}  // namespace

FloorWay::FloorWay(const navigation::FloorPath& path, WayTurning turning) : turning_(turning) {
  for (const PointMm& point : path.points) {
    const Vec2 at{point[0] * 1e-3, point[1] * 1e-3};
    if (!points_.empty() && at == points_.back()) continue;
    const double step = points_.empty() ? 0 : distance(at, points_.back());
    lengths_.push_back(points_.empty() ? 0 : lengths_.back() + step);
    points_.push_back(at);
  }
}

Vec2 FloorWay::corner_point(double walked_m) const {
  const double s = std::clamp(walked_m, 0.0, length_m());
  const auto next = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, s);
  const auto i = static_cast<std::size_t>(next - lengths_.begin());
  const double share = (s - lengths_[i - 1]) / (lengths_[i] - lengths_[i - 1]);
  return points_[i - 1] + (points_[i] - points_[i - 1]) * share;
}

Vec2 FloorWay::mean_point(double walked_m, double window_m) const {
  const double reach = std::min({window_m, walked_m, length_m() - walked_m});
  if (reach <= 0) return corner_point(walked_m);
  Vec2 sum{};
  for (int i = -window_samples; i <= window_samples; ++i)
    sum = sum + corner_point(walked_m + reach * i / window_samples);
  return sum * (1.0 / (2 * window_samples + 1));
}

double FloorWay::heading_rad(double walked_m) const {
  if (turning_ == WayTurning::even) return even_heading_rad(points_, lengths_, walked_m);
  const double reach = std::max(std::min({turn_window_m, walked_m, length_m() - walked_m}), 1e-3);
  const Vec2 ahead = corner_point(walked_m + reach), behind = corner_point(walked_m - reach);
  return std::atan2(ahead.y - behind.y, ahead.x - behind.x);
}

assets::WayPlace FloorWay::at(double walked_m) const {
  const double s = std::clamp(walked_m, 0.0, length_m());
  return {mean_point(s, cut_window_m), heading_rad(s)};
}

double FloorWay::sharpest_rad_m() const {
  constexpr double piece_m = 0.05;
  double sharpest = 0, before = heading_rad(0);
  for (double s = piece_m; s < length_m(); s += piece_m) {
    const double now = heading_rad(s);
    const double turned = std::remainder(now - before, 2 * std::numbers::pi);
    sharpest = std::max(sharpest, std::abs(turned) / piece_m);
    before = now;
  }
  return sharpest;
}

}  // namespace marketgen::collect
