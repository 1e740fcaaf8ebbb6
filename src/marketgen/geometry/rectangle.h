// Rectangles and polygons in whole millimetres, the currency of plans and layouts.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace marketgen {
inline namespace geometry {

using PointMm = std::array<int, 2>;      // [x, y], written as in JSON
using PolygonMm = std::vector<PointMm>;  // counter-clockwise, not closed

// Axis-aligned, half-open in spirit: two rectangles that share an edge do not overlap.
struct RectMm {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // x0 <= x1, y0 <= y1

  int width() const { return x1 - x0; }
  int depth() const { return y1 - y0; }
  bool empty() const { return x1 <= x0 || y1 <= y0; }
  std::int64_t area_mm2() const { return empty() ? 0 : std::int64_t{width()} * depth(); }
  double area_m2() const { return static_cast<double>(area_mm2()) * 1e-6; }
  PointMm center() const { return {(x0 + x1) / 2, (y0 + y1) / 2}; }
  bool contains(PointMm p) const { return p[0] >= x0 && p[0] <= x1 && p[1] >= y0 && p[1] <= y1; }
  bool contains(const RectMm& r) const {
    return r.x0 >= x0 && r.x1 <= x1 && r.y0 >= y0 && r.y1 <= y1;
  }
  RectMm grown(int by) const { return {x0 - by, y0 - by, x1 + by, y1 + by}; }
  friend bool operator==(const RectMm&, const RectMm&) = default;
};

bool overlap(const RectMm& a, const RectMm& b);                        // with positive area
std::optional<RectMm> intersection(const RectMm& a, const RectMm& b);  // of positive area
// Gap between two rectangles along the axis in which they are apart; negative when they overlap.
int gap_mm(const RectMm& a, const RectMm& b);
// Straight across the floor from edge to edge; 0 when they touch or overlap.
double distance_mm(const RectMm& a, const RectMm& b);

// Where a place is on the floor plan, to the nearest millimetre: x and y of a Vec2, Vec3 or Vec3f,
// metres.
template <class Vector>
PointMm floor_mm(const Vector& place) {
  return {static_cast<int>(std::lround(place.x * 1000)),
          static_cast<int>(std::lround(place.y * 1000))};
}

constexpr RectMm point_rect(PointMm p) {  // of no size, for distances to a point
  return {p[0], p[1], p[0], p[1]};
}
PolygonMm polygon_of(const RectMm& r);  // counter-clockwise from (x0, y0)
RectMm bounds_of(const PolygonMm& polygon);
RectMm bounds_of(const RectMm& a, const RectMm& b);  // the smallest that has both
// Twice the signed area of a, b, c in mm2: positive for a left turn.
std::int64_t turn(PointMm a, PointMm b, PointMm c);
double area_m2(const PolygonMm& polygon);            // shoelace, positive for counter-clockwise
bool contains(const PolygonMm& polygon, PointMm p);  // even-odd, border counts as inside

}  // namespace geometry
}  // namespace marketgen
