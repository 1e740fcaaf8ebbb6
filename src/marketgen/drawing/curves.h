// Curves made into short straight lines.
#pragma once
#include <vector>

#include "drawing/sketch.h"

namespace marketgen::drawing {

// [x y 1] -> [a x + c y + e, b x + d y + f], as SVG writes it.
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  Vec2 operator*(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  // This one after `m`.
  Affine operator*(const Affine& m) const;
  double scale() const;  // of lengths, where it is the same in all directions
  bool finite() const;
};

Affine moved(double x, double y);
Affine scaled(double x, double y);
Affine rotated(double radians);

// Both ends included; steps of at most 6 degrees.
std::vector<Vec2> arc_points(Vec2 centre, double radius, double start, double sweep);
// Without its first point.
void append_cubic(std::vector<Vec2>& points, Vec2 from, Vec2 c1, Vec2 c2, Vec2 to);
// The circle on which all the points lie, to 2 % of its radius; nothing for fewer than 5 points,
// straight lines and other curves.
std::optional<Arc> arc_through(const std::vector<Vec2>& points);

}  // namespace marketgen::drawing
