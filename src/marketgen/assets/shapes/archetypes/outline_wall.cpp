#include "assets/shapes/archetypes/outline_wall.h"

#include <algorithm>
#include <cmath>

namespace marketgen::assets {
namespace {

Vec3f place_of(const OutlinePoint& p, const WallLevel& level) {
  return {p.at.x - p.out.x * level.inset_m, p.at.y - p.out.y * level.inset_m, level.z};
}

// Height of each level on the print: 0 at the highest printed level, 1 at the lowest.
std::vector<float> print_heights(const PackBuilder& pack, const std::vector<WallLevel>& levels) {
  float low = 1e9F, high = -1e9F;
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    if (!pack.is_print(levels[i].surface)) continue;
    low = std::min(low, levels[i].z);
    high = std::max(high, levels[i + 1].z);
  }
  std::vector<float> heights;
  for (const WallLevel& level : levels)
    heights.push_back(high > low ? std::clamp((high - level.z) / (high - low), 0.0F, 1.0F) : 0.0F);
  return heights;
}

void add_bands(PackBuilder& pack,
               const OutlineSide& side,
               const std::vector<WallLevel>& levels,
               const std::vector<float>& heights) {
  const std::vector<OutlinePoint>& points = side.points;
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    const std::uint16_t surface = levels[i].surface;
    const Panel* panel = pack.is_print(surface) ? side.panel : nullptr;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      const auto corner = [&](std::size_t level, std::size_t at) {
        const float u = points[at].along / points.back().along;
        return Corner{place_of(points[at], levels[level]), uv_in(panel, u, heights[level])};
      };
      pack.add_quad(
          corner(i, k), corner(i, k + 1), corner(i + 1, k + 1), corner(i + 1, k), surface);
    }
  }
}

void add_covers(PackBuilder& pack,
                const OutlineSide& side,
                const std::vector<WallLevel>& levels,
                Vec2f middle) {
  const WallLevel &low = levels.front(), &high = levels.back();
  const Corner foot{{middle.x, middle.y, low.z}, {}}, roof{{middle.x, middle.y, high.z}, {}};
  const auto rim = [&](std::size_t at, const WallLevel& level) {
    return Corner{place_of(side.points[at], level), {1, 1}};
  };
  for (std::size_t k = 0; k + 1 < side.points.size(); ++k) {
    pack.add_triangle(foot, rim(k + 1, low), rim(k, low), high.surface);
    pack.add_triangle(roof, rim(k, high), rim(k + 1, high), high.surface);
  }
}

}  // namespace

void measure(OutlineSide& side) {
  for (std::size_t i = 1; i < side.points.size(); ++i) {
    const Vec2f step = side.points[i].at - side.points[i - 1].at;
    side.points[i].along = side.points[i - 1].along + std::sqrt(step.x * step.x + step.y * step.y);
  }
}

void add_outline_wall(PackBuilder& pack,
                      const std::vector<OutlineSide>& sides,
                      const std::vector<WallLevel>& levels,
                      Vec2f middle) {
  const std::vector<float> heights = print_heights(pack, levels);
  for (const OutlineSide& side : sides) {
    add_bands(pack, side, levels, heights);
    add_covers(pack, side, levels, middle);
  }
}

}  // namespace marketgen::assets
