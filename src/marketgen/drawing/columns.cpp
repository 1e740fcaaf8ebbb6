#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "drawing/recognise.h"

namespace marketgen::drawing {
namespace {

constexpr double min_mm = 50, max_mm = 2000;  // of plan.h
constexpr double slimmest = 4;
constexpr double unnamed_least_mm = 120;  // smaller shapes without a name are dots and letters
constexpr double full = 0.7;              // of the box around it: a circle has 0.785

struct Shape {
  Vec2 centre;
  double width = 0, depth = 0, area_mm2 = 0;
};

Shape shape_of(const std::vector<Vec2>& points) {
  Vec2 low = points[0], high = low;
  for (const Vec2& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return {(low + high) * 0.5, high.x - low.x, high.y - low.y, std::abs(area_mm2(points))};
}

// Turned squares fill half of their box.
bool fills(const Shape& shape, const std::vector<Vec2>& points) {
  const double square = std::max(shape.width, shape.depth);
  if (shape.area_mm2 >= full * shape.width * shape.depth) return true;
  return points.size() == 4 && shape.area_mm2 >= 0.45 * square * square;
}

bool is_column(const Stroke& stroke, const Shape& shape) {
  if (!stroke.closed || stroke.points.size() < 4) return false;
  const double longer = std::max(shape.width, shape.depth);
  const double shorter = std::min(shape.width, shape.depth);
  if (longer > max_mm || shorter < min_mm || longer > slimmest * shorter) return false;
  if (stroke.role == Role::column) return true;
  return stroke.role == Role::unknown && shorter >= unnamed_least_mm && fills(shape, stroke.points);
}

// Stands free: every point of it on the floor.
bool on_floor(const Polygon& outline, const std::vector<Vec2>& points) {
  return std::ranges::all_of(points, [&](Vec2 p) { return contains(outline, p); });
}

}  // namespace

std::vector<FoundColumn> columns_of(const Sketch& sketch,
                                    const Polygon& outline,
                                    std::vector<std::string>& warnings) {
  constexpr std::size_t most = 400;
  std::vector<FoundColumn> columns;
  const bool named = std::ranges::any_of(
      sketch.strokes, [](const Stroke& stroke) { return stroke.role == Role::column; });
  std::size_t in_walls = 0;
  for (const Stroke& stroke : sketch.strokes) {
    if (named && stroke.role != Role::column) continue;
    if (columns.size() > 10 * most) break;
    const Shape shape = shape_of(stroke.points);
    if (!is_column(stroke, shape)) continue;
    if (!on_floor(outline, stroke.points)) {
      in_walls += named ? 1 : 0;
      continue;
    }
    const double size = std::sqrt(shape.area_mm2);
    const auto same = std::ranges::find_if(columns, [&](const FoundColumn& one) {
      return distance(one.centre, shape.centre) < std::max(one.size_mm, size) / 2;
    });
    if (same == columns.end()) {
      columns.push_back({shape.centre, size});
    } else {
      same->size_mm = std::max(same->size_mm, size);
    }
  }
  if (in_walls > 0)
    warnings.push_back(
        fmt::format("{} columns stand in or beyond the walls and are left out", in_walls));
  if (columns.size() > most) {
    warnings.push_back(
        fmt::format("{} columns were found; the first {} are kept", columns.size(), most));
    columns.resize(most);
  }
  return columns;
}

}  // namespace marketgen::drawing
