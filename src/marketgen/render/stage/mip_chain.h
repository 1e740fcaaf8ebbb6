// Four bytes a texel, with mip levels and trilinear look-up: what colour and relief textures share.
// What the bytes mean is their owner's business; levels are filled from the finest by him.
#pragma once
#include <immintrin.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace marketgen::render::raytrace {

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
  // From the nearest level alone: half the work.
  __m128 sample_level(float u, float v, float lod) const;

  // Without its finest levels, as a chain of its own; the last level stays.
  MipChain coarser(int levels) const;

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

// The four texels around a point and their weights: upper left, upper right, lower left, lower
// right.
struct BilinearTexels {
  int x0, x1, y0, y1;
  float weight[4];
};
// `u` and `v` in [0, 1); both axes repeat.
inline BilinearTexels bilinear_texels(const MipChain::Level& level, float u, float v) {
  const float x = u * static_cast<float>(level.width) - 0.5F;
  const float y = v * static_cast<float>(level.height) - 0.5F;
  const int left = static_cast<int>(std::floor(x));
  const int top = static_cast<int>(std::floor(y));
  const float fx = x - static_cast<float>(left), fy = y - static_cast<float>(top);
  return {left < 0 ? level.width - 1 : left,
          left + 1 < level.width ? left + 1 : 0,
          top < 0 ? level.height - 1 : top,
          top + 1 < level.height ? top + 1 : 0,
          {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy}};
}

// Into [0, 1).
inline float repeated(float x) {
  return std::min(x - std::floor(x), 0.9999999F);  // a tiny negative number wraps to exactly 1
}

// Trilinear look-up, see MipChain::sample; `bilinear(level, u, v)` reads one level.
template <class Bilinear>
__m128 trilinear(const std::vector<MipChain::Level>& levels,
                 float u,
                 float v,
                 float lod,
                 const Bilinear& bilinear) {
  u = repeated(u);
  v = repeated(v);
  const float coarse = std::clamp(lod, 0.0F, static_cast<float>(levels.size() - 1));
  const auto first = static_cast<std::size_t>(coarse);
  const float between = coarse - static_cast<float>(first);
  const __m128 value = bilinear(levels[first], u, v);
  if (between <= 0 || first + 1 >= levels.size()) return value;
  return lerp(value, bilinear(levels[first + 1], u, v), _mm_set1_ps(between));
}

template <class Bilinear>
__m128 nearest_level(const std::vector<MipChain::Level>& levels,
                     float u,
                     float v,
                     float lod,
                     const Bilinear& bilinear) {
  const float coarse = std::clamp(lod + 0.5F, 0.0F, static_cast<float>(levels.size() - 1));
  return bilinear(levels[static_cast<std::size_t>(coarse)], repeated(u), repeated(v));
}

// The four texels of the finer level under texel (x, y) of the next; sides of odd length repeat
// their last one.
struct FinerTexels {
  std::size_t at[4];
};
FinerTexels finer_texels(const MipChain::Level& finer, int x, int y);

}  // namespace marketgen::render::raytrace
