#include "render/stage/texture.h"

#include <array>
#include <cmath>

namespace marketgen::render::raytrace {
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
std::uint32_t average(const std::uint32_t* texels, const FinerTexels& four) {
  std::uint32_t result = 0;
  for (unsigned shift = 0; shift < 24; shift += 8) {
    float sum = 0;
    for (const std::size_t i : four.at) {
      const auto channel = static_cast<float>((texels[i] >> shift) & 255U);
      sum += channel * channel;
    }
    result |= static_cast<std::uint32_t>(std::sqrt(sum * 0.25F) + 0.5F) << shift;
  }
  return result;
}

}  // namespace

Texture::Texture(const Image& image) {
  if (image.empty()) return;
  mips_ = MipChain(image.width, image.height);
  const auto& levels = mips_.levels();
  std::uint32_t* finest = mips_.texels(levels[0]);
  const std::size_t count =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  for (std::size_t i = 0; i < count; ++i)
    finest[i] = encode(&image.pixels[i * static_cast<std::size_t>(image.channels)]);
  for (std::size_t l = 1; l < levels.size(); ++l) {
    const std::uint32_t* finer = mips_.texels(levels[l - 1]);
    std::uint32_t* to = mips_.texels(levels[l]);
    for (int y = 0; y < levels[l].height; ++y) {
      for (int x = 0; x < levels[l].width; ++x)
        *to++ = average(finer, finer_texels(levels[l - 1], x, y));
    }
  }
}

Texture::Texture(BlockMips blocks, const std::optional<assets::LabelBars>& bars)
    : blocks_(std::move(blocks)) {
  if (bars) bars_ = std::make_shared<const PrintedBars>(*bars, width(), height());
}

Texture Texture::coarser(int levels) const {
  Texture texture;
  texture.mips_ = mips_.coarser(levels);
  texture.blocks_ = blocks_.coarser(levels);
  return texture;
}

BlockMips blocks_of(const Image& image) {
  const Texture plain(image);
  return plain.mips_.empty() ? BlockMips() : BlockMips(plain.mips_);
}

namespace {

// Undoes the encoding.
Float4 linear_light(__m128 bytes) {
  return Float4(_mm_mul_ps(_mm_mul_ps(bytes, bytes), _mm_set1_ps(1.0F / 65025.0F)));
}

}  // namespace

Float4 Texture::filtered(float u, float v, float lod) const {
  if (mips_.empty() && blocks_.empty()) return Float4(1.0F);
  if (bars_) {
    if (const std::optional<float> grey = bars_->sample(u, v, lod)) return Float4(*grey);
  }
  return linear_light(mips_.empty() ? blocks_.sample(u, v, lod) : mips_.sample(u, v, lod));
}

Float4 Texture::filtered_in_level(float u, float v, float lod) const {
  if (mips_.empty() && blocks_.empty()) return Float4(1.0F);
  if (bars_) {
    if (const std::optional<float> grey = bars_->sample(u, v, lod)) return Float4(*grey);
  }
  return linear_light(mips_.empty() ? blocks_.sample_level(u, v, lod)
                                    : mips_.sample_level(u, v, lod));
}

}  // namespace marketgen::render::raytrace
