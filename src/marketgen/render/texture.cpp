#include "render/texture.h"

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace marketgen::raytrace {
namespace {

// Square-root encoding of an sRGB byte: round(255 * sqrt(linear)).
std::array<std::uint8_t, 256> make_encoding() {
  std::array<std::uint8_t, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double s = static_cast<double>(i) / 255;
    const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    table[i] = static_cast<std::uint8_t>(std::lround(255 * std::sqrt(linear)));
  }
  return table;
}

std::uint32_t encode(const std::uint8_t* rgb) {
  static const std::array<std::uint8_t, 256> table = make_encoding();
  return static_cast<std::uint32_t>(table[rgb[0]]) |
         static_cast<std::uint32_t>(table[rgb[1]]) << 8 |
         static_cast<std::uint32_t>(table[rgb[2]]) << 16;
}

// Mean of four texels in linear light.
std::uint32_t average(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  std::uint32_t result = 0;
  for (unsigned shift = 0; shift < 24; shift += 8) {
    float sum = 0;
    for (const std::uint32_t texel : {a, b, c, d}) {
      const auto channel = static_cast<float>((texel >> shift) & 255U);
      sum += channel * channel;
    }
    result |= static_cast<std::uint32_t>(std::sqrt(sum * 0.25F) + 0.5F) << shift;
  }
  return result;
}

__m128 unpack(std::uint32_t texel) {
  return _mm_cvtepi32_ps(_mm_cvtepu8_epi32(_mm_cvtsi32_si128(static_cast<int>(texel))));
}

__m128 lerp(__m128 a, __m128 b, __m128 t) {
  return _mm_add_ps(a, _mm_mul_ps(t, _mm_sub_ps(b, a)));
}

// Bilinear look-up in one level; u and v in [0, 1).
__m128 bilinear(const std::uint32_t* texels, int width, int height, float u, float v) {
  const float x = u * static_cast<float>(width) - 0.5F;
  const float y = v * static_cast<float>(height) - 0.5F;
  const int left = static_cast<int>(std::floor(x));
  const int top = static_cast<int>(std::floor(y));
  const int x0 = left < 0 ? width - 1 : left;
  const int y0 = top < 0 ? height - 1 : top;
  const int x1 = left + 1 < width ? left + 1 : 0;
  const int y1 = top + 1 < height ? top + 1 : 0;
  const __m128 fx = _mm_set1_ps(x - static_cast<float>(left));
  const __m128 fy = _mm_set1_ps(y - static_cast<float>(top));
  const __m128 upper = lerp(unpack(texels[y0 * width + x0]), unpack(texels[y0 * width + x1]), fx);
  const __m128 lower = lerp(unpack(texels[y1 * width + x0]), unpack(texels[y1 * width + x1]), fx);
  return lerp(upper, lower, fy);
}

}  // namespace

Texture::Texture(const Image& image) {
  if (image.empty()) return;
  const std::size_t count =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  texels_.reserve(count * 4 / 3 + 16);
  levels_.push_back({image.width, image.height, 0});
  for (std::size_t i = 0; i < count; ++i) {
    texels_.push_back(encode(&image.pixels[i * static_cast<std::size_t>(image.channels)]));
  }
  while (levels_.back().width > 1 || levels_.back().height > 1)
    add_level(levels_.back());
}

void Texture::add_level(const Level& finer_level) {
  const Level finer = finer_level;
  const Level level{std::max(1, finer.width / 2), std::max(1, finer.height / 2), texels_.size()};
  for (int y = 0; y < level.height; ++y) {
    const int y0 = std::min(2 * y, finer.height - 1), y1 = std::min(2 * y + 1, finer.height - 1);
    for (int x = 0; x < level.width; ++x) {
      const int x0 = std::min(2 * x, finer.width - 1), x1 = std::min(2 * x + 1, finer.width - 1);
      const auto at = [&](int column, int row) {
        return texels_[finer.offset + static_cast<std::size_t>(row * finer.width + column)];
      };
      texels_.push_back(average(at(x0, y0), at(x1, y0), at(x0, y1), at(x1, y1)));
    }
  }
  levels_.push_back(level);
}

Vec3f Texture::sample(float u, float v, float lod) const {
  if (levels_.empty()) return {1, 1, 1};
  u -= std::floor(u);
  v -= std::floor(v);
  u = std::min(u, 0.9999999F);  // a tiny negative number wraps to exactly 1
  v = std::min(v, 0.9999999F);
  const float coarse = std::clamp(lod, 0.0F, static_cast<float>(levels_.size() - 1));
  const auto first = static_cast<std::size_t>(coarse);
  const float between = coarse - static_cast<float>(first);
  const Level& fine = levels_[first];
  __m128 color = bilinear(&texels_[fine.offset], fine.width, fine.height, u, v);
  if (between > 0 && first + 1 < levels_.size()) {
    const Level& next = levels_[first + 1];
    color = lerp(color,
                 bilinear(&texels_[next.offset], next.width, next.height, u, v),
                 _mm_set1_ps(between));
  }
  alignas(16) std::array<float, 4> rgb;
  _mm_store_ps(rgb.data(), _mm_mul_ps(_mm_mul_ps(color, color), _mm_set1_ps(1.0F / 65025.0F)));
  return {rgb[0], rgb[1], rgb[2]};
}

}  // namespace marketgen::raytrace
