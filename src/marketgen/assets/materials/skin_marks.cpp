#include "assets/materials/skin_marks.h"

#include <algorithm>

namespace marketgen::assets {
namespace {

// Maps every value of a field.
template <class Function>
TextureField mapped(TextureField field, Function function) {
  for (float& value : field.values)
    value = function(value);
  return field;
}

template <class Function>
TextureField combined(TextureField a, const TextureField& b, Function function) {
  for (std::size_t i = 0; i < a.values.size(); ++i)
    a.values[i] = function(a.values[i], b.values[i]);
  return a;
}

TextureField streaks(int w, int h, const Seed& seed) {
  const TextureField fine = noise_field(w, h, {64, 3, 3, 0.7F}, seed.child("fine"));
  const TextureField wide = noise_field(w, h, {4, 2, 3, 0.5F}, seed.child("wide"));
  return combined(
      fine, wide, [](float f, float b) { return smooth_step(0.42F, 0.82F, f * 0.6F + b * 0.5F); });
}

TextureField rings(int w, int h, const Seed& seed) {
  const TextureField lines = noise_field(w, h, {5, 60, 3, 0.6F}, seed.child("lines"));
  const TextureField where = noise_field(w, h, {9, 14, 2, 0.5F}, seed.child("where"));
  return combined(lines, where, [](float l, float o) {
    return smooth_step(0.60F, 0.80F, l * 0.70F + o * 0.40F);
  });
}

// A wave of `count` crests along x, warped by noise: 1 on a crest.
TextureField crests(int w, int h, int count, float warp, const Seed& seed) {
  TextureField field = noise_field(w, h, {count * 2, 6, 3, 0.6F}, seed);
  for (int y = 0; y < h; ++y) {
    float* row = field.row(y);
    for (int x = 0; x < w; ++x) {
      const float at = static_cast<float>(x) * static_cast<float>(count) / static_cast<float>(w) +
                       (row[x] - 0.5F) * warp;
      const float turn = at - static_cast<float>(static_cast<int>(at + 8) - 8);
      const float triangle = turn < 0.5F ? turn * 2 : 2 - turn * 2;
      row[x] = triangle;
    }
  }
  return field;
}

// A leaf's midrib in the middle of both its sides (u = 0, 0.5), and the veins that leave it
// upwards.
TextureField leaf_veins(int w, int h, const Seed& seed) {
  constexpr int veins = 9;
  TextureField field = noise_field(w, h, {10, 9, 4, 0.6F}, seed.child("folds"));
  const TextureField bend = noise_field(w, h, {4, 4, 2, 0.5F}, seed.child("bend"));
  for (int y = 0; y < h; ++y) {
    const float v = (static_cast<float>(y) + 0.5F) / static_cast<float>(h);
    float* row = field.row(y);
    const float* bend_row = bend.row(y);
    for (int x = 0; x < w; ++x) {
      const float u = (static_cast<float>(x) + 0.5F) / static_cast<float>(w);
      const float half = u < 0.5F ? u : u - 0.5F;
      const float off = std::min(half, 0.5F - half) * 4;  // 0 on the midrib, 1 on the edge
      const float rib = 1 - smooth_step(0.0F, 0.03F + 0.13F * v, off);
      const float place = (v + 0.35F * off + 0.05F * bend_row[x]) * veins;
      const float from_line = place - static_cast<float>(static_cast<int>(place)) - 0.5F;
      const float vein = 1 - smooth_step(0.0F, 0.16F, from_line < 0 ? -from_line : from_line);
      const float folds = smooth_step(0.45F, 0.75F, row[x]) * 0.3F;
      row[x] = std::min(1.0F, std::max(rib, vein * (1 - off) * 0.6F) + folds);
    }
  }
  return field;
}

// Towards one side, with a ragged edge.
TextureField blush(int w, int h, const Seed& seed) {
  const float toward = static_cast<float>(seed.child("side").stream().uniform(0.35, 0.65));
  TextureField field = noise_field(w, h, {5, 5, 5, 0.6F}, seed.child("edge"));
  for (int y = 0; y < h; ++y) {
    float* row = field.row(y);
    for (int x = 0; x < w; ++x) {
      const float away = (static_cast<float>(x) + 0.5F) / static_cast<float>(w) - toward;
      const float distance = away < 0 ? -away : away;  // u tiles: the far side is half a turn off
      const float off = std::min(distance, 1 - distance) * 2;
      row[x] = smooth_step(0.30F, 1.0F, 1.05F - off * 1.15F + (row[x] - 0.5F) * 0.9F);
    }
  }
  return field;
}

TextureField banana_marks(int w, int h, const Seed& seed) {
  TextureField specks = bump_field(w, h, {30, 40, 0.35F, 0.9F, 0.8F, 0.10F}, seed.child("specks"));
  const TextureField edges = crests(w, h, 5, 0.05F, seed.child("edges"));
  return combined(specks, edges, [](float s, float e) {
    return std::min(1.0F, smooth_step(0.0F, 0.8F, s) * 0.6F + smooth_step(0.96F, 1.0F, e) * 0.35F);
  });
}

}  // namespace

TextureField mark_field(SkinTexture texture, int width, int height, const Seed& seed) {
  const int w = width, h = height;
  switch (texture) {
    case SkinTexture::smooth:
      return mapped(noise_field(w, h, {2, 2, 4, 0.45F}, seed),
                    [](float n) { return smooth_step(0.48F, 0.72F, n); });
    case SkinTexture::blushed:
      return blush(w, h, seed);
    case SkinTexture::streaked:
      return streaks(w, h, seed);
    case SkinTexture::specks:
      return mapped(bump_field(w, h, {56, 34, 0.20F, 0.9F, 0.6F, 0.75F}, seed),
                    [](float b) { return smooth_step(0.0F, 0.7F, b); });
    case SkinTexture::peel:
      return mapped(bump_field(w, h, {110, 62, 0.42F, 0.7F, 0.4F, 0.9F}, seed),
                    [](float b) { return smooth_step(0.1F, 1.0F, b); });
    case SkinTexture::striped:
      return mapped(crests(w, h, 10, 0.9F, seed),
                    [](float c) { return smooth_step(0.45F, 0.75F, c); });
    case SkinTexture::netted:
      return mapped(noise_field(w, h, {38, 20, 2, 0.5F}, seed), [](float n) {
        return 1 - smooth_step(0.0F, 0.055F, n > 0.5F ? n - 0.5F : 0.5F - n);
      });
    case SkinTexture::scales:
      return mapped(bump_field(w, h, {14, 14, 0.74F, 0.0F, 0.0F, 1.0F}, seed),
                    [](float b) { return 1 - smooth_step(0.05F, 0.6F, b); });
    case SkinTexture::ringed:
      return rings(w, h, seed);
    case SkinTexture::ridged:
      return mapped(crests(w, h, 12, 0.25F, seed),
                    [](float c) { return smooth_step(0.55F, 1.0F, c); });
    case SkinTexture::fibres:
      return mapped(noise_field(w, h, {150, 60, 2, 0.8F}, seed),
                    [](float n) { return smooth_step(0.45F, 0.75F, n); });
    case SkinTexture::ripening:
      return banana_marks(w, h, seed);
    case SkinTexture::blotched: {
      const TextureField eyes =
          bump_field(w, h, {9, 7, 0.22F, 0.9F, 0.5F, 0.5F}, seed.child("eyes"));
      const TextureField dirt = noise_field(w, h, {8, 6, 5, 0.65F}, seed.child("dirt"));
      return combined(eyes, dirt, [](float e, float d) {
        return std::min(1.0F,
                        smooth_step(0.1F, 0.9F, e) * 0.9F + smooth_step(0.5F, 0.8F, d) * 0.5F);
      });
    }
    case SkinTexture::kernels:
      return mapped(bump_field(w, h, {18, 40, 0.62F, 0.1F, 0.0F, 1.0F}, seed),
                    [](float b) { return 1 - smooth_step(0.05F, 0.55F, b); });
    case SkinTexture::seeds:
      return mapped(bump_field(w, h, {14, 12, 0.17F, 0.15F, 0.1F, 1.0F}, seed),
                    [](float b) { return smooth_step(0.1F, 0.6F, b); });
    case SkinTexture::florets:
      return mapped(bump_field(w, h, {90, 64, 0.8F, 0.8F, 0.35F, 1.0F}, seed),
                    [](float b) { return 1 - smooth_step(0.15F, 0.95F, b); });
    case SkinTexture::leafy:
      return leaf_veins(w, h, seed);
  }
  return TextureField(w, h);
}

}  // namespace marketgen::assets
