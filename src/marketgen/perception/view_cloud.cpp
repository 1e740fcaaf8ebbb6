#include "perception/view_cloud.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace marketgen::perception {
namespace {

constexpr int reach_px = 2;        // of the differences that give a normal
constexpr float step_share = 12;   // what is farther apart than so many pixels' sides is a step
constexpr float beside_share = 5;  // the same between neighbours of one surface
constexpr int min_beside = 4;      // of eight neighbours
constexpr float min_normal_facing = 0.08F;

}  // namespace

ViewCloud::ViewCloud(agent::View view) : view_(std::move(view)) {
  place_camera();
  place_points();
  find_normals();
  blur_colors();
}

void ViewCloud::move(const Pose& way) {
  view_.base_from_camera = way * view_.base_from_camera;
  place_camera();
  place_points();
  for (Vec3f& normal : normals_)
    normal = to_float(rotate(way.rotation, to_double(normal)));
}

void ViewCloud::place_camera() {
  const Pose& pose = view_.base_from_camera;
  eye_ = to_float(pose.position);
  right_ = to_float(rotate(pose.rotation, {1, 0, 0}));
  down_ = to_float(rotate(pose.rotation, {0, 1, 0}));
  ahead_ = to_float(rotate(pose.rotation, {0, 0, 1}));
}

void ViewCloud::place_points() {
  points_.resize(view_.depth_m.size());
  const agent::PinholeLens& lens = view_.lens;
  for (int y = 0; y < height(); ++y) {
    for (int x = 0; x < width(); ++x) {
      const float depth = view_.depth_m[index(x, y)];
      const auto across = static_cast<float>((x - lens.cx) / lens.fx);
      const auto along = static_cast<float>((y - lens.cy) / lens.fy);
      points_[index(x, y)] = eye_ + (right_ * across + down_ * along + ahead_) * depth;
    }
  }
}

bool ViewCloud::is_surface(std::size_t pixel) const {
  if (!has(pixel)) return false;
  const int x = static_cast<int>(pixel % static_cast<std::size_t>(width()));
  const int y = static_cast<int>(pixel / static_cast<std::size_t>(width()));
  const float depth = view_.depth_m[pixel], most = beside_share * pixel_m(depth);
  int beside = -1;  // itself is counted, too
  for (int v = std::max(0, y - 1); v <= std::min(height() - 1, y + 1); ++v)
    for (int u = std::max(0, x - 1); u <= std::min(width() - 1, x + 1); ++u)
      beside += has(index(u, v)) && std::abs(view_.depth_m[index(u, v)] - depth) < most ? 1 : 0;
  return beside >= min_beside;
}

void ViewCloud::find_normals() {
  normals_.resize(points_.size());
  for (int y = reach_px; y < height() - reach_px; ++y) {
    for (int x = reach_px; x < width() - reach_px; ++x) {
      const std::size_t here = index(x, y);
      if (!has(here)) continue;
      const std::array around{index(x - reach_px, y),
                              index(x + reach_px, y),
                              index(x, y - reach_px),
                              index(x, y + reach_px)};
      const float most = step_share * pixel_m(view_.depth_m[here]);
      const bool smooth = std::ranges::all_of(around, [&](std::size_t pixel) {
        return has(pixel) && std::abs(view_.depth_m[pixel] - view_.depth_m[here]) < most;
      });
      if (!smooth) continue;
      const Vec3f across = points_[around[1]] - points_[around[0]];
      const Vec3f along = points_[around[3]] - points_[around[2]];
      Vec3f normal = normalized(cross(along, across));
      const Vec3f to_eye = normalized(eye_ - points_[here]);
      if (dot(normal, to_eye) < 0) normal = -normal;
      if (dot(normal, to_eye) > min_normal_facing) normals_[here] = normal;
    }
  }
}

void ViewCloud::blur_colors() {
  colors_.resize(points_.size());
  for (int y = 0; y < height(); ++y) {
    for (int x = 0; x < width(); ++x) {
      Vec3f sum;
      float count = 0;
      for (int v = std::max(0, y - 1); v <= std::min(height() - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(width() - 1, x + 1); ++u) {
          const std::uint8_t* rgb = view_.color.at(u, v);
          sum += Vec3f{
              static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])};
          ++count;
        }
      }
      colors_[index(x, y)] = sum / (255 * count);
    }
  }
}

std::optional<ViewCloud::Seen> ViewCloud::project(Vec3f base_point) const {
  const Vec3f off = base_point - eye_;
  const float depth = dot(off, ahead_);
  if (depth < 0.02F) return std::nullopt;
  const agent::PinholeLens& lens = view_.lens;
  const auto x = static_cast<int>(
      std::floor(lens.cx + lens.fx * static_cast<double>(dot(off, right_) / depth) + 0.5));
  const auto y = static_cast<int>(
      std::floor(lens.cy + lens.fy * static_cast<double>(dot(off, down_) / depth) + 0.5));
  if (x < 0 || y < 0 || x >= width() || y >= height()) return std::nullopt;
  return Seen{index(x, y), depth};
}

}  // namespace marketgen::perception
