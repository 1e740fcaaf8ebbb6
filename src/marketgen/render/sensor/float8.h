// Eight numbers side by side in one AVX register: pixels where a picture's time goes.
//
// Every operation is the one that a single float or 32-bit integer would get, so that eight lanes
// and one after another give the same bits.
//
// xsimd, which motion/lanes.h uses, gives the same bits in the same time for arithmetic (1.14 ns a
// number of a reflection), but the version of Debian 12 (8.1) has masks of floats and of integers
// apart, none as bits (0.79 instead of 0.12 ns a lane) and no lane to be set, reads single lanes by
// way of memory (1.21 instead of 0.77 ns) and leaves numbers without a value undefined. See
// docs/architecture.md, "Why our own".
#pragma once
#include <immintrin.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "geometry/vector.h"

namespace marketgen::render::raytrace {

constexpr std::size_t lane_count = 8;

// Which lanes something holds for: all bits of a lane or none.
struct Mask8 {
  __m256 m = _mm256_setzero_ps();

  Mask8() = default;
  explicit Mask8(__m256 lanes) : m(lanes) {}
  explicit Mask8(bool all) : m(_mm256_castsi256_ps(_mm256_set1_epi32(all ? -1 : 0))) {}

  unsigned bits() const { return static_cast<unsigned>(_mm256_movemask_ps(m)); }  // lane k is bit k
  bool any() const { return bits() != 0; }
  bool operator[](std::size_t k) const { return (bits() >> k & 1U) != 0; }
  friend Mask8 operator&(Mask8 a, Mask8 b) { return Mask8(_mm256_and_ps(a.m, b.m)); }
  friend Mask8 operator|(Mask8 a, Mask8 b) { return Mask8(_mm256_or_ps(a.m, b.m)); }
  friend Mask8 operator~(Mask8 a) { return Mask8(_mm256_xor_ps(a.m, Mask8(true).m)); }
};

struct Float8 {
  __m256 m = _mm256_setzero_ps();

  Float8() = default;
  explicit Float8(__m256 lanes) : m(lanes) {}
  Float8(float all) : m(_mm256_set1_ps(all)) {}  // NOLINT: numbers stand for eight of them
  static Float8 load(const float* from) { return Float8(_mm256_loadu_ps(from)); }
  void store(float* to) const { _mm256_storeu_ps(to, m); }

  float operator[](std::size_t k) const { return m[k]; }
  void set(std::size_t k, float value) { m[k] = value; }

  friend Float8 operator+(Float8 a, Float8 b) { return Float8(_mm256_add_ps(a.m, b.m)); }
  friend Float8 operator-(Float8 a, Float8 b) { return Float8(_mm256_sub_ps(a.m, b.m)); }
  friend Float8 operator*(Float8 a, Float8 b) { return Float8(_mm256_mul_ps(a.m, b.m)); }
  friend Float8 operator/(Float8 a, Float8 b) { return Float8(_mm256_div_ps(a.m, b.m)); }
  friend Float8 operator-(Float8 a) { return Float8(_mm256_xor_ps(a.m, _mm256_set1_ps(-0.0F))); }
  Float8& operator+=(Float8 b) { return *this = *this + b; }
  Float8& operator*=(Float8 b) { return *this = *this * b; }
  friend Mask8 operator<(Float8 a, Float8 b) { return Mask8(_mm256_cmp_ps(a.m, b.m, _CMP_LT_OQ)); }
  friend Mask8 operator>(Float8 a, Float8 b) { return Mask8(_mm256_cmp_ps(a.m, b.m, _CMP_GT_OQ)); }
  friend Mask8 operator>=(Float8 a, Float8 b) { return Mask8(_mm256_cmp_ps(a.m, b.m, _CMP_GE_OQ)); }
};

struct Int8 {
  __m256i m = _mm256_setzero_si256();

  Int8() = default;
  explicit Int8(__m256i lanes) : m(lanes) {}
  Int8(std::int32_t all) : m(_mm256_set1_epi32(all)) {}  // NOLINT: as Float8's
  static Int8 load(const void* from) {
    return Int8(_mm256_loadu_si256(static_cast<const __m256i*>(from)));
  }
  void store(void* to) const { _mm256_storeu_si256(static_cast<__m256i*>(to), m); }

  std::int32_t operator[](std::size_t k) const {
    return std::bit_cast<std::array<std::int32_t, lane_count>>(m)[k];
  }
  void set(std::size_t k, std::int32_t value) {
    auto lanes = std::bit_cast<std::array<std::int32_t, lane_count>>(m);
    lanes[k] = value;
    m = std::bit_cast<__m256i>(lanes);
  }

  friend Int8 operator+(Int8 a, Int8 b) { return Int8(_mm256_add_epi32(a.m, b.m)); }
  friend Int8 operator-(Int8 a, Int8 b) { return Int8(_mm256_sub_epi32(a.m, b.m)); }
  friend Int8 operator*(Int8 a, Int8 b) { return Int8(_mm256_mullo_epi32(a.m, b.m)); }
  friend Int8 operator&(Int8 a, Int8 b) { return Int8(_mm256_and_si256(a.m, b.m)); }
  friend Int8 operator|(Int8 a, Int8 b) { return Int8(_mm256_or_si256(a.m, b.m)); }
  friend Int8 operator>>(Int8 a, int bits) { return Int8(_mm256_srli_epi32(a.m, bits)); }
  friend Int8 operator>>(Int8 a, Int8 bits) { return Int8(_mm256_srlv_epi32(a.m, bits.m)); }
  friend Int8 operator<<(Int8 a, int bits) { return Int8(_mm256_slli_epi32(a.m, bits)); }
  friend Mask8 operator==(Int8 a, Int8 b) {
    return Mask8(_mm256_castsi256_ps(_mm256_cmpeq_epi32(a.m, b.m)));
  }
  friend Mask8 operator>(Int8 a, Int8 b) {
    return Mask8(_mm256_castsi256_ps(_mm256_cmpgt_epi32(a.m, b.m)));
  }
};

using Vec8 = Vector3<Float8>;

inline Float8 select(Mask8 where, Float8 yes, Float8 no) {
  return Float8(_mm256_blendv_ps(no.m, yes.m, where.m));
}
inline Int8 select(Mask8 where, Int8 yes, Int8 no) {
  return Int8(_mm256_castps_si256(
      _mm256_blendv_ps(_mm256_castsi256_ps(no.m), _mm256_castsi256_ps(yes.m), where.m)));
}
inline Vec8 select(Mask8 where, const Vec8& yes, const Vec8& no) {
  return {select(where, yes.x, no.x), select(where, yes.y, no.y), select(where, yes.z, no.z)};
}
// Of two equal numbers, or where one is NaN, the second.
inline Float8 min(Float8 a, Float8 b) {
  return Float8(_mm256_min_ps(a.m, b.m));
}
inline Float8 max(Float8 a, Float8 b) {
  return Float8(_mm256_max_ps(a.m, b.m));
}
inline Int8 min(Int8 a, Int8 b) {
  return Int8(_mm256_min_epi32(a.m, b.m));
}
inline Float8 clamp(Float8 x, Float8 low, Float8 high) {
  return min(max(x, low), high);
}
inline Float8 absolute(Float8 a) {
  return Float8(_mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.m));
}
inline Float8 square_root(Float8 a) {
  return Float8(_mm256_sqrt_ps(a.m));
}
inline Float8 rounded_down(Float8 a) {
  return Float8(_mm256_floor_ps(a.m));
}
inline Float8 to_float(Int8 a) {
  return Float8(_mm256_cvtepi32_ps(a.m));
}
// Rounded towards zero.
inline Int8 to_int(Float8 a) {
  return Int8(_mm256_cvttps_epi32(a.m));
}
inline Int8 bits_of(Float8 a) {
  return Int8(_mm256_castps_si256(a.m));
}
inline Float8 float_of_bits(Int8 a) {
  return Float8(_mm256_castsi256_ps(a.m));
}
// table[index] of each lane.
inline Float8 gathered(const float* table, Int8 index) {
  return Float8(_mm256_i32gather_ps(table, index.m, 4));
}

inline Vec8 all(Vec3f v) {
  return {v.x, v.y, v.z};
}
inline Vec3f lane(const Vec8& v, std::size_t k) {
  return {v.x[k], v.y[k], v.z[k]};
}
inline void set_lane(Vec8& v, std::size_t k, Vec3f value) {
  v.x.set(k, value.x);
  v.y.set(k, value.y);
  v.z.set(k, value.z);
}
inline Vec8 normalized(const Vec8& v) {
  return v * (Float8(1) / square_root(dot(v, v)));
}
inline Vec8 mirrored(const Vec8& d, const Vec8& n) {
  return d - n * (Float8(2) * dot(d, n));
}
inline Float8 largest(const Vec8& v) {
  return max(v.x, max(v.y, v.z));
}

// As shading_math.h's.
inline Float8 rough_log2(Float8 x) {
  return to_float(bits_of(x)) * (1.0F / 8388608.0F) - 126.957F;
}

// Four lanes of `a`, then four of `b`: the first of each, or the last.
enum class Side { first, last };
inline Float8 four_each(Float8 a, Float8 b, Side side) {
  return Float8(side == Side::first ? _mm256_permute2f128_ps(a.m, b.m, 0x20)
                                    : _mm256_permute2f128_ps(a.m, b.m, 0x31));
}
inline Int8 four_each(Int8 a, Int8 b, Side side) {
  return bits_of(four_each(float_of_bits(a), float_of_bits(b), side));
}
inline Vec8 four_each(const Vec8& a, const Vec8& b, Side side) {
  return {four_each(a.x, b.x, side), four_each(a.y, b.y, side), four_each(a.z, b.z, side)};
}

// rows[k] are 32 bytes of lane k; result[i] has the four bytes number i of every lane.
using Rows8 = std::array<Int8, lane_count>;
inline Rows8 side_by_side(const std::array<const void*, lane_count>& rows) {
  std::array<Float8, lane_count> r, s;
  for (std::size_t k = 0; k < lane_count; ++k)
    r[k] = Float8::load(static_cast<const float*>(rows[k]));
  for (std::size_t k = 0; k < lane_count; k += 2) {
    s[k].m = _mm256_unpacklo_ps(r[k].m, r[k + 1].m);
    s[k + 1].m = _mm256_unpackhi_ps(r[k].m, r[k + 1].m);
  }
  for (std::size_t k = 0; k < lane_count; k += 4) {
    r[k].m = _mm256_shuffle_ps(s[k].m, s[k + 2].m, 0x44);
    r[k + 1].m = _mm256_shuffle_ps(s[k].m, s[k + 2].m, 0xEE);
    r[k + 2].m = _mm256_shuffle_ps(s[k + 1].m, s[k + 3].m, 0x44);
    r[k + 3].m = _mm256_shuffle_ps(s[k + 1].m, s[k + 3].m, 0xEE);
  }
  Rows8 columns;
  for (std::size_t k = 0; k < lane_count / 2; ++k) {
    columns[k] = bits_of(four_each(r[k], r[k + 4], Side::first));
    columns[k + 4] = bits_of(four_each(r[k], r[k + 4], Side::last));
  }
  return columns;
}

}  // namespace marketgen::render::raytrace
