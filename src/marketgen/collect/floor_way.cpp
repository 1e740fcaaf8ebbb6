#include "collect/floor_way.h"

#include <algorithm>
#include <cmath>

namespace marketgen::collect {
namespace {

constexpr double cut_window_m = 0.12, turn_window_m = 0.40;  // either side
constexpr int window_samples = 8;

}  // namespace

FloorWay::FloorWay(const navigation::FloorPath& path) {
  for (const PointMm& point : path.points) {
    const Vec2 at{point[0] * 1e-3, point[1] * 1e-3};
    if (!points_.empty() && at == points_.back()) continue;
    const double step =
        points_.empty() ? 0 : std::hypot(at.x - points_.back().x, at.y - points_.back().y);
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

assets::WayPlace FloorWay::at(double walked_m) const {
  const double s = std::clamp(walked_m, 0.0, length_m());
  const double reach = std::max(std::min({turn_window_m, s, length_m() - s}), 1e-3);
  const Vec2 ahead = corner_point(s + reach), behind = corner_point(s - reach);
  return {mean_point(s, cut_window_m), std::atan2(ahead.y - behind.y, ahead.x - behind.x)};
}

}  // namespace marketgen::collect
