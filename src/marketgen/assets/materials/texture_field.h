// Scalar fields over a texture that tile along both axes: smooth noise, bumps, dots. The same seed
// gives the same field.
//
// Built from integer hashes and + - * / only, so that the bits are the same in every build.
#pragma once
#include <cstdint>
#include <vector>

#include "base/seed.h"

namespace marketgen::assets {

// Row-major values from the top left.
struct TextureField {
  int width = 0, height = 0;
  std::vector<float> values;

  TextureField(int w, int h, float value = 0)
      : width(w),
        height(h),
        values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), value) {}
  float* row(int y) {
    return &values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)];
  }
  const float* row(int y) const {
    return &values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)];
  }
  // Between the texels around (x, y), which may lie anywhere: the field repeats.
  float wrapped_at(float x, float y) const;
};

// How often the noise's lattice divides the texture along each axis in its first octave; every
// further octave doubles both.
struct NoiseShape {
  int cells_x = 4, cells_y = 4;
  int octaves = 3;
  float roughness = 0.5F;  // amplitude of an octave over that of the one before
};

// Value noise, 0..1 with mean about a half.
TextureField noise_field(int width, int height, const NoiseShape& shape, const Seed& seed);

// Round bumps on a jittered grid of `columns` by `rows`, every second row shifted: 1 in a bump's
// middle, falling as a parabola to 0 at `radius` (in grid steps), the higher where bumps overlap.
struct BumpShape {
  int columns = 16, rows = 8;
  float radius = 0.6F;      // mean, in grid steps
  float jitter = 0.4F;      // of the middle, in grid steps
  float radius_spread = 0;  // 0..1 of the radius
  float share = 1;          // of grid places that have a bump
};
TextureField bump_field(int width, int height, const BumpShape& shape, const Seed& seed);

// 0 below `low`, 1 above `high`, smooth between.
constexpr float smooth_step(float low, float high, float x) {
  const float t = x <= low ? 0.0F : x >= high ? 1.0F : (x - low) / (high - low);
  return t * t * (3 - 2 * t);
}

}  // namespace marketgen::assets
