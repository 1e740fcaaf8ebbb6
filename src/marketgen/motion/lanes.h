// Eight single-precision lanes, the same on every machine: x86-64-v3 has AVX2, and nothing wider is
// used, so that no result depends on the processor.
#pragma once
#include <immintrin.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <xsimd/xsimd.hpp>

namespace marketgen::motion {

using Lanes = xsimd::batch<float, xsimd::avx2>;
constexpr std::size_t lane_count = 8;
static_assert(Lanes::size == lane_count);

inline Lanes load(const std::array<float, lane_count>& values) {
  return Lanes::load_aligned(values.data());
}

// Bit k: whether lane k holds. (Debian 12's xsimd has no such call.)
inline std::uint32_t bits_of(const xsimd::batch_bool<float, xsimd::avx2>& lanes) {
  return static_cast<std::uint32_t>(_mm256_movemask_ps(lanes));
}

// Smallest and largest of the eight.
inline float lowest(const Lanes& lanes) {
  const __m256 v = lanes;
  __m128 low = _mm_min_ps(_mm256_castps256_ps128(v), _mm256_extractf128_ps(v, 1));
  low = _mm_min_ps(low, _mm_movehl_ps(low, low));
  return _mm_cvtss_f32(_mm_min_ss(low, _mm_shuffle_ps(low, low, 1)));
}
inline float highest(const Lanes& lanes) {
  return -lowest(-lanes);
}

// Eight poses of one frame: rotations row by row, positions.
struct LaneFrame {
  std::array<Lanes, 9> r;
  std::array<Lanes, 3> p;
};

}  // namespace marketgen::motion
