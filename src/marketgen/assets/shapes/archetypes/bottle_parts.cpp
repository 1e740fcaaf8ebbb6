#include "assets/shapes/archetypes/bottle_parts.h"

#include <algorithm>

namespace marketgen::assets {
namespace {

// The cubic through b and c whose slopes are those of the secants beside them, without overshoot: a
// level that repeats its neighbour's value holds it (Fritsch and Carlson's condition, simplified).
float curve_through(std::span<const BodyLevel> levels,
                    float BodyLevel::*value,
                    std::size_t i,
                    float t) {
  const BodyLevel &b = levels[i], &c = levels[i + 1];
  const float span = c.z - b.z, secant = (c.*value - b.*value) / span;
  const auto slope = [&](std::size_t k) {
    if (k == 0 || k + 1 == levels.size()) return secant;
    const BodyLevel &before = levels[k - 1], &at = levels[k], &after = levels[k + 1];
    const float low = (at.*value - before.*value) / (at.z - before.z);
    const float high = (after.*value - at.*value) / (after.z - at.z);
    return low * high <= 0 ? 0.0F : 2 * low * high / (low + high);
  };
  const float t2 = t * t, t3 = t2 * t;
  return b.*value * (2 * t3 - 3 * t2 + 1) + slope(i) * span * (t3 - 2 * t2 + t) +
         c.*value * (3 * t2 - 2 * t3) + slope(i + 1) * span * (t3 - t2);
}

BodyLevel level_at(std::span<const BodyLevel> levels, float z) {
  std::size_t i = 0;
  while (i + 2 < levels.size() && levels[i + 1].z < z)
    ++i;
  const float t = std::clamp((z - levels[i].z) / (levels[i + 1].z - levels[i].z), 0.0F, 1.0F);
  return {z,
          curve_through(levels, &BodyLevel::left, i, t),
          curve_through(levels, &BodyLevel::right, i, t),
          curve_through(levels, &BodyLevel::depth, i, t)};
}

// Every level, two between each pair that differs, and the label's edges; rising.
std::vector<float> heights_of(std::span<const BodyLevel> levels, float label_low, float high) {
  std::vector<float> heights{label_low, high};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    heights.push_back(levels[i].z);
    if (i + 1 == levels.size()) break;
    const BodyLevel &a = levels[i], &b = levels[i + 1];
    const bool straight = a.left == b.left && a.right == b.right && a.depth == b.depth;
    if (straight) continue;
    for (const float t : {1.0F / 3, 2.0F / 3})
      heights.push_back(a.z + (b.z - a.z) * t);
  }
  std::sort(heights.begin(), heights.end());
  heights.erase(
      std::unique(heights.begin(), heights.end(), [](float a, float b) { return b - a < 1e-4F; }),
      heights.end());
  return heights;
}

}  // namespace

LoftStyle labelled_style(const LabelZone& zone, std::uint16_t body, int triangles) {
  LoftStyle style = smooth_style;
  style.triangles = triangles;
  style.label_arc = zone.arc;
  style.beside = body;
  return style;
}

std::vector<Section> blown_body(const PackBuilder& pack,
                                std::span<const BodyLevel> levels,
                                const LabelZone& zone,
                                std::uint16_t body,
                                std::uint16_t print) {
  const float h = pack.height(), low = zone.low_m / h, high = zone.high_m / h;
  std::vector<Section> sections;
  for (const float z : heights_of(levels, low, high)) {
    const BodyLevel level = level_at(levels, z);
    const float neckwards = std::clamp((z - high) / (levels.back().z - high), 0.0F, 1.0F);
    sections.push_back({.z = z * h,
                        .half_width = (level.left + level.right) * pack.width() / 4,
                        .half_depth = level.depth * pack.depth() / 2,
                        .surface = z >= low && z < high ? print : body,
                        .roundness = zone.roundness + (1 - zone.roundness) * neckwards,
                        .x = (level.right - level.left) * pack.width() / 4});
  }
  return sections;
}

float cap_low_of(float low, float top) {
  return low + 0.35F * (top - low);
}

void add_screw_cap(
    Profile& profile, float low, float top, float radius_m, std::uint16_t neck, std::uint16_t cap) {
  const float span = top - low;
  const float cap_low = cap_low_of(low, top);
  profile.use(neck).neck(low, 0.86F * radius_m).neck(low + 0.10F * span, 0.86F * radius_m);
  profile.neck(low + 0.14F * span, 1.12F * radius_m).neck(low + 0.18F * span, 1.12F * radius_m);
  profile.neck(low + 0.22F * span, 0.90F * radius_m);
  profile.use(cap).neck(cap_low, radius_m).neck(top - 0.08F * span, 0.98F * radius_m);
  profile.neck(top, 0.88F * radius_m).pole(top);
}

}  // namespace marketgen::assets
