// Eight single-precision lanes, the same on every machine: x86-64-v3 has AVX2, and nothing wider is
// used, so that no result depends on the processor.
#pragma once
#include <immintrin.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <xsimd/xsimd.hpp>

namespace marketgen {

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

}  // namespace marketgen
