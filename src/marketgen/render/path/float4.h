// Three floats in one SSE register: points, directions and colours where a picture's time goes. The
// fourth lane is free for its owner; unless said otherwise it is neither read nor kept. Not
// xsimd's, which has no dot product of three lanes in one instruction; see float8.h.
#pragma once
#include <immintrin.h>

#include "geometry/vector.h"

namespace marketgen::render::raytrace {

struct Float4 {
  __m128 m = _mm_setzero_ps();

  Float4() = default;
  explicit Float4(__m128 lanes) : m(lanes) {}
  explicit Float4(float all) : m(_mm_set1_ps(all)) {}
  Float4(float x, float y, float z, float w = 0) : m(_mm_setr_ps(x, y, z, w)) {}
  explicit Float4(Vec3f v) : m(_mm_setr_ps(v.x, v.y, v.z, 0)) {}

  float x() const { return _mm_cvtss_f32(m); }
  float y() const { return _mm_cvtss_f32(_mm_shuffle_ps(m, m, 0x55)); }
  float z() const { return _mm_cvtss_f32(_mm_shuffle_ps(m, m, 0xAA)); }
  float w() const { return _mm_cvtss_f32(_mm_shuffle_ps(m, m, 0xFF)); }
  Vec3f xyz() const { return {x(), y(), z()}; }

  friend Float4 operator+(Float4 a, Float4 b) { return Float4(_mm_add_ps(a.m, b.m)); }
  friend Float4 operator-(Float4 a, Float4 b) { return Float4(_mm_sub_ps(a.m, b.m)); }
  friend Float4 operator-(Float4 a) { return Float4(_mm_xor_ps(a.m, _mm_set1_ps(-0.0F))); }
  friend Float4 operator*(Float4 a, Float4 b) { return Float4(_mm_mul_ps(a.m, b.m)); }
  friend Float4 operator*(Float4 a, float s) { return a * Float4(s); }
  Float4& operator+=(Float4 b) { return *this = *this + b; }
  Float4& operator*=(Float4 b) { return *this = *this * b; }
};

// Of the first three lanes.
inline float dot(Float4 a, Float4 b) {
  return _mm_cvtss_f32(_mm_dp_ps(a.m, b.m, 0x71));
}
inline Float4 normalized(Float4 a) {
  return Float4(_mm_div_ps(a.m, _mm_sqrt_ps(_mm_dp_ps(a.m, a.m, 0x7F))));
}
inline Float4 min(Float4 a, Float4 b) {
  return Float4(_mm_min_ps(a.m, b.m));
}
inline Float4 max(Float4 a, Float4 b) {
  return Float4(_mm_max_ps(a.m, b.m));
}
inline Float4 mix(Float4 a, Float4 b, float t) {
  return a + (b - a) * t;
}
inline Float4 mirrored(Float4 d, Float4 n) {
  return d - n * (2 * dot(d, n));
}

}  // namespace marketgen::render::raytrace
