#include "render/light/panel_reflection.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/shading_math.h"

namespace marketgen::render::raytrace {
namespace {

constexpr float texel_m = 0.05F;
constexpr float widest_spread_m = 2;
constexpr float texels_of_spread = 3;  // a texel this wide blurs like a spot of that spread
// Spread of mirrored directions in units of GGX's alpha, in the plane of incidence: twice that of
// the half vectors.
constexpr float spread_of_alpha = 1.4F;
constexpr float narrowest =
    0.12F;                         // across the plane of incidence, in units of the spread along it
constexpr float min_rise = 0.03F;  // flatter rays never reach the ceiling
constexpr float longest_reach_m = 6;  // of the lobe's footprint to each side
constexpr std::size_t taps = 7;
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
  levels_.push_back({texels(room.size().x), texels(room.size().y)});
  shares_.resize(static_cast<std::size_t>(levels_[0].width * levels_[0].height));
  draw_panels(world);
  halve_levels();
}

void PanelReflection::draw_panels(const World& world) {
  const Level finest = levels_[0];
  for (std::uint32_t i = 0; i < world.panel_count; ++i) {
    const AreaLight& light = world.lights[i];
    const Vec3f middle = light.middle();
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
        shares_[static_cast<std::size_t>(y * finest.width + x)] +=
            overlap(x, x0, x1) * overlap(y, y0, y1);
    }
  }
}

void PanelReflection::halve_levels() {
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    const Level fine = levels_.back();
    // Rounded up: what lies over the room's edge is dark.
    const Level coarse{
        (fine.width + 1) / 2, (fine.height + 1) / 2, static_cast<int>(shares_.size())};
    for (int y = 0; y < coarse.height; ++y) {
      for (int x = 0; x < coarse.width; ++x) {
        float sum = 0;
        for (int k = 0; k < 4; ++k) {
          const int column = 2 * x + k % 2, row = 2 * y + k / 2;
          if (column < fine.width && row < fine.height)
            sum += shares_[static_cast<std::size_t>(fine.first + row * fine.width + column)];
        }
        shares_.push_back(sum / 4);
      }
    }
    levels_.push_back(coarse);
  }
  for (std::size_t l = 0; l < widths_.size(); ++l) {
    const Level& level = levels_[std::min(l, levels_.size() - 1)];
    widths_[l] = level.width;
    heights_[l] = level.height;
    firsts_[l] = level.first;
  }
}

Float8 PanelReflection::covered(Float8 at_x, Float8 at_y, Float8 spread) const {
  const auto last = static_cast<int>(std::min(levels_.size(), widths_.size()) - 1);
  const Float8 fineness = rough_log2(max(spread * (texels_of_spread / texel_m), Float8(1)));
  const Int8 number = min(to_int(fineness + 0.5F), Int8(last));
  const auto of_level = [&](const std::array<std::int32_t, 16>& table) {
    return Int8(_mm256_i32gather_epi32(table.data(), number.m, 4));
  };
  const Int8 width = of_level(widths_), height = of_level(heights_), first = of_level(firsts_);
  // 2^-number / texel_m: texels a metre.
  const Float8 per_m = float_of_bits((Int8(127) - number) << 23) * (1 / texel_m);
  // Far outside is as dark as just outside, and fits an integer.
  const auto texel = [&](Float8 at, float low, Int8 size) {
    return clamp((at - low) * per_m - 0.5F, Float8(-2), to_float(size) + 1.0F);
  };
  const Float8 x = texel(at_x, low_.x, width), y = texel(at_y, low_.y, height);
  const Float8 left = rounded_down(x), top = rounded_down(y), fx = x - left, fy = y - top;
  const Int8 column = to_int(left), row = to_int(top);
  const auto share = [&](Int8 across, Int8 down) {
    const Mask8 inside =
        (across > Int8(-1)) & (down > Int8(-1)) & (width > across) & (height > down);
    const Int8 place = select(inside, first + down * width + across, Int8(0));
    return select(inside, gathered(shares_.data(), place), Float8(0));
  };
  const Int8 right = column + 1, below = row + 1;
  return (share(column, row) * (1 - fx) + share(right, row) * fx) * (1 - fy) +
         (share(column, below) * (1 - fx) + share(right, below) * fx) * fy;
}

PanelReflection::Seen PanelReflection::at(const Points& points) const {
  Seen seen;
  if (levels_.empty()) return seen;
  const Vec8& mirror = points.mirror;
  const Float8 rise = max(mirror.z, Float8(min_rise));
  const Float8 distance = (Float8(height_) - points.position.z) / rise;
  const Mask8 meets = (mirror.z >= Float8(min_rise)) & (distance > Float8(0));
  if (!meets.any()) return seen;
  seen.distance = select(meets, distance, Float8(0));
  // How the point on the ceiling moves when the direction turns within, and out of, the plane of
  // incidence.
  const Float8 cosine = clamp(dot(mirror, points.normal), Float8(0), Float8(1));
  const Vec8 bend = points.normal - mirror * cosine;
  const Vec8 within = bend * (Float8(1) / square_root(max(dot(bend, bend), Float8(1e-12F))));
  const Vec8 across = cross(mirror, within);
  const auto shift = [&](const Vec8& turn) {
    return (turn - mirror * (turn.z / rise)) * seen.distance;
  };
  const auto size = [](const Vec8& v) { return square_root(dot(v, v)); };
  const Float8 alpha = max(points.roughness * points.roughness, Float8(2e-3F));
  const Float8 spread = spread_of_alpha * alpha;
  Vec8 along = shift(within) * spread;
  const Float8 reach = size(along);
  along *= min(Float8(longest_reach_m) / max(reach, Float8(1e-6F)), Float8(1));
  const Float8 span = size(along);
  const Float8 width = size(shift(across)) * spread * max(cosine, Float8(narrowest));
  const Float8 blur =
      clamp(max(width, 0.3F * tap_step * span), Float8(1e-3F), Float8(widest_spread_m));
  const Vec8 point = points.position + mirror * seen.distance;
  const Mask8 round = span < one_tap_below * blur;
  Float8 cover = covered(point.x, point.y, blur);
  if ((~round & meets).any()) {
    Float8 row = tap_weight[taps / 2] * cover;
    for (std::size_t k = 0; k < taps; ++k) {
      if (k == taps / 2) continue;
      const Float8 step = tap_step * (static_cast<float>(k) - static_cast<float>(taps / 2));
      row += tap_weight[k] * covered(point.x + along.x * step, point.y + along.y * step, blur);
    }
    cover = select(round, cover, row);
  }
  seen.radiance = all(radiance_) * select(meets, min(cover, Float8(1)), Float8(0));
  return seen;
}

}  // namespace marketgen::render::raytrace
