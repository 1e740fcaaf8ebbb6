// Vectors and colours as plain values. Vec3 is double (poses, layout), Vec3f is float (meshes,
// rendering).
#pragma once
#include <cmath>

namespace marketgen {
inline namespace geometry {

template <class T>
struct Vector2 {
  T x{}, y{};
  friend constexpr Vector2 operator+(Vector2 a, Vector2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vector2 operator-(Vector2 a, Vector2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vector2 operator*(Vector2 a, T s) { return {a.x * s, a.y * s}; }
  friend constexpr bool operator==(const Vector2&, const Vector2&) = default;
};

template <class T>
struct Vector3 {
  T x{}, y{}, z{};
  friend constexpr Vector3 operator+(Vector3 a, Vector3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend constexpr Vector3 operator-(Vector3 a, Vector3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend constexpr Vector3 operator-(Vector3 a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vector3 operator*(Vector3 a, T s) { return {a.x * s, a.y * s, a.z * s}; }
  friend constexpr Vector3 operator*(T s, Vector3 a) { return a * s; }
  friend constexpr Vector3 operator*(Vector3 a, Vector3 b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
  }
  friend constexpr Vector3 operator/(Vector3 a, T s) { return {a.x / s, a.y / s, a.z / s}; }
  constexpr Vector3& operator+=(Vector3 b) { return *this = *this + b; }
  constexpr Vector3& operator*=(Vector3 b) { return *this = *this * b; }
  constexpr Vector3& operator*=(T s) { return *this = *this * s; }
  friend constexpr bool operator==(const Vector3&, const Vector3&) = default;
};

using Vec2 = Vector2<double>;
using Vec3 = Vector3<double>;
using Vec2f = Vector2<float>;
using Vec3f = Vector3<float>;

template <class T>
constexpr T dot(Vector3<T> a, Vector3<T> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
constexpr Vector3<T> cross(Vector3<T> a, Vector3<T> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T length(Vector3<T> a) {
  return std::sqrt(dot(a, a));
}
inline double distance(Vec2 a, Vec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}
template <class T>
bool is_finite(Vector3<T> a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
// Unit vector; a zero vector stays zero.
template <class T>
Vector3<T> normalized(Vector3<T> a) {
  const T l = length(a);
  return l > T(0) ? a / l : a;
}
constexpr Vec3f to_float(Vec3 a) {
  return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}
constexpr Vec3 to_double(Vec3f a) {
  return {a.x, a.y, a.z};
}

}  // namespace geometry
}  // namespace marketgen
