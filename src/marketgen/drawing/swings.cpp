#include <algorithm>
#include <cmath>
#include <numbers>

#include "drawing/recognise.h"

namespace marketgen::drawing {
namespace {

constexpr double widest_swing_mm = 3000;  // two leaves
constexpr double degrees = std::numbers::pi / 180;
const double in_line = std::cos(4 * degrees);

// The outline from a corner on.
class Ring {
 public:
  explicit Ring(const Polygon& corners) : corners_(corners) {}

  Vec2 at(std::size_t i) const { return corners_[i % corners_.size()]; }
  Vec2 way(std::size_t i) const {  // of the edge from corner i, a unit vector
    const Vec2 v = at(i + 1) - at(i);
    const double l = std::hypot(v.x, v.y);
    return l > 0 ? v * (1 / l) : Vec2{};
  }
  double turn_at(std::size_t i) const {  // radians, to the left
    const Vec2 u = way(i + corners_.size() - 1), v = way(i);
    return std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y);
  }

  // At least three corners in a row turn the same way by a little, as those of an arc do.
  bool is_curved(std::size_t from, std::size_t to) const {
    int row = 0;
    double before = 0;
    for (std::size_t i = from; i <= to; ++i) {
      const double turn = turn_at(i);
      const bool little = std::abs(turn) > 4 * degrees && std::abs(turn) < 50 * degrees;
      row = little ? (turn * before > 0 ? row + 1 : 1) : 0;
      before = little ? turn : 0;
      if (row >= 3) return true;
    }
    return false;
  }

  // The corners from..to are a door that stands open: the wall goes on in line behind them.
  bool is_swing(std::size_t from, std::size_t to, const Tolerance& tolerance) const {
    const Vec2 u = way(from + corners_.size() - 1), v = way(to), gap = at(to) - at(from);
    const double along = gap.x * u.x + gap.y * u.y, aside = std::abs(gap.x * u.y - gap.y * u.x);
    if (u.x * v.x + u.y * v.y < in_line || along < narrowest_opening_mm || along > widest_swing_mm)
      return false;
    return aside < std::max(4 * tolerance.line_mm, 0.03 * along) && is_curved(from, to);
  }

 private:
  const Polygon& corners_;
};

// The corners from..from + 3 go round a gap in a thick wall, the far side of which is bridged.
bool is_recess(const Ring& ring, std::size_t from, const std::vector<Bridge>& bridges) {
  constexpr double near_mm = 120;
  const Vec2 a = ring.at(from), b = ring.at(from + 1), c = ring.at(from + 2), d = ring.at(from + 3);
  const double first = distance(a, b), second = distance(c, d);
  if (std::max(first, second) > thickest_wall_mm || std::abs(first - second) > near_mm)
    return false;
  return std::ranges::any_of(bridges, [&](const Bridge& bridge) {
    return (distance(bridge.from, b) < near_mm && distance(bridge.to, c) < near_mm) ||
           (distance(bridge.from, c) < near_mm && distance(bridge.to, b) < near_mm);
  });
}

}  // namespace

Polygon without_recesses(const Polygon& outline, std::vector<Bridge>& bridges) {
  Polygon left = outline;
  for (std::size_t i = 0; i < left.size() && left.size() > 6; ++i) {
    const Ring ring(left);
    const std::size_t n = left.size();
    const Vec2 u = ring.way(i + n - 1), v = ring.way(i + 3), gap = ring.at(i + 3) - ring.at(i);
    const double across = std::abs(gap.x * u.y - gap.y * u.x);
    if (u.x * v.x + u.y * v.y < in_line || across > 100 || !is_recess(ring, i, bridges)) continue;
    bridges.push_back({ring.at(i), ring.at(i + 3)});
    Polygon rest;
    for (std::size_t m = i + 3; m <= i + n; ++m)
      rest.push_back(ring.at(m));
    left = std::move(rest);
    i = 0;
  }
  return left;
}

Polygon without_swings(const Polygon& outline,
                       const Tolerance& tolerance,
                       std::vector<Bridge>& bridges) {
  constexpr std::size_t longest = 40;  // corners of one door
  Polygon left = outline;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const Ring ring(left);
    const std::size_t n = left.size();
    for (std::size_t k = i + 3; k < i + std::min(longest, n - 2) && n > 6; ++k) {
      if (!ring.is_swing(i, k, tolerance)) continue;
      bridges.push_back({ring.at(i), ring.at(k)});
      Polygon rest;
      for (std::size_t m = k; m <= i + n; ++m)
        rest.push_back(ring.at(m));
      left = std::move(rest);
      i = 0;
      break;
    }
  }
  return left;
}

}  // namespace marketgen::drawing
