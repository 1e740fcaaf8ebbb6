#include "layout/side.h"

#include <algorithm>

namespace marketgen::layout {

Side side_of(plan::Wall wall) {
  switch (wall) {
    case plan::Wall::north:
      return Side::north;
    case plan::Wall::south:
      return Side::south;
    case plan::Wall::east:
      return Side::east;
    case plan::Wall::west:
      return Side::west;
  }
  return Side::south;
}

std::vector<Span> without(Span whole, std::vector<Span> taken, int least) {
  std::ranges::sort(taken, {}, &Span::from);
  std::vector<Span> left;
  int from = whole.from;
  for (const Span& span : taken) {
    if (span.to <= from) continue;
    if (span.from >= whole.to) break;
    if (span.from - from >= least) left.push_back({from, span.from});
    from = span.to;
  }
  if (whole.to - from >= least) left.push_back({from, whole.to});
  return left;
}

Span along(const RectMm& rect, Side side) {
  return lies_along_x(side) ? Span{rect.x0, rect.x1} : Span{rect.y0, rect.y1};
}

Span across(const RectMm& rect, Side side) {
  return lies_along_x(side) ? Span{rect.y0, rect.y1} : Span{rect.x0, rect.x1};
}

int coordinate(const RectMm& rect, Side side) {
  switch (side) {
    case Side::south:
      return rect.y0;
    case Side::east:
      return rect.x1;
    case Side::north:
      return rect.y1;
    case Side::west:
      return rect.x0;
  }
  return 0;
}

RectMm strip_inside(const RectMm& rect, Side side, int depth, int offset) {
  switch (side) {
    case Side::south:
      return {rect.x0, rect.y0 + offset, rect.x1, rect.y0 + offset + depth};
    case Side::east:
      return {rect.x1 - offset - depth, rect.y0, rect.x1 - offset, rect.y1};
    case Side::north:
      return {rect.x0, rect.y1 - offset - depth, rect.x1, rect.y1 - offset};
    case Side::west:
      return {rect.x0 + offset, rect.y0, rect.x0 + offset + depth, rect.y1};
  }
  return rect;
}

RectMm strip_beyond(const RectMm& rect, Side side, int depth) {
  return strip_inside(rect, side, depth, -depth);
}

RectMm cut_along(const RectMm& rect, Side side, Span span) {
  RectMm cut = rect;
  if (lies_along_x(side)) {
    cut.x0 = span.from;
    cut.x1 = span.to;
  } else {
    cut.y0 = span.from;
    cut.y1 = span.to;
  }
  return cut;
}

RectMm moved_side(const RectMm& rect, Side side, int by) {
  RectMm moved = rect;
  switch (side) {
    case Side::south:
      moved.y0 += by;
      break;
    case Side::east:
      moved.x1 -= by;
      break;
    case Side::north:
      moved.y1 -= by;
      break;
    case Side::west:
      moved.x0 += by;
      break;
  }
  return moved;
}

int distance_beyond(const RectMm& rect, Side side, const RectMm& other) {
  switch (side) {
    case Side::south:
      return rect.y0 - other.y1;
    case Side::east:
      return other.x0 - rect.x1;
    case Side::north:
      return other.y0 - rect.y1;
    case Side::west:
      return rect.x0 - other.x1;
  }
  return 0;
}

}  // namespace marketgen::layout
