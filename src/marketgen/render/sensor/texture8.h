// Look-ups in eight textures side by side: what Texture::filtered() and filtered_in_level() say of
// one point, for eight.
#pragma once
#include <array>

#include "render/sensor/float8.h"
#include "render/stage/texture.h"

namespace marketgen::render::raytrace {

// One point each; lanes that are not asked for have any texture that is there. None is empty.
struct TexturePoints {
  std::array<const Texture*, lane_count> textures;
  Float8 u, v, lod;
};

// Linear RGB.
Vec8 filtered(const TexturePoints& points, TextureDetail detail);

// The same of plain texels; four channels, 0..255.
struct TexelPoints {
  std::array<const MipChain*, lane_count> chains;
  Float8 u, v, lod;
};
std::array<Float8, 4> filtered(const TexelPoints& points);

}  // namespace marketgen::render::raytrace
