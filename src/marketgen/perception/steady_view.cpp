#include "perception/steady_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace marketgen::perception {
namespace {

constexpr int max_views = 12;
constexpr double wanted_noise_m = 0.0018;  // a metre away, of all together
constexpr double exact_m = 5e-5;           // what is noisier is no exact depth
constexpr double still_m = 1e-3, still_turn = 1e-3;
constexpr double of_normal = 0.6745;  // median of what a normal distribution is off, in sigmas
constexpr double outlier_sigmas = 3;

bool is_same_place(const agent::View& a, const agent::View& b) {
  const Pose off = inverse(a.base_from_camera) * b.base_from_camera;
  return a.camera == b.camera && a.width() == b.width() && a.height() == b.height() &&
         length(off.position) < still_m &&
         length(rotate(off.rotation, {0, 0, 1}) - Vec3{0, 0, 1}) < still_turn &&
         length(rotate(off.rotation, {1, 0, 0}) - Vec3{1, 0, 0}) < still_turn;
}

// Of one of two pictures, scaled to a metre.
double noise_of(const agent::View& a, const agent::View& b) {
  std::vector<float> off;
  for (std::size_t i = 0; i < a.depth_m.size(); ++i) {
    if (!(a.depth_m[i] > 0 && b.depth_m[i] > 0)) continue;
    const float depth = (a.depth_m[i] + b.depth_m[i]) / 2;
    off.push_back(std::abs(a.depth_m[i] - b.depth_m[i]) / (depth * depth));
  }
  if (off.empty()) return 0;
  const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
  std::ranges::nth_element(off, middle);
  return static_cast<double>(*middle) / of_normal / std::sqrt(2.0);
}

// Mean of what lies near the median: where an edge jumps to and fro, the side it is on mostly.
float mean_of_most(std::vector<float>& depths, double noise_m) {
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::ranges::nth_element(depths, middle);
  const float median = *middle;
  const auto apart = static_cast<float>(outlier_sigmas * noise_m) * median * median;
  float sum = 0, count = 0;
  for (const float depth : depths) {
    if (std::abs(depth - median) > apart) continue;
    sum += depth;
    ++count;
  }
  return count > 0 ? sum / count : median;
}

}  // namespace

void SteadyView::add(agent::View view) {
  ++added_;
  if (!views_.empty() && !is_same_place(views_.front(), view)) return;
  views_.push_back(std::move(view));
  if (views_.size() == 2) noise_m_ = noise_of(views_[0], views_[1]);
}

bool SteadyView::wants_more() const {
  if (added_ >= max_views) return false;
  if (views_.size() < 2) return true;
  const double share = noise_m_ / wanted_noise_m;
  return noise_m_ > exact_m && static_cast<double>(views_.size()) < share * share;
}

agent::View SteadyView::take() {
  const std::vector<agent::View> views = std::exchange(views_, {});
  added_ = 0;
  agent::View steady = views.front();
  if (views.size() == 1 || noise_m_ <= exact_m) return steady;
  std::vector<float> depths;
  for (std::size_t i = 0; i < steady.depth_m.size(); ++i) {
    depths.clear();
    for (const agent::View& view : views)
      if (view.depth_m[i] > 0) depths.push_back(view.depth_m[i]);
    steady.depth_m[i] = 2 * depths.size() > views.size() ? mean_of_most(depths, noise_m_) : 0;
  }
  for (std::size_t i = 0; i < steady.color.pixels.size(); ++i) {
    std::size_t sum = 0;
    for (const agent::View& view : views)
      sum += view.color.pixels[i];
    steady.color.pixels[i] = static_cast<std::uint8_t>((sum + views.size() / 2) / views.size());
  }
  return steady;
}

}  // namespace marketgen::perception
