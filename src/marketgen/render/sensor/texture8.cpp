#include "render/sensor/texture8.h"

#include <algorithm>

namespace marketgen::render::raytrace {
namespace {

using MipLevels = std::vector<MipChain::Level>;

// One mip level of each lane's texture.
struct LevelLanes {
  std::array<const std::byte*, lane_count> texels;
  Int8 width, height;
  Mask8 blocks;  // BC1, else four bytes a texel
};

// Two neighbouring levels of each lane, and how far the second one counts.
struct LevelPairs {
  std::array<const MipLevels*, lane_count> levels;
  std::array<const std::byte*, lane_count> texels;
  std::array<std::int32_t, lane_count> blocks{};
  std::array<std::uint32_t, lane_count> first, second;
  Float8 between;

  LevelLanes lanes(const std::array<std::uint32_t, lane_count>& number) const {
    LevelLanes result;
    std::array<std::int32_t, lane_count> width, height;
    for (std::size_t k = 0; k < lane_count; ++k) {
      const MipChain::Level& level = (*levels[k])[number[k]];
      width[k] = level.width;
      height[k] = level.height;
      result.texels[k] = texels[k] + level.offset * (blocks[k] != 0 ? sizeof(std::uint64_t)
                                                                    : sizeof(std::uint32_t));
    }
    result.width = Int8::load(width.data());
    result.height = Int8::load(height.data());
    result.blocks = Int8::load(blocks.data()) > Int8(0);
    return result;
  }

  // Picks levels for what `levels` has by now.
  void choose(Float8 lod, TextureDetail detail) {
    std::array<float, lane_count> coarse;
    (detail == TextureDetail::level ? lod + 0.5F : lod).store(coarse.data());
    for (std::size_t k = 0; k < lane_count; ++k) {
      const auto last = static_cast<std::uint32_t>(levels[k]->size() - 1);
      coarse[k] = std::clamp(coarse[k], 0.0F, static_cast<float>(last));
      first[k] = static_cast<std::uint32_t>(coarse[k]);
      second[k] = std::min(first[k] + 1, last);
      coarse[k] -= static_cast<float>(first[k]);
    }
    between = Float8::load(coarse.data());
  }
};

// The four texels around a point and their weights: see BilinearTexels.
struct TexelLanes {
  std::array<Int8, 4> x, y;
  std::array<Float8, 4> weight;

  TexelLanes(const LevelLanes& level, Float8 u, Float8 v) {
    const Float8 across = u * to_float(level.width) - 0.5F,
                 down = v * to_float(level.height) - 0.5F;
    const Float8 left = rounded_down(across), top = rounded_down(down);
    const Float8 fx = across - left, fy = down - top;
    const Int8 column = to_int(left), row = to_int(top);
    const Int8 x0 = select(Int8(0) > column, level.width - 1, column);
    const Int8 x1 = select(level.width > column + 1, column + 1, Int8(0));
    const Int8 y0 = select(Int8(0) > row, level.height - 1, row);
    const Int8 y1 = select(level.height > row + 1, row + 1, Int8(0));
    x = {x0, x1, x0, x1};
    y = {y0, y0, y1, y1};
    weight = {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy};
  }
};

template <std::size_t channels>
std::array<Float8, channels> from_bytes(const LevelLanes& level, const TexelLanes& t) {
  std::array<Float8, channels> sum;
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<std::int32_t, lane_count> at, texel;
    select(level.blocks, Int8(0), t.y[i] * level.width + t.x[i]).store(at.data());
    for (std::size_t k = 0; k < lane_count; ++k)
      texel[k] = reinterpret_cast<const std::int32_t*>(level.texels[k])[at[k]];
    const Int8 bytes = Int8::load(texel.data());
    for (std::size_t c = 0; c < channels; ++c)
      sum[c] += to_float((bytes >> static_cast<int>(8 * c)) & 255) * t.weight[i];
  }
  return sum;
}

// How much of a block's first and second colour a texel has, by its two bits; from the fifth on: in
// blocks whose first colour is the greater number. See block_mips.cpp.
alignas(32) constexpr std::array<float, 8> first_share{1, 0, 0.5F, 0, 1, 0, 2.0F / 3, 1.0F / 3};
alignas(32) constexpr std::array<float, 8> second_share{0, 1, 0.5F, 0, 0, 1, 1.0F / 3, 2.0F / 3};

std::array<Float8, 3> from_blocks(const LevelLanes& level, const TexelLanes& t) {
  const Int8 stride = (level.width + 3) >> 2;
  const Float8 firsts = Float8::load(first_share.data()),
               seconds = Float8::load(second_share.data());
  const auto share = [](Float8 shares, Int8 index) {
    return Float8(_mm256_permutevar8x32_ps(shares.m, index.m));
  };
  std::array<Float8, 3> sum;
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<std::int32_t, lane_count> at;
    std::array<std::uint32_t, lane_count> colors, picks;
    select(level.blocks, (t.y[i] >> 2) * stride + (t.x[i] >> 2), Int8(0)).store(at.data());
    for (std::size_t k = 0; k < lane_count; ++k) {
      // A plain lane's last level is one texel of four bytes: no block is read there.
      const bool in_blocks = ((level.blocks.bits() >> k) & 1U) != 0;
      const std::uint64_t block =
          in_blocks ? reinterpret_cast<const std::uint64_t*>(level.texels[k])[at[k]] : 0;
      colors[k] = static_cast<std::uint32_t>(block);
      picks[k] = static_cast<std::uint32_t>(block >> 32);
    }
    const Int8 color = Int8::load(colors.data()), a = color & 0xFFFF, b = color >> 16;
    const Int8 pick = (Int8::load(picks.data()) >> ((((t.y[i] & 3) << 2) + (t.x[i] & 3)) << 1)) & 3;
    const Int8 index = pick + (select(a > b, Int8(4), Int8(0)));
    const Float8 of_a = share(firsts, index) * t.weight[i];
    const Float8 of_b = share(seconds, index) * t.weight[i];
    sum[0] += to_float(a >> 11) * of_a + to_float(b >> 11) * of_b;
    sum[1] += to_float((a >> 5) & 63) * of_a + to_float((b >> 5) & 63) * of_b;
    sum[2] += to_float(a & 31) * of_a + to_float(b & 31) * of_b;
  }
  return {sum[0] * (255.0F / 31), sum[1] * (255.0F / 63), sum[2] * (255.0F / 31)};
}

// Channels 0..255.
std::array<Float8, 3> bilinear(const LevelLanes& level, Float8 u, Float8 v) {
  const TexelLanes t(level, u, v);
  const unsigned in_blocks = level.blocks.bits();
  if (in_blocks == 0) return from_bytes<3>(level, t);
  std::array<Float8, 3> result = from_blocks(level, t);
  if (in_blocks == 255) return result;
  const std::array<Float8, 3> plain = from_bytes<3>(level, t);
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = select(level.blocks, result[c], plain[c]);
  return result;
}

Float8 repeated_lanes(Float8 x) {
  return min(x - rounded_down(x), Float8(0.9999999F));  // as mip_chain.h's
}

// Bars are drawn at every look-up.
void draw_bars(const TexturePoints& points, Vec8& color) {
  for (std::size_t k = 0; k < lane_count; ++k) {
    const PrintedBars* bars = points.textures[k]->bars();
    if (bars == nullptr) continue;
    if (const std::optional<float> grey = bars->sample(points.u[k], points.v[k], points.lod[k]))
      set_lane(color, k, {*grey, *grey, *grey});
  }
}

}  // namespace

Vec8 filtered(const TexturePoints& points, TextureDetail detail) {
  LevelPairs pairs;
  for (std::size_t k = 0; k < lane_count; ++k) {
    const Texture& texture = *points.textures[k];
    const bool plain = !texture.mips().empty();
    pairs.levels[k] = plain ? &texture.mips().levels() : &texture.blocks().levels();
    pairs.texels[k] =
        plain
            ? reinterpret_cast<const std::byte*>(texture.mips().texels(texture.mips().levels()[0]))
            : reinterpret_cast<const std::byte*>(texture.blocks().blocks().data());
    pairs.blocks[k] = plain ? 0 : 1;
  }
  pairs.choose(points.lod, detail);
  const Float8 u = repeated_lanes(points.u), v = repeated_lanes(points.v);
  std::array<Float8, 3> c = bilinear(pairs.lanes(pairs.first), u, v);
  if (detail == TextureDetail::full && (pairs.between > Float8(0)).any()) {
    const std::array<Float8, 3> coarser = bilinear(pairs.lanes(pairs.second), u, v);
    for (std::size_t i = 0; i < 3; ++i)
      c[i] += pairs.between * (coarser[i] - c[i]);
  }
  // Undoes the square root of the encoding.
  const Float8 unit = 1.0F / 65025.0F;
  Vec8 color{c[0] * c[0] * unit, c[1] * c[1] * unit, c[2] * c[2] * unit};
  draw_bars(points, color);
  return color;
}

std::array<Float8, 4> filtered(const TexelPoints& points) {
  LevelPairs pairs;
  for (std::size_t k = 0; k < lane_count; ++k) {
    pairs.levels[k] = &points.chains[k]->levels();
    pairs.texels[k] =
        reinterpret_cast<const std::byte*>(points.chains[k]->texels(points.chains[k]->levels()[0]));
  }
  pairs.choose(points.lod, TextureDetail::full);
  const Float8 u = repeated_lanes(points.u), v = repeated_lanes(points.v);
  const LevelLanes fine = pairs.lanes(pairs.first), coarse = pairs.lanes(pairs.second);
  std::array<Float8, 4> c = from_bytes<4>(fine, TexelLanes(fine, u, v));
  const std::array<Float8, 4> coarser = from_bytes<4>(coarse, TexelLanes(coarse, u, v));
  for (std::size_t i = 0; i < 4; ++i)
    c[i] += pairs.between * (coarser[i] - c[i]);
  return c;
}

}  // namespace marketgen::render::raytrace
