#include "navigation/free_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

namespace marketgen::navigation {
namespace {

constexpr int farthest_mm = 1'000'000;  // products of coordinates then fit 64 bits with room
constexpr int cell_mm = 1000;           // about the width of an aisle
constexpr double octagon_tangent = 0.41421356237309503;  // tan(22.5 degrees)

// Andrew's monotone chain.
PolygonMm hull_of(PolygonMm points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  PolygonMm hull;
  const auto add = [&](std::size_t keep, PointMm p) {
    while (hull.size() > keep && turn(hull[hull.size() - 2], hull.back(), p) <= 0)
      hull.pop_back();
    hull.push_back(p);
  };
  for (const PointMm& p : points)
    add(1, p);
  const std::size_t lower = hull.size();
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p)
    add(lower, *p);
  hull.pop_back();
  return hull;
}

bool touches(const RectMm& a, const RectMm& b) {
  return a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1;
}

// The two cover a rectangle together.
bool joins(const RectMm& a, const RectMm& b) {
  if (a.contains(b) || b.contains(a)) return true;
  const bool same_columns = a.x0 == b.x0 && a.x1 == b.x1;
  const bool same_rows = a.y0 == b.y0 && a.y1 == b.y1;
  return (same_columns || same_rows) && touches(a, b);
}

bool strictly_inside(const PolygonMm& convex, PointMm p) {
  for (std::size_t i = 0, before = convex.size() - 1; i < convex.size(); before = i++) {
    if (turn(convex[before], convex[i], p) <= 0) return false;
  }
  return true;
}

// The segment meets the open interior of a convex polygon: no separating line. Candidates in the
// plane are the sides of the polygon and the segment itself.
bool cuts(const PolygonMm& convex, PointMm a, PointMm b) {
  bool left = false, right = false;
  for (std::size_t i = 0, before = convex.size() - 1; i < convex.size(); before = i++) {
    if (turn(convex[before], convex[i], a) <= 0 && turn(convex[before], convex[i], b) <= 0)
      return false;
    const std::int64_t side = turn(a, b, convex[i]);
    left |= side > 0;
    right |= side < 0;
  }
  return left && right;
}

bool too_far(PointMm p) {
  return std::abs(p[0]) > farthest_mm || std::abs(p[1]) > farthest_mm;
}

Result<void> check_input(const PolygonMm& floor,
                         const std::vector<RectMm>& obstacles,
                         int clearance_mm,
                         const std::vector<PolygonMm>& convex) {
  const auto bad = [](const std::string& message) {
    return Error{"motion.bad_floor", "free space", message};
  };
  if (floor.size() < 3) return bad("a floor needs at least three corners");
  if (clearance_mm < 1 || clearance_mm > farthest_mm / 10) {
    return bad(fmt::format("clearance is {} mm; expected 1 to {}", clearance_mm, farthest_mm / 10));
  }
  std::vector<PolygonMm> all = convex;
  all.push_back(floor);
  for (const RectMm& r : obstacles) {
    if (r.x1 < r.x0 || r.y1 < r.y0) return bad("a rectangle ends before it begins");
    all.push_back({{r.x0, r.y0}, {r.x1, r.y1}});
  }
  for (const PolygonMm& polygon : all) {
    if (polygon.empty()) return bad("an obstacle has no corners");
    if (std::any_of(polygon.begin(), polygon.end(), too_far))
      return bad(fmt::format("a coordinate is beyond {} mm", farthest_mm));
  }
  return {};
}

}  // namespace

PolygonMm grown_hull(const PolygonMm& points, int clearance_mm) {
  const int r = clearance_mm;
  const int t = static_cast<int>(std::ceil(r * octagon_tangent));
  const std::array<PointMm, 8> octagon{
      {{r, -t}, {r, t}, {t, r}, {-t, r}, {-r, t}, {-r, -t}, {-t, -r}, {t, -r}}};
  PolygonMm sums;
  for (const PointMm& p : points) {
    for (const PointMm& o : octagon)
      sums.push_back({p[0] + o[0], p[1] + o[1]});
  }
  return hull_of(std::move(sums));
}

std::vector<RectMm> merged(std::vector<RectMm> rectangles) {
  for (std::size_t i = 0; i < rectangles.size();) {
    std::size_t other = i + 1;
    while (other < rectangles.size() && !joins(rectangles[i], rectangles[other]))
      ++other;
    if (other == rectangles.size()) {
      ++i;
      continue;
    }
    rectangles[i] = bounds_of(rectangles[i], rectangles[other]);
    rectangles.erase(rectangles.begin() + static_cast<std::ptrdiff_t>(other));
    i = 0;  // the larger one may join with an earlier one
  }
  std::sort(rectangles.begin(), rectangles.end(), [](const RectMm& a, const RectMm& b) {
    return std::array{a.y0, a.x0, a.y1, a.x1} < std::array{b.y0, b.x0, b.y1, b.x1};
  });
  return rectangles;
}

Result<FreeSpace> FreeSpace::make(const PolygonMm& floor,
                                  const std::vector<RectMm>& obstacles,
                                  int clearance_mm,
                                  const std::vector<PolygonMm>& convex) {
  MARKETGEN_CHECK(check_input(floor, obstacles, clearance_mm, convex));
  FreeSpace space;
  space.floor_ = floor;
  space.clearance_mm_ = clearance_mm;
  for (const RectMm& r : merged(obstacles))
    space.grown_.push_back(grown_hull(polygon_of(r), clearance_mm));
  for (const PolygonMm& polygon : convex)
    space.grown_.push_back(grown_hull(polygon, clearance_mm));
  for (std::size_t i = 0; i < floor.size(); ++i)
    space.grown_.push_back(grown_hull({floor[i], floor[(i + 1) % floor.size()]}, clearance_mm));
  space.index_obstacles();
  return space;
}

FreeSpace::Cell FreeSpace::cell_of(PointMm p) const {
  return {std::clamp((p[0] - area_.x0) / cell_mm, 0, columns_ - 1),
          std::clamp((p[1] - area_.y0) / cell_mm, 0, rows_ - 1)};
}

void FreeSpace::index_obstacles() {
  area_ = bounds_of(floor_);
  columns_ = area_.width() / cell_mm + 1;
  rows_ = area_.depth() / cell_mm + 1;
  std::vector<std::vector<std::uint32_t>> lists(static_cast<std::size_t>(columns_) *
                                                static_cast<std::size_t>(rows_));
  for (std::size_t i = 0; i < grown_.size(); ++i) {
    bounds_.push_back(bounds_of(grown_[i]));
    const Cell low = cell_of({bounds_[i].x0, bounds_[i].y0});
    const Cell high = cell_of({bounds_[i].x1, bounds_[i].y1});
    for (int row = low.row; row <= high.row; ++row) {
      for (int column = low.column; column <= high.column; ++column)
        lists[static_cast<std::size_t>(row * columns_ + column)].push_back(
            static_cast<std::uint32_t>(i));
    }
  }
  first_.assign(1, 0);
  for (const auto& list : lists) {
    members_.insert(members_.end(), list.begin(), list.end());
    first_.push_back(static_cast<std::uint32_t>(members_.size()));
  }
}

bool FreeSpace::on_floor(PointMm p) const {
  return !too_far(p) && contains(floor_, p);
}

bool FreeSpace::free(PointMm p) const {
  if (!on_floor(p)) return false;
  const Cell cell = cell_of(p);
  const auto at = static_cast<std::size_t>(cell.row * columns_ + cell.column);
  for (std::uint32_t k = first_[at]; k < first_[at + 1]; ++k) {
    if (strictly_inside(grown_[members_[k]], p)) return false;
  }
  return true;
}

bool FreeSpace::sees(PointMm from, PointMm to) const {
  const RectMm box{std::min(from[0], to[0]),
                   std::min(from[1], to[1]),
                   std::max(from[0], to[0]),
                   std::max(from[1], to[1])};
  const auto blocked = [&](int row, int column) {
    const auto at = static_cast<std::size_t>(row * columns_ + column);
    for (std::uint32_t k = first_[at]; k < first_[at + 1]; ++k) {
      const std::uint32_t i = members_[k];
      if (overlap(bounds_[i], box.grown(1)) && cuts(grown_[i], from, to)) return true;
    }
    return false;
  };
  const Cell start = cell_of(from), end = cell_of(to);
  const int step = end.row >= start.row ? 1 : -1;
  const double slope = from[1] == to[1] ? 0 : double(to[0] - from[0]) / (to[1] - from[1]);
  for (int row = start.row; row != end.row + step; row += step) {
    // The part of the segment in this row of cells, a millimetre longer at each end.
    const int low_y = std::max(box.y0, area_.y0 + row * cell_mm);
    const int high_y = std::min(box.y1, area_.y0 + (row + 1) * cell_mm);
    double x0 = from[0] + slope * (low_y - from[1]), x1 = from[0] + slope * (high_y - from[1]);
    if (from[1] == to[1]) x0 = box.x0, x1 = box.x1;
    if (x0 > x1) std::swap(x0, x1);
    const int first = cell_of({static_cast<int>(x0) - 1, low_y}).column;
    const int last = cell_of({static_cast<int>(x1) + 1, low_y}).column;
    for (int column = first; column <= last; ++column) {
      if (blocked(row, column)) return false;
    }
  }
  return true;
}

PointMm FreeSpace::nearest_free(PointMm p, int max_off_mm) const {
  if (free(p)) return p;
  PointMm nearest = p;
  double min_off = std::numeric_limits<double>::infinity();
  for (int x = -max_off_mm; x <= max_off_mm; ++x) {
    for (int y = -max_off_mm; y <= max_off_mm; ++y) {
      const double off = std::hypot(x, y);
      if (off >= min_off || off > max_off_mm || !free({p[0] + x, p[1] + y})) continue;
      nearest = {p[0] + x, p[1] + y};
      min_off = off;
    }
  }
  return nearest;
}

}  // namespace marketgen::navigation
