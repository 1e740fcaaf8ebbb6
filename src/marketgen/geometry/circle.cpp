#include "geometry/circle.h"

#include <numbers>

namespace marketgen {
inline namespace geometry {
namespace {

// Taylor series about 0, good to 1e-16 for |angle| <= pi/4.
Vec2 circle_near_zero(double angle) {
  const double square = angle * angle;
  double cosine = 1.0;
  double sine = angle;
  double cosine_term = 1.0;
  double sine_term = angle;
  for (int k = 1; k <= 9; ++k) {
    cosine_term *= -square / ((2.0 * k - 1.0) * (2.0 * k));
    sine_term *= -square / ((2.0 * k) * (2.0 * k + 1.0));
    cosine += cosine_term;
    sine += sine_term;
  }
  return {cosine, sine};
}

}  // namespace

Vec2 unit_circle(double turns) {
  const double nearest_quarter = std::floor(turns * 4.0 + 0.5);
  const double angle = (turns - nearest_quarter / 4.0) * (2.0 * std::numbers::pi);
  const Vec2 p = circle_near_zero(angle);
  const double quarters = nearest_quarter - 4.0 * std::floor(nearest_quarter / 4.0);
  if (quarters == 0.0) return p;
  if (quarters == 1.0) return {-p.y, p.x};
  if (quarters == 2.0) return {-p.x, -p.y};
  return {p.y, -p.x};
}

}  // namespace geometry
}  // namespace marketgen
