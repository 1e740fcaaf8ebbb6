#include "perception/steady_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace marketgen::perception {
namespace {

constexpr std::size_t max_views = 8;
constexpr double still_m = 5e-4, still_half_turn = 2.5e-4;
constexpr double aimed_error_m = 4e-4;     // of the mean, one sigma
constexpr std::size_t compared_every = 7;  // pixels, of two pictures
constexpr float same_surface_m = 0.012F;   // of what is measured at one pixel
// Sigma of a normal distribution by the middle value of how far two draws are apart.
constexpr double sigma_by_middle = 1 / (0.6745 * 1.4142);

bool stands_still(const Pose& a, const Pose& b) {
  const Quaternion turn = inverse(a.rotation) * b.rotation;
  return length(a.position - b.position) < still_m &&
         std::hypot(turn.x, turn.y, turn.z) < still_half_turn;
}

// One sigma of one picture.
double noise_m(const agent::View& a, const agent::View& b) {
  std::vector<float> apart;
  for (std::size_t i = 0; i < a.depth_m.size(); i += compared_every)
    if (a.depth_m[i] > 0 && b.depth_m[i] > 0)
      apart.push_back(std::abs(a.depth_m[i] - b.depth_m[i]));
  if (apart.empty()) return 0;
  const auto middle = apart.begin() + static_cast<std::ptrdiff_t>(apart.size() / 2);
  std::ranges::nth_element(apart, middle);
  return static_cast<double>(*middle) * sigma_by_middle;
}

// Of at least one value; sorts them.
float middle_mean(std::vector<float>& values) {
  std::ranges::sort(values);
  const float middle = values[values.size() / 2];
  float sum = 0, count = 0;
  for (const float value : values) {
    if (std::abs(value - middle) > same_surface_m) continue;
    sum += value;
    ++count;
  }
  return sum / count;
}

}  // namespace

void SteadyViews::add(agent::View view) {
  if (!views_.empty() && (!stands_still(views_.back().base_from_camera, view.base_from_camera) ||
                          views_.back().depth_m.size() != view.depth_m.size()))
    views_.clear();
  views_.push_back(std::move(view));
}

bool SteadyViews::enough() const {
  if (views_.size() < 2) return false;
  const double share = noise_m(views_[0], views_[1]) / aimed_error_m;
  return views_.size() >= max_views || static_cast<double>(views_.size()) >= share * share;
}

agent::View SteadyViews::merged() const {
  agent::View view = views_.back();
  if (views_.size() == 1) return view;
  std::vector<float> values;
  for (std::size_t i = 0; i < view.depth_m.size(); ++i) {
    values.clear();
    for (const agent::View& each : views_)
      if (each.depth_m[i] > 0) values.push_back(each.depth_m[i]);
    view.depth_m[i] = 2 * values.size() < views_.size() ? 0 : middle_mean(values);
  }
  for (std::size_t i = 0; i < view.color.pixels.size(); ++i) {
    std::size_t sum = views_.size() / 2;
    for (const agent::View& each : views_)
      sum += each.color.pixels[i];
    view.color.pixels[i] = static_cast<std::uint8_t>(sum / views_.size());
  }
  return view;
}

}  // namespace marketgen::perception
