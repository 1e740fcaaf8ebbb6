// Fixed numbers for each pixel, well spread in the pixel and over its neighbours, so that a small
// filter sees an even set.
//
// Each 4x4 block of pixels holds all 16 points of a lattice, scrambled per block and dimension; a
// pixel's own samples are spread over [0, 1) too. The same pixel always gets the same numbers.
#pragma once
#include <cstdint>

#include "geometry/vector.h"
#include "render/shading_math.h"

namespace marketgen::raytrace {

// What the numbers are for; each use has a scramble of its own.
enum class SampleUse : std::uint32_t { light_pick, light_point, bounce, reflection };

class SamplePattern {
 public:
  SamplePattern(int x, int y, int samples_per_pixel)
      : cell_(static_cast<std::uint32_t>((x & 3) + ((y & 3) << 2))),
        block_(hashed(static_cast<std::uint32_t>(x >> 2) * 0x9E3779B9U ^
                      static_cast<std::uint32_t>(y >> 2) * 0x85EBCA6BU)),
        count_(static_cast<float>(samples_per_pixel)) {}

  // Sample `s` of the pixel.
  Vec2f at(SampleUse use, int s) const {
    const std::uint32_t scramble = hashed(block_ + static_cast<std::uint32_t>(use) * 0x27D4EB2FU);
    const std::uint32_t k = cell_ ^ (scramble & 15U);
    const std::uint32_t jitter =
        hashed(scramble ^ (cell_ << 8) ^ (static_cast<std::uint32_t>(s) << 16));
    const float u =
        ((static_cast<float>(bayer[k]) + unit_float(jitter)) / 16 + static_cast<float>(s)) / count_;
    const float v =
        (static_cast<float>((bayer[k] * 7 + 5) & 15U) + unit_float(hashed(jitter))) / 16 +
        static_cast<float>(s) * 0.618034F;
    return {u, v - std::floor(v)};
  }

 private:
  // Ordered dither: neighbours are far apart.
  static constexpr std::uint32_t bayer[16] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
  std::uint32_t cell_, block_;
  float count_;
};

}  // namespace marketgen::raytrace
