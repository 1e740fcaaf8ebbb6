#include "render/panel_reflection.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/shading_math.h"

namespace marketgen::raytrace {
namespace {

constexpr float cell_m = 2;
constexpr float near_m = 2;              // panels this far from a cell are looked at from it
constexpr float widest_spread_m = 0.9F;  // so that what lies farther does not count
// Spread of mirrored directions in units of GGX's alpha, in the plane of incidence: twice that of
// the half vectors.
constexpr float spread_of_alpha = 1.4F;
constexpr float narrowest =
    0.12F;                      // across the plane of incidence, in units of the spread along it
constexpr float level = 0.03F;  // flatter rays never reach the ceiling
constexpr float longest_reach_m = 6;  // of the lobe's footprint to each side
constexpr int taps = 7;
constexpr float tap_step = 0.6F;  // in standard deviations
constexpr std::array<float, taps> tap_weight{
    0.052F, 0.128F, 0.207F, 0.226F, 0.207F, 0.128F, 0.052F};

// Cumulative distribution with a sharp middle and long tails, as the GGX lobe has (Student's t with
// two degrees of freedom).
float below(float x) {
  return 0.5F + 0.5F * x / std::sqrt(2 + x * x);
}

}  // namespace

PanelReflection::PanelReflection(const World& world) {
  const Bounds3 room = world.room.empty() ? Bounds3{{0, 0, 0}, {1, 1, 1}} : world.room;
  low_ = {room.low.x, room.low.y};
  columns_ = std::max(1, static_cast<int>(std::ceil(room.size().x / cell_m)));
  rows_ = std::max(1, static_cast<int>(std::ceil(room.size().y / cell_m)));
  panels_near_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (std::uint32_t i = 0; i < world.panel_count; ++i) {
    const AreaLight& light = world.lights[i];
    const Vec3f middle = light.corner + (light.edge_u + light.edge_v) * 0.5F;
    const Panel panel{{middle.x, middle.y},
                      {(std::fabs(light.edge_u.x) + std::fabs(light.edge_v.x)) / 2,
                       (std::fabs(light.edge_u.y) + std::fabs(light.edge_v.y)) / 2}};
    panels_.push_back(panel);
    height_ = middle.z;
    radiance_ = light.radiance;
    const auto cell = [](float x, float start, int count) {
      return std::clamp(static_cast<int>(std::floor((x - start) / cell_m)), 0, count - 1);
    };
    for (int y = cell(middle.y - panel.half.y - near_m, low_.y, rows_);
         y <= cell(middle.y + panel.half.y + near_m, low_.y, rows_);
         ++y) {
      for (int x = cell(middle.x - panel.half.x - near_m, low_.x, columns_);
           x <= cell(middle.x + panel.half.x + near_m, low_.x, columns_);
           ++x) {
        panels_near_[static_cast<std::size_t>(y * columns_ + x)].push_back(i);
      }
    }
  }
}

float PanelReflection::covered(Vec2f point, float spread) const {
  const int column = static_cast<int>(std::floor((point.x - low_.x) / cell_m));
  const int row = static_cast<int>(std::floor((point.y - low_.y) / cell_m));
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return 0;
  float sum = 0;
  for (const std::uint32_t i : panels_near_[static_cast<std::size_t>(row * columns_ + column)]) {
    const Panel& panel = panels_[i];
    const float x = std::fabs(point.x - panel.middle.x), y = std::fabs(point.y - panel.middle.y);
    if (x > panel.half.x + near_m || y > panel.half.y + near_m) continue;
    const float along_x = below((x + panel.half.x) / spread) - below((x - panel.half.x) / spread);
    const float along_y = below((y + panel.half.y) / spread) - below((y - panel.half.y) / spread);
    sum += along_x * along_y;
  }
  return sum;
}

PanelReflection::Seen PanelReflection::at(const Surface& surface, Vec3f mirror) const {
  if (panels_.empty() || mirror.z < level) return {};
  Seen seen;
  seen.distance = (height_ - surface.position.z) / mirror.z;
  if (seen.distance <= 0) return {};
  // How the point on the ceiling moves when the direction turns within, and out of, the plane of
  // incidence.
  const float cosine = std::clamp(dot(mirror, surface.relief_normal), 0.0F, 1.0F);
  const Vec3f within = normalized(surface.relief_normal - mirror * cosine);
  const Vec3f across = cross(mirror, within);
  const auto shift = [&](Vec3f turn) {
    return (turn - mirror * (turn.z / mirror.z)) * seen.distance;
  };
  const float alpha = std::max(surface.roughness * surface.roughness, 2e-3F);
  const float spread = spread_of_alpha * alpha;
  Vec3f along = shift(within) * spread;
  const float reach = length(along);
  if (reach > longest_reach_m) along = along * (longest_reach_m / reach);
  const float width = length(shift(across)) * spread * std::max(cosine, narrowest);
  const float blur =
      std::clamp(std::max(width, 0.3F * tap_step * length(along)), 1e-3F, widest_spread_m);
  const Vec3f point = surface.position + mirror * seen.distance;
  float cover = 0;
  for (int k = 0; k < taps; ++k) {
    const Vec3f p = point + along * (tap_step * static_cast<float>(k - taps / 2));
    cover += tap_weight[static_cast<std::size_t>(k)] * covered({p.x, p.y}, blur);
  }
  seen.radiance = radiance_ * std::min(cover, 1.0F);
  return seen;
}

}  // namespace marketgen::raytrace
