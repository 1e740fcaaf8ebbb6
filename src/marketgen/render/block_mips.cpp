#include "render/block_mips.h"

#include <squish.h>

#include <algorithm>
#include <array>

#include "base/result.h"

namespace marketgen::raytrace {
namespace {

constexpr int block_side = 4;

int blocks_across(int texels) {
  return (texels + block_side - 1) / block_side;
}

std::vector<MipChain::Level> block_levels(int width, int height) {
  std::vector<MipChain::Level> levels = mip_levels(width, height);
  std::size_t count = 0;
  for (MipChain::Level& level : levels) {
    level.offset = count;
    count += static_cast<std::size_t>(blocks_across(level.width) * blocks_across(level.height));
  }
  return levels;
}

// The 16 texels of a block, as bytes R G B A; rows and columns beyond the picture repeat its last.
std::array<std::uint32_t, 16> texels_of(const MipChain& mips,
                                        const MipChain::Level& level,
                                        int column,
                                        int row) {
  constexpr std::uint32_t opaque = 0xFF000000U;
  const std::uint32_t* texels = mips.texels(level);
  std::array<std::uint32_t, 16> block{};
  for (int i = 0; i < 16; ++i) {
    const int x = std::min(column * block_side + i % block_side, level.width - 1);
    const int y = std::min(row * block_side + i / block_side, level.height - 1);
    block[static_cast<std::size_t>(i)] = texels[y * level.width + x] | opaque;
  }
  return block;
}

std::uint64_t compressed(const std::array<std::uint32_t, 16>& block) {
  std::uint64_t bits = 0;
  squish::Compress(reinterpret_cast<const squish::u8*>(block.data()),
                   &bits,
                   squish::kDxt1 | squish::kColourRangeFit);
  return bits;
}

// 5, 6 and 5 bits as 0..255.
__m128 color_of(std::uint32_t bits) {
  const __m128i parts = _mm_and_si128(
      _mm_set_epi32(0, static_cast<int>(bits), static_cast<int>(bits), static_cast<int>(bits)),
      _mm_set_epi32(0, 0x1F, 0x7E0, 0xF800));
  return _mm_mul_ps(_mm_cvtepi32_ps(parts),
                    _mm_set_ps(0, 255.0F / 31, 255.0F / (63 * 32), 255.0F / (31 * 2048)));
}

// Shares of the second colour by the texel's two bits; blocks whose first colour is not the greater
// number have one mean and black.
constexpr float four_color_share[4] = {0, 1, 1.0F / 3, 2.0F / 3};
constexpr float three_color_share[4] = {0, 1, 0.5F, 0};

__m128 texel_of(std::uint64_t block, int x, int y) {
  const auto first = static_cast<std::uint32_t>(block & 0xFFFF);
  const auto second = static_cast<std::uint32_t>(block >> 16 & 0xFFFF);
  const unsigned mix = block >> (32 + 2 * (y * block_side + x)) & 3;
  const bool four = first > second;
  if (!four && mix == 3) return _mm_setzero_ps();
  const float share = four ? four_color_share[mix] : three_color_share[mix];
  return lerp(color_of(first), color_of(second), _mm_set1_ps(share));
}

}  // namespace

std::size_t BlockMips::block_count(int width, int height) {
  const MipChain::Level last = block_levels(width, height).back();
  return last.offset + 1;
}

BlockMips::BlockMips(const MipChain& texels)
    : levels_(block_levels(texels.width(), texels.height())) {
  blocks_.reserve(levels_.back().offset + 1);
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    const MipChain::Level& level = texels.levels()[l];
    // Even areas are common on packs: their blocks are alike, so the last one is kept at hand.
    std::array<std::uint32_t, 16> last{};
    std::uint64_t bits = compressed(last);
    for (int row = 0; row < blocks_across(level.height); ++row) {
      for (int column = 0; column < blocks_across(level.width); ++column) {
        const std::array<std::uint32_t, 16> block = texels_of(texels, level, column, row);
        if (block != last) bits = compressed(block);
        last = block;
        blocks_.push_back(bits);
      }
    }
  }
}

BlockMips::BlockMips(int width, int height, std::vector<std::uint64_t> blocks)
    : levels_(block_levels(width, height)), blocks_(std::move(blocks)) {
  if (blocks_.size() != levels_.back().offset + 1) fatal("blocks of another picture");
}

__m128 BlockMips::sample(float u, float v, float lod) const {
  return trilinear(levels_, u, v, lod, [this](const MipChain::Level& level, int x, int y) {
    const int column = x / block_side, row = y / block_side;
    const std::uint64_t block =
        blocks_[level.offset + static_cast<std::size_t>(row * blocks_across(level.width) + column)];
    return texel_of(block, x % block_side, y % block_side);
  });
}

}  // namespace marketgen::raytrace
