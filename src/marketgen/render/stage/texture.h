// Textures: linear light in square-root encoding with mip levels; trilinear look-up. Either eight
// bits a channel, or BC1 blocks with the bars of a code beside them.
#pragma once
#include <memory>
#include <optional>

#include "geometry/image.h"
#include "geometry/vector.h"
#include "render/path/float4.h"
#include "render/stage/block_mips.h"
#include "render/stage/mip_chain.h"
#include "render/stage/printed_bars.h"

namespace marketgen::render::raytrace {

// full: textures between mip levels, and their relief. level: textures from one mip level, and the
// relief's mean gloss; half the cost, for what is small or seen in a mirror. none: the material's
// own colour and gloss, where nobody looks at them.
enum class TextureDetail { full, level, none };

class Texture {
 public:
  Texture() = default;
  // Of the first three channels of `image`.
  explicit Texture(const Image& image);
  // Of a picture that `blocks_of` made.
  explicit Texture(BlockMips blocks, const std::optional<assets::LabelBars>& bars = std::nullopt);

  // Linear RGB at (u, v); (0, 0) is the top left, both axes repeat. `lod` 0 = the image itself, 1 =
  // half its size.
  Vec3f sample(float u, float v, float lod) const { return filtered(u, v, lod).xyz(); }
  Float4 filtered(float u, float v, float lod) const;
  // From the nearest level alone: half the work, and levels change in steps.
  Float4 filtered_in_level(float u, float v, float lod) const;
  Vec3f mean() const { return sample(0.5F, 0.5F, 1e9F); }
  // Without its finest mip levels, and without bars: as it is seen from afar.
  Texture coarser(int levels) const;
  bool empty() const { return mips_.empty() && blocks_.empty(); }
  int width() const { return mips_.empty() ? blocks_.width() : mips_.width(); }
  int height() const { return mips_.empty() ? blocks_.height() : mips_.height(); }
  std::size_t bytes() const { return mips_.bytes() + blocks_.bytes(); }
  // One of the two is empty.
  const MipChain& mips() const { return mips_; }
  const BlockMips& blocks() const { return blocks_; }
  const PrintedBars* bars() const { return bars_.get(); }

  friend BlockMips blocks_of(const Image& image);

 private:
  MipChain mips_;
  BlockMips blocks_;
  std::shared_ptr<const PrintedBars> bars_;  // few have them, and they are large
};

// The picture in the encoding of textures, compressed.
BlockMips blocks_of(const Image& image);

}  // namespace marketgen::render::raytrace
