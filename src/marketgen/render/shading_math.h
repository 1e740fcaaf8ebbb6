// Small formulas that every part of the ray tracer shares: frames, Fresnel, the GGX lobe, hashed
// numbers.
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "geometry/vector.h"

namespace marketgen::render::raytrace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float inverse_pi = std::numbers::inv_pi_v<float>;
constexpr float two_pi = 2 * pi;
// Normal reflectance of a dielectric with refractive index 1.5: ((n - 1) / (n + 1))^2.
constexpr float dielectric_reflectance = 0.04F;
// A pane of two faces reflects about twice what one face does.
constexpr float pane_reflectance = 2 * dielectric_reflectance;

template <class Number>
Number luminance(const Vector3<Number>& c) {
  return 0.2126F * c.x + 0.7152F * c.y + 0.0722F * c.z;
}
inline float largest(Vec3f c) {
  return std::max(c.x, std::max(c.y, c.z));
}
inline Vec3f mix(Vec3f a, Vec3f b, float t) {
  return a * (1 - t) + b * t;
}
inline Vec3f mirrored(Vec3f d, Vec3f n) {
  return d - n * (2 * dot(d, n));
}

// Base-2 logarithm of a positive number within 0.01: enough to pick a mip level.
inline float rough_log2(float x) {
  const auto bits = static_cast<float>(std::bit_cast<std::int32_t>(x));
  return bits * (1.0F / 8388608.0F) -
         126.957F;  // 126.957: exponent bias less the mean mantissa error
}

// Right-handed frame around a unit normal without branches (Duff et al., JCGT 2017).
struct TangentFrame {
  Vec3f tangent, bitangent, normal;

  explicit TangentFrame(Vec3f n) : normal(n) {
    const float sign = std::copysign(1.0F, n.z);
    const float a = -1.0F / (sign + n.z);
    const float b = n.x * n.y * a;
    tangent = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    bitangent = {b, sign + n.y * n.y * a, -n.y};
  }
  Vec3f to_world(Vec3f v) const { return tangent * v.x + bitangent * v.y + normal * v.z; }
  Vec3f to_local(Vec3f v) const { return {dot(v, tangent), dot(v, bitangent), dot(v, normal)}; }
};

// Cosine-distributed direction around +Z from two numbers in [0, 1).
inline Vec3f cosine_direction(float u, float v) {
  const float r = std::sqrt(u);
  const float phi = two_pi * v;
  return {r * std::cos(phi), r * std::sin(phi), std::sqrt(std::max(0.0F, 1 - u))};
}

// Direction i of n on a spherical Fibonacci lattice.
inline Vec3f sphere_direction(int i, int n) {
  constexpr float golden_angle = 2.39996323F;
  const float z = 1 - (2 * static_cast<float>(i) + 1) / static_cast<float>(n);
  const float r = std::sqrt(std::max(0.0F, 1 - z * z));
  const float phi = static_cast<float>(i) * golden_angle;
  return {r * std::cos(phi), r * std::sin(phi), z};
}

inline float fifth_power(float x) {
  const float x2 = x * x;
  return x2 * x2 * x;
}

// Schlick's Fresnel approximation.
inline Vec3f fresnel(Vec3f reflectance, float cos_theta) {
  return reflectance +
         (Vec3f{1, 1, 1} - reflectance) * fifth_power(1 - std::clamp(cos_theta, 0.0F, 1.0F));
}
// The same for a rough surface seen as a whole: less lift at grazing angles.
inline Vec3f rough_fresnel(Vec3f reflectance, float cos_theta, float roughness) {
  const float top = 1 - roughness;
  const Vec3f lift{std::max(top, reflectance.x) - reflectance.x,
                   std::max(top, reflectance.y) - reflectance.y,
                   std::max(top, reflectance.z) - reflectance.z};
  return reflectance + lift * fifth_power(1 - std::clamp(cos_theta, 0.0F, 1.0F));
}

// GGX distribution and Smith masking (Walter et al. 2007); `alpha` = roughness squared.
inline float ggx_density(float n_dot_h, float alpha) {
  const float a2 = alpha * alpha;
  const float d = n_dot_h * n_dot_h * (a2 - 1) + 1;
  return a2 / (pi * d * d);
}
inline float ggx_masking(float n_dot_v, float alpha) {
  const float a2 = alpha * alpha;
  return 2 * n_dot_v / (n_dot_v + std::sqrt(a2 + (1 - a2) * n_dot_v * n_dot_v));
}

// Half vector around +Z from GGX's visible normals (Heitz, JCGT 2018); `view` in the local frame.
inline Vec3f ggx_half_vector(Vec3f view, float alpha, float u, float v) {
  const Vec3f stretched = normalized(Vec3f{alpha * view.x, alpha * view.y, view.z});
  const float flat = stretched.x * stretched.x + stretched.y * stretched.y;
  const Vec3f t1 =
      flat > 0 ? Vec3f{-stretched.y, stretched.x, 0} / std::sqrt(flat) : Vec3f{1, 0, 0};
  const Vec3f t2 = cross(stretched, t1);
  const float r = std::sqrt(u);
  const float x = r * std::cos(two_pi * v);
  const float s = 0.5F * (1 + stretched.z);
  const float y = (1 - s) * std::sqrt(std::max(0.0F, 1 - x * x)) + s * r * std::sin(two_pi * v);
  const Vec3f h = t1 * x + t2 * y + stretched * std::sqrt(std::max(0.0F, 1 - x * x - y * y));
  return normalized(Vec3f{alpha * h.x, alpha * h.y, std::max(1e-6F, h.z)});
}

// Well-mixed 32 bits from 32 bits (lowbias32 by C. Wellons).
inline std::uint32_t hashed(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352dU;
  x ^= x >> 15;
  x *= 0x846ca68bU;
  x ^= x >> 16;
  return x;
}
// [0, 1), 24 bits.
inline float unit_float(std::uint32_t bits) {
  return static_cast<float>(bits >> 8) * (1.0F / 16777216.0F);
}

}  // namespace marketgen::render::raytrace
