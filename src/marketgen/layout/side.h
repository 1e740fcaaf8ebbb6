// The four sides of a rectangle, and rectangles seen from one of them.
//
// Walls, fronts of fixtures and edges of zones are all sides; the functions here let one piece of
// code serve all four.
#pragma once
#include <array>
#include <vector>

#include "geometry/rectangle.h"
#include "plan/plan.h"

namespace marketgen::layout {

// In the order of yaw: a front that faces side k has a yaw of 90 k degrees.
enum class Side { south, east, north, west };
constexpr std::array<Side, 4> all_sides{Side::south, Side::east, Side::north, Side::west};

constexpr std::size_t index_of(Side side) {
  return static_cast<std::size_t>(side);
}
constexpr int yaw_facing(Side side) {
  return 90 * static_cast<int>(side);
}
constexpr Side facing_of(int yaw_deg) {
  return static_cast<Side>((yaw_deg / 90) & 3);
}
constexpr Side opposite(Side side) {
  return static_cast<Side>((static_cast<int>(side) + 2) & 3);
}
// The side on the left of someone who looks at a front that faces `side`.
constexpr Side left_of(Side side) {
  return static_cast<Side>((static_cast<int>(side) + 3) & 3);
}
constexpr bool lies_along_x(Side side) {
  return side == Side::south || side == Side::north;
}
Side side_of(plan::Wall wall);

// A stretch of a line, whole millimetres.
struct Span {
  int from = 0, to = 0;
  int length() const { return to - from; }
  int middle() const { return (from + to) / 2; }
  friend bool operator==(const Span&, const Span&) = default;
};

inline bool overlap(Span a, Span b) {
  return a.from < b.to && b.from < a.to;
}
inline Span intersection(Span a, Span b) {
  return {a.from > b.from ? a.from : b.from, a.to < b.to ? a.to : b.to};
}
// What is left of `whole` when all of `taken` is removed, in order; pieces shorter than `least` are
// left out.
std::vector<Span> without(Span whole, std::vector<Span> taken, int least = 1);

// The rectangle's extent along the line of its side, and across it.
Span along(const RectMm& rect, Side side);
Span across(const RectMm& rect, Side side);
int coordinate(const RectMm& rect, Side side);  // of the side's line

// A strip within the rectangle, `offset` inward from its side.
RectMm strip_inside(const RectMm& rect, Side side, int depth, int offset = 0);
// A strip beyond the rectangle's side.
RectMm strip_beyond(const RectMm& rect, Side side, int depth);
// The part of the rectangle that lies within `span` along the side's line.
RectMm cut_along(const RectMm& rect, Side side, Span span);
// The rectangle with its side moved inward by `by`, outward when negative.
RectMm moved_side(const RectMm& rect, Side side, int by);
// How far `other` is beyond the side; negative when it reaches behind the side's line.
int distance_beyond(const RectMm& rect, Side side, const RectMm& other);

}  // namespace marketgen::layout
