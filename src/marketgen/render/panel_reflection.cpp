#include "render/panel_reflection.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/shading_math.h"

namespace marketgen::raytrace {
namespace {

constexpr float texel_m = 0.05F;
constexpr float widest_spread_m = 2;
constexpr float texels_of_spread = 3;  // a texel this wide blurs like a spot of that spread
// Spread of mirrored directions in units of GGX's alpha, in the plane of incidence: twice that of
// the half vectors.
constexpr float spread_of_alpha = 1.4F;
constexpr float narrowest =
    0.12F;                         // across the plane of incidence, in units of the spread along it
constexpr float flattest = 0.03F;  // flatter rays never reach the ceiling
constexpr float longest_reach_m = 6;  // of the lobe's footprint to each side
constexpr int taps = 7;
constexpr float one_tap_below = 1.5F;  // times the blur: shorter lobes are round enough
constexpr float tap_step = 0.6F;       // in standard deviations
constexpr std::array<float, taps> tap_weight{
    0.052F, 0.128F, 0.207F, 0.226F, 0.207F, 0.128F, 0.052F};

}  // namespace

PanelReflection::PanelReflection(const World& world) {
  if (world.panel_count == 0) return;
  const Bounds3 room = world.room.empty() ? Bounds3{{0, 0, 0}, {1, 1, 1}} : world.room;
  low_ = {room.low.x, room.low.y};
  const auto texels = [](float extent) {
    return std::max(1, static_cast<int>(std::ceil(extent / texel_m)));
  };
  Level finest{texels(room.size().x), texels(room.size().y), {}};
  finest.share.resize(static_cast<std::size_t>(finest.width) *
                      static_cast<std::size_t>(finest.height));
  levels_.push_back(std::move(finest));
  draw_panels(world);
  halve_levels();
}

void PanelReflection::draw_panels(const World& world) {
  Level& finest = levels_[0];
  for (std::uint32_t i = 0; i < world.panel_count; ++i) {
    const AreaLight& light = world.lights[i];
    const Vec3f middle = light.corner + (light.edge_u + light.edge_v) * 0.5F;
    const float half_x = (std::fabs(light.edge_u.x) + std::fabs(light.edge_v.x)) / 2;
    const float half_y = (std::fabs(light.edge_u.y) + std::fabs(light.edge_v.y)) / 2;
    const float x0 = (middle.x - half_x - low_.x) / texel_m, x1 = x0 + 2 * half_x / texel_m;
    const float y0 = (middle.y - half_y - low_.y) / texel_m, y1 = y0 + 2 * half_y / texel_m;
    height_ = middle.z;
    radiance_ = light.radiance;
    const auto overlap = [](int texel, float low, float high) {
      const auto start = static_cast<float>(texel);
      return std::max(0.0F, std::min(high, start + 1) - std::max(low, start));
    };
    for (int y = std::max(0, static_cast<int>(y0));
         y < std::min(finest.height, static_cast<int>(y1) + 1);
         ++y) {
      for (int x = std::max(0, static_cast<int>(x0));
           x < std::min(finest.width, static_cast<int>(x1) + 1);
           ++x)
        finest.share[static_cast<std::size_t>(y * finest.width + x)] +=
            overlap(x, x0, x1) * overlap(y, y0, y1);
    }
  }
}

void PanelReflection::halve_levels() {
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    const Level& fine = levels_.back();
    // Rounded up: what lies over the room's edge is dark.
    Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
    for (int y = 0; y < coarse.height; ++y) {
      for (int x = 0; x < coarse.width; ++x) {
        float sum = 0;
        for (int k = 0; k < 4; ++k) {
          const int column = 2 * x + k % 2, row = 2 * y + k / 2;
          if (column < fine.width && row < fine.height)
            sum += fine.share[static_cast<std::size_t>(row * fine.width + column)];
        }
        coarse.share.push_back(sum / 4);
      }
    }
    levels_.push_back(std::move(coarse));
  }
}

float PanelReflection::covered(Vec2f point, float spread) const {
  const float fineness = rough_log2(std::max(spread * texels_of_spread / texel_m, 1.0F));
  const auto number = std::min(static_cast<std::size_t>(fineness + 0.5F), levels_.size() - 1);
  const Level& level = levels_[number];
  const float texel = texel_m * static_cast<float>(1U << number);
  const float x = (point.x - low_.x) / texel - 0.5F, y = (point.y - low_.y) / texel - 0.5F;
  const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
  const float fx = x - static_cast<float>(column), fy = y - static_cast<float>(row);
  const auto share = [&](int at_x, int at_y) {
    const bool inside = at_x >= 0 && at_y >= 0 && at_x < level.width && at_y < level.height;
    return inside ? level.share[static_cast<std::size_t>(at_y * level.width + at_x)] : 0.0F;
  };
  return (share(column, row) * (1 - fx) + share(column + 1, row) * fx) * (1 - fy) +
         (share(column, row + 1) * (1 - fx) + share(column + 1, row + 1) * fx) * fy;
}

PanelReflection::Seen PanelReflection::at(const Surface& surface, Vec3f mirror) const {
  if (levels_.empty() || mirror.z < flattest) return {};
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
  if (length(along) < one_tap_below * blur) {
    cover = covered({point.x, point.y}, blur);
  } else {
    for (int k = 0; k < taps; ++k) {
      const Vec3f p = point + along * (tap_step * static_cast<float>(k - taps / 2));
      cover += tap_weight[static_cast<std::size_t>(k)] * covered({p.x, p.y}, blur);
    }
  }
  seen.radiance = radiance_ * std::min(cover, 1.0F);
  return seen;
}

}  // namespace marketgen::raytrace
