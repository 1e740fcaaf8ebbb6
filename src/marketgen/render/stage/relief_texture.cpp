#include "render/stage/relief_texture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace marketgen::render::raytrace {
namespace {

constexpr int flat_size = 8;  // a level of so few texels has no relief left to see

// One texel while the levels are made: means of the tilt, of its square, and of alpha squared,
// which is what a microfacet lobe widens by.
struct Moments {
  float x = 0, y = 0, square = 0, alpha2 = 0, metallic = 0;
};

Moments mean_of(const std::vector<Moments>& finer, const FinerTexels& four) {
  Moments mean;
  for (const std::size_t i : four.at) {
    mean.x += finer[i].x / 4;
    mean.y += finer[i].y / 4;
    mean.square += finer[i].square / 4;
    mean.alpha2 += finer[i].alpha2 / 4;
    mean.metallic += finer[i].metallic / 4;
  }
  return mean;
}

std::uint32_t byte_of(float value) {
  return static_cast<std::uint32_t>(std::clamp(value, 0.0F, 1.0F) * 255 + 0.5F);
}

std::uint32_t encode(const Moments& m) {
  const float variance = std::max(0.0F, m.square - m.x * m.x - m.y * m.y);
  // Beckmann's alpha squared is twice the slopes' variance along one axis: the sum over both.
  const float alpha = std::sqrt(std::min(1.0F, m.alpha2 + variance));
  return byte_of(0.5F + 0.5F * m.x) | byte_of(0.5F + 0.5F * m.y) << 8 |
         byte_of(std::sqrt(alpha)) << 16 | byte_of(m.metallic) << 24;
}

std::vector<Moments> moments_of(const Image& image, int first) {
  std::vector<Moments> texels;
  const auto stride = static_cast<std::size_t>(image.channels);
  for (std::size_t i = static_cast<std::size_t>(first); i < image.pixels.size(); i += stride) {
    const std::uint8_t* from = &image.pixels[i];
    const auto tilt = [](std::uint8_t byte) {
      const float value = static_cast<float>(byte) / 127.5F - 1;
      return std::fabs(value) < 0.005F ? 0.0F : value;  // 128 stands for zero
    };
    Moments m;
    m.x = tilt(from[0]);
    m.y = tilt(from[1]);
    m.square = m.x * m.x + m.y * m.y;
    const float roughness = static_cast<float>(from[2]) / 255;
    m.alpha2 = roughness * roughness * roughness * roughness;
    m.metallic = static_cast<float>(from[3]) / 255;
    texels.push_back(m);
  }
  return texels;
}

}  // namespace

ReliefTexture::ReliefTexture(const Image& image, int first) : mips_(image.width, image.height) {
  std::vector<Moments> finer = moments_of(image, first);
  const auto& levels = mips_.levels();
  std::transform(finer.begin(), finer.end(), mips_.texels(levels[0]), encode);
  for (std::size_t l = 1; l < levels.size(); ++l) {
    if (levels[l].width >= flat_size) flat_lod_ = static_cast<float>(l);
    std::vector<Moments> coarser;
    for (int y = 0; y < levels[l].height; ++y) {
      for (int x = 0; x < levels[l].width; ++x)
        coarser.push_back(mean_of(finer, finer_texels(levels[l - 1], x, y)));
    }
    std::transform(coarser.begin(), coarser.end(), mips_.texels(levels[l]), encode);
    finer = std::move(coarser);
  }
  mean_ = sample(0.5F, 0.5F, static_cast<float>(levels.size()));
}

Relief ReliefTexture::decoded(const std::array<float, 4>& bytes) {
  constexpr float middle = 128;  // the byte that stands for no tilt
  return {
      (bytes[0] - middle) / 127.5F, (bytes[1] - middle) / 127.5F, bytes[2] / 255, bytes[3] / 255};
}

ReliefTexture ReliefTexture::coarser(int levels) const {
  ReliefTexture texture;
  texture.mips_ = mips_.coarser(levels);
  texture.mean_ = mean_;
  texture.flat_lod_ = std::max(0.0F, flat_lod_ - static_cast<float>(levels));
  return texture;
}

Relief ReliefTexture::sample(float u, float v, float lod) const {
  if (mips_.empty()) return {};
  alignas(16) std::array<float, 4> bytes;
  _mm_store_ps(bytes.data(), mips_.sample(u, v, lod));
  return decoded(bytes);
}

}  // namespace marketgen::render::raytrace
