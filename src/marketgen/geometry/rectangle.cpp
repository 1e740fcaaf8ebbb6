#include "geometry/rectangle.h"

#include <algorithm>
#include <cmath>

namespace marketgen {
inline namespace geometry {

bool overlap(const RectMm& a, const RectMm& b) {
  return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

std::optional<RectMm> intersection(const RectMm& a, const RectMm& b) {
  if (!overlap(a, b)) return std::nullopt;
  return RectMm{
      std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

int gap_mm(const RectMm& a, const RectMm& b) {
  const int along_x = std::max(a.x0, b.x0) - std::min(a.x1, b.x1);
  const int along_y = std::max(a.y0, b.y0) - std::min(a.y1, b.y1);
  return std::max(along_x, along_y);
}

double distance_mm(const RectMm& a, const RectMm& b) {
  const double dx = std::max({0, a.x0 - b.x1, b.x0 - a.x1});
  const double dy = std::max({0, a.y0 - b.y1, b.y0 - a.y1});
  return std::sqrt(dx * dx + dy * dy);
}

PolygonMm polygon_of(const RectMm& r) {
  return {{r.x0, r.y0}, {r.x1, r.y0}, {r.x1, r.y1}, {r.x0, r.y1}};
}

RectMm bounds_of(const RectMm& a, const RectMm& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

RectMm bounds_of(const PolygonMm& polygon) {
  if (polygon.empty()) return {};
  RectMm box{polygon[0][0], polygon[0][1], polygon[0][0], polygon[0][1]};
  for (const PointMm& p : polygon) {
    box.x0 = std::min(box.x0, p[0]);
    box.y0 = std::min(box.y0, p[1]);
    box.x1 = std::max(box.x1, p[0]);
    box.y1 = std::max(box.y1, p[1]);
  }
  return box;
}

std::int64_t turn(PointMm a, PointMm b, PointMm c) {
  return std::int64_t{b[0] - a[0]} * (c[1] - a[1]) - std::int64_t{b[1] - a[1]} * (c[0] - a[0]);
}

double area_m2(const PolygonMm& polygon) {
  std::int64_t twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PointMm& p = polygon[i];
    const PointMm& q = polygon[(i + 1) % polygon.size()];
    twice += std::int64_t{p[0]} * q[1] - std::int64_t{q[0]} * p[1];
  }
  return static_cast<double>(twice) * 0.5e-6;
}

namespace {

bool on_edge(PointMm a, PointMm b, PointMm p) {
  const std::int64_t turn =
      std::int64_t{b[0] - a[0]} * (p[1] - a[1]) - std::int64_t{b[1] - a[1]} * (p[0] - a[0]);
  return turn == 0 && p[0] >= std::min(a[0], b[0]) && p[0] <= std::max(a[0], b[0]) &&
         p[1] >= std::min(a[1], b[1]) && p[1] <= std::max(a[1], b[1]);
}

}  // namespace

bool contains(const PolygonMm& polygon, PointMm p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PointMm& a = polygon[i];
    const PointMm& b = polygon[(i + 1) % polygon.size()];
    if (on_edge(a, b, p)) return true;
    if ((a[1] > p[1]) == (b[1] > p[1])) continue;
    const double x =
        a[0] + static_cast<double>(p[1] - a[1]) * (b[0] - a[0]) / static_cast<double>(b[1] - a[1]);
    if (p[0] < x) inside = !inside;
  }
  return inside;
}

}  // namespace geometry
}  // namespace marketgen
