// Mip levels in BC1 blocks: half a byte a texel, read where they lie.
//
// A block holds 4 x 4 texels as two colours of 5, 6 and 5 bits and two bits a texel that mix them
// (Microsoft, "BC1 format"). Encoded by libsquish, decoded here one texel at a time.
#pragma once
#include <cstdint>
#include <vector>

#include "render/stage/mip_chain.h"

namespace marketgen::render::raytrace {

class BlockMips {
 public:
  BlockMips() = default;
  // Of the first three channels of `texels`.
  explicit BlockMips(const MipChain& texels);
  // From blocks that were kept; their number must be block_count(width, height).
  BlockMips(int width, int height, std::vector<std::uint64_t> blocks);

  // Channels 0..255, as MipChain's.
  __m128 sample(float u, float v, float lod) const;
  __m128 sample_level(float u, float v, float lod) const;

  // Without its finest levels; the last stays.
  BlockMips coarser(int levels) const;

  bool empty() const { return blocks_.empty(); }
  int width() const { return empty() ? 1 : levels_[0].width; }
  int height() const { return empty() ? 1 : levels_[0].height; }
  const std::vector<MipChain::Level>& levels() const { return levels_; }  // offsets count blocks
  const std::vector<std::uint64_t>& blocks() const { return blocks_; }
  std::size_t bytes() const { return blocks_.size() * sizeof(blocks_[0]); }

  static std::size_t block_count(int width, int height);  // of all levels

 private:
  std::vector<MipChain::Level> levels_;
  std::vector<std::uint64_t> blocks_;
};

}  // namespace marketgen::render::raytrace
