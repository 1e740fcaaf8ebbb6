// Four bytes a texel, with mip levels and trilinear look-up: what colour and relief textures share.
// What the bytes mean is their owner's business; levels are filled from the finest by him.
#pragma once
#include <immintrin.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace marketgen::raytrace {

class MipChain {
 public:
  struct Level {
    int width = 1, height = 1;
    std::size_t offset = 0;
  };

  MipChain() = default;
  // Every level down to one texel, all zero.
  MipChain(int width, int height);

  // Channels 0..255 at (u, v); (0, 0) is the top left, both axes repeat. `lod` 0 = the image
  // itself, 1 = half its size. Precondition: not empty.
  __m128 sample(float u, float v, float lod) const;

  bool empty() const { return levels_.empty(); }
  const std::vector<Level>& levels() const { return levels_; }
  std::uint32_t* texels(const Level& level) { return texels_.data() + level.offset; }
  const std::uint32_t* texels(const Level& level) const { return texels_.data() + level.offset; }
  int width() const { return empty() ? 1 : levels_[0].width; }
  int height() const { return empty() ? 1 : levels_[0].height; }
  std::size_t bytes() const { return texels_.size() * sizeof(texels_[0]); }

 private:
  std::vector<std::uint32_t> texels_;
  std::vector<Level> levels_;
};

// The levels of a chain that starts with this size.
std::vector<MipChain::Level> mip_levels(int width, int height);

inline __m128 lerp(__m128 a, __m128 b, __m128 t) {
  return _mm_add_ps(a, _mm_mul_ps(t, _mm_sub_ps(b, a)));
}

// Bilinear look-up in one level, u and v in [0, 1): `texel(level, x, y)` reads one texel.
template <class Texel>
__m128 bilinear(const MipChain::Level& level, float u, float v, const Texel& texel) {
  const float x = u * static_cast<float>(level.width) - 0.5F;
  const float y = v * static_cast<float>(level.height) - 0.5F;
  const int left = static_cast<int>(std::floor(x));
  const int top = static_cast<int>(std::floor(y));
  const int x0 = left < 0 ? level.width - 1 : left;
  const int y0 = top < 0 ? level.height - 1 : top;
  const int x1 = left + 1 < level.width ? left + 1 : 0;
  const int y1 = top + 1 < level.height ? top + 1 : 0;
  const __m128 fx = _mm_set1_ps(x - static_cast<float>(left));
  const __m128 fy = _mm_set1_ps(y - static_cast<float>(top));
  const __m128 upper = lerp(texel(level, x0, y0), texel(level, x1, y0), fx);
  const __m128 lower = lerp(texel(level, x0, y1), texel(level, x1, y1), fx);
  return lerp(upper, lower, fy);
}

// Trilinear look-up, see MipChain::sample.
template <class Texel>
__m128 trilinear(
    const std::vector<MipChain::Level>& levels, float u, float v, float lod, const Texel& texel) {
  u -= std::floor(u);
  v -= std::floor(v);
  u = std::min(u, 0.9999999F);  // a tiny negative number wraps to exactly 1
  v = std::min(v, 0.9999999F);
  const float coarse = std::clamp(lod, 0.0F, static_cast<float>(levels.size() - 1));
  const auto first = static_cast<std::size_t>(coarse);
  const float between = coarse - static_cast<float>(first);
  const __m128 value = bilinear(levels[first], u, v, texel);
  if (between <= 0 || first + 1 >= levels.size()) return value;
  return lerp(value, bilinear(levels[first + 1], u, v, texel), _mm_set1_ps(between));
}

// The four texels of the finer level under texel (x, y) of the next; sides of odd length repeat
// their last one.
struct FinerTexels {
  std::size_t at[4];
};
FinerTexels finer_texels(const MipChain::Level& finer, int x, int y);

}  // namespace marketgen::raytrace
