#include "render/stage/block_mips.h"

#include <squish.h>

#include <algorithm>
#include <array>

#include "base/result.h"

namespace marketgen::render::raytrace {
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

// How much of the first and of the second colour a texel has, by its two bits. Blocks whose first
// colour is not the greater number have one mean and black.
struct ColorShares {
  float first, second;
};
constexpr ColorShares shares[2][4] = {{{1, 0}, {0, 1}, {0.5F, 0.5F}, {0, 0}},
                                      {{1, 0}, {0, 1}, {2.0F / 3, 1.0F / 3}, {1.0F / 3, 2.0F / 3}}};

// Texels of one block added up with weights: what their two bits say is summed before any colour is
// unpacked.
class BlockSum {
 public:
  explicit BlockSum(std::uint64_t block)
      : block_(block), shares_(shares[(block & 0xFFFF) > (block >> 16 & 0xFFFF) ? 1 : 0]) {}
  void add(int x, int y, float weight) {
    const ColorShares& share = shares_[block_ >> (32 + 2 * (y * block_side + x)) & 3];
    first_ += weight * share.first;
    second_ += weight * share.second;
  }
  __m128 color() const {
    const auto of = [](std::uint64_t bits, float share) {
      return _mm_mul_ps(color_of(static_cast<std::uint32_t>(bits & 0xFFFF)), _mm_set1_ps(share));
    };
    return _mm_add_ps(of(block_, first_), of(block_ >> 16, second_));
  }

 private:
  std::uint64_t block_;
  const ColorShares* shares_;
  float first_ = 0, second_ = 0;
};

__m128 bilinear_in_blocks(const std::uint64_t* blocks,
                          const MipChain::Level& level,
                          const BilinearTexels& t) {
  const int stride = blocks_across(level.width);
  const auto sum_of = [&](int x, int y) {
    return BlockSum(blocks[static_cast<std::size_t>(y / block_side * stride + x / block_side)]);
  };
  const auto part = [](int at) { return at % block_side; };
  const bool one_column = t.x0 / block_side == t.x1 / block_side;
  const bool one_row = t.y0 / block_side == t.y1 / block_side;
  if (one_column && one_row) {
    BlockSum sum = sum_of(t.x0, t.y0);
    sum.add(part(t.x0), part(t.y0), t.weight[0]);
    sum.add(part(t.x1), part(t.y0), t.weight[1]);
    sum.add(part(t.x0), part(t.y1), t.weight[2]);
    sum.add(part(t.x1), part(t.y1), t.weight[3]);
    return sum.color();
  }
  if (one_column) {
    BlockSum upper = sum_of(t.x0, t.y0), lower = sum_of(t.x0, t.y1);
    upper.add(part(t.x0), part(t.y0), t.weight[0]);
    upper.add(part(t.x1), part(t.y0), t.weight[1]);
    lower.add(part(t.x0), part(t.y1), t.weight[2]);
    lower.add(part(t.x1), part(t.y1), t.weight[3]);
    return _mm_add_ps(upper.color(), lower.color());
  }
  BlockSum left = sum_of(t.x0, t.y0), right = sum_of(t.x1, t.y0);
  left.add(part(t.x0), part(t.y0), t.weight[0]);
  right.add(part(t.x1), part(t.y0), t.weight[1]);
  if (one_row) {
    left.add(part(t.x0), part(t.y1), t.weight[2]);
    right.add(part(t.x1), part(t.y1), t.weight[3]);
    return _mm_add_ps(left.color(), right.color());
  }
  BlockSum low_left = sum_of(t.x0, t.y1), low_right = sum_of(t.x1, t.y1);
  low_left.add(part(t.x0), part(t.y1), t.weight[2]);
  low_right.add(part(t.x1), part(t.y1), t.weight[3]);
  return _mm_add_ps(_mm_add_ps(left.color(), right.color()),
                    _mm_add_ps(low_left.color(), low_right.color()));
}

}  // namespace

BlockMips BlockMips::coarser(int levels) const {
  if (empty()) return {};
  const MipChain::Level& first =
      levels_[std::min(static_cast<std::size_t>(levels), levels_.size() - 1)];
  return {first.width,
          first.height,
          {blocks_.begin() + static_cast<std::ptrdiff_t>(first.offset), blocks_.end()}};
}

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
  return trilinear(levels_, u, v, lod, [this](const MipChain::Level& level, float x, float y) {
    return bilinear_in_blocks(blocks_.data() + level.offset, level, bilinear_texels(level, x, y));
  });
}

__m128 BlockMips::sample_level(float u, float v, float lod) const {
  return nearest_level(levels_, u, v, lod, [this](const MipChain::Level& level, float x, float y) {
    return bilinear_in_blocks(blocks_.data() + level.offset, level, bilinear_texels(level, x, y));
  });
}

}  // namespace marketgen::render::raytrace
