#include "drawing/curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace marketgen::drawing {
namespace {

constexpr double step = std::numbers::pi / 30;  // 6 degrees
constexpr int cubic_steps = 15;
constexpr double roundness = 0.02;

}  // namespace

Affine Affine::operator*(const Affine& m) const {
  return {a * m.a + c * m.b,
          b * m.a + d * m.b,
          a * m.c + c * m.d,
          b * m.c + d * m.d,
          a * m.e + c * m.f + e,
          b * m.e + d * m.f + f};
}

double Affine::scale() const {
  return std::sqrt(std::abs(a * d - b * c));
}

bool Affine::finite() const {
  return std::isfinite(a + b + c + d + e + f);
}

Affine moved(double x, double y) {
  return {1, 0, 0, 1, x, y};
}

Affine scaled(double x, double y) {
  return {x, 0, 0, y, 0, 0};
}

Affine rotated(double radians) {
  const double c = std::cos(radians), s = std::sin(radians);
  return {c, s, -s, c, 0, 0};
}

std::vector<Vec2> arc_points(Vec2 centre, double radius, double start, double sweep) {
  const double most = 2 * std::numbers::pi;
  sweep = std::clamp(sweep, -most, most);
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / step)));
  std::vector<Vec2> points;
  for (int i = 0; i <= steps; ++i) {
    const double angle = start + sweep * i / steps;
    points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return points;
}

void append_cubic(std::vector<Vec2>& points, Vec2 from, Vec2 c1, Vec2 c2, Vec2 to) {
  for (int i = 1; i <= cubic_steps; ++i) {
    const double t = static_cast<double>(i) / cubic_steps, u = 1 - t;
    points.push_back(from * (u * u * u) + c1 * (3 * u * u * t) + c2 * (3 * u * t * t) +
                     to * (t * t * t));
  }
}

std::optional<Arc> arc_through(const std::vector<Vec2>& points) {
  if (points.size() < 5) return std::nullopt;
  const Vec2 a = points.front(), b = points[points.size() / 2], c = points.back();
  const Vec2 ab = b - a, ac = c - a;
  const double twice = 2 * (ab.x * ac.y - ab.y * ac.x);
  const double ab2 = ab.x * ab.x + ab.y * ab.y, ac2 = ac.x * ac.x + ac.y * ac.y;
  if (std::abs(twice) < 1e-9 * std::max(ab2, ac2)) return std::nullopt;
  const Vec2 centre{a.x + (ac.y * ab2 - ab.y * ac2) / twice,
                    a.y + (ab.x * ac2 - ac.x * ab2) / twice};
  const auto from_centre = [&](Vec2 p) { return std::hypot(p.x - centre.x, p.y - centre.y); };
  const double radius = from_centre(a);
  double sweep = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::abs(from_centre(points[i]) - radius) > roundness * radius) return std::nullopt;
    if (i == 0) continue;
    const Vec2 u = points[i - 1] - centre, v = points[i] - centre;
    sweep += std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y);
  }
  return Arc{centre, radius, std::abs(sweep)};
}

}  // namespace marketgen::drawing
