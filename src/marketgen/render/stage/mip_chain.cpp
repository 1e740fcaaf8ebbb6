#include "render/stage/mip_chain.h"

#include <algorithm>

namespace marketgen::render::raytrace {
std::vector<MipChain::Level> mip_levels(int width, int height) {
  std::vector<MipChain::Level> levels;
  std::size_t count = 0;
  for (;;) {
    levels.push_back({width, height, count});
    count += static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (width == 1 && height == 1) return levels;
    width = std::max(1, width / 2);
    height = std::max(1, height / 2);
  }
}

MipChain::MipChain(int width, int height) : levels_(mip_levels(width, height)) {
  texels_.resize(levels_.back().offset + 1);
}

MipChain MipChain::coarser(int levels) const {
  if (empty()) return {};
  const std::size_t first = std::min(static_cast<std::size_t>(levels), levels_.size() - 1);
  MipChain chain(levels_[first].width, levels_[first].height);
  std::copy(texels(levels_[first]), texels_.data() + texels_.size(), chain.texels_.begin());
  return chain;
}

namespace {

inline __m128 bilinear_in_bytes(const std::uint32_t* texels,
                                const MipChain::Level& level,
                                const BilinearTexels& t) {
  const auto weighted = [&](int x, int y, float weight) {
    const std::uint32_t texel = texels[static_cast<std::size_t>(y * level.width + x)];
    const __m128i bytes = _mm_cvtsi32_si128(static_cast<int>(texel));
    return _mm_mul_ps(_mm_cvtepi32_ps(_mm_cvtepu8_epi32(bytes)), _mm_set1_ps(weight));
  };
  return _mm_add_ps(
      _mm_add_ps(weighted(t.x0, t.y0, t.weight[0]), weighted(t.x1, t.y0, t.weight[1])),
      _mm_add_ps(weighted(t.x0, t.y1, t.weight[2]), weighted(t.x1, t.y1, t.weight[3])));
}

}  // namespace

__m128 MipChain::sample(float u, float v, float lod) const {
  return trilinear(levels_, u, v, lod, [this](const Level& level, float x, float y) {
    return bilinear_in_bytes(texels(level), level, bilinear_texels(level, x, y));
  });
}

__m128 MipChain::sample_level(float u, float v, float lod) const {
  return nearest_level(levels_, u, v, lod, [this](const Level& level, float x, float y) {
    return bilinear_in_bytes(texels(level), level, bilinear_texels(level, x, y));
  });
}

FinerTexels finer_texels(const MipChain::Level& finer, int x, int y) {
  const int x0 = std::min(2 * x, finer.width - 1), x1 = std::min(2 * x + 1, finer.width - 1);
  const int y0 = std::min(2 * y, finer.height - 1), y1 = std::min(2 * y + 1, finer.height - 1);
  const auto at = [&](int column, int row) {
    return static_cast<std::size_t>(row * finer.width + column);
  };
  return {{at(x0, y0), at(x1, y0), at(x0, y1), at(x1, y1)}};
}

}  // namespace marketgen::render::raytrace
