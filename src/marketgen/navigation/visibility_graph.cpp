#include "navigation/visibility_graph.h"

#include <cmath>

#include "base/parallel.h"

namespace marketgen::navigation {
namespace {

constexpr std::size_t grain = 16;  // corners whose lines of sight are one piece of work

double distance_mm(PointMm a, PointMm b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace

Result<VisibilityGraph> VisibilityGraph::make(const PolygonMm& floor,
                                              const std::vector<RectMm>& obstacles,
                                              int clearance_mm,
                                              const std::vector<PolygonMm>& convex) {
  VisibilityGraph graph;
  MARKETGEN_TRY(graph.space_, FreeSpace::make(floor, obstacles, clearance_mm, convex));
  graph.find_corners();
  graph.find_edges();
  return graph;
}

void VisibilityGraph::find_corners() {
  for (const PolygonMm& polygon : space_.grown()) {
    const std::size_t count = polygon.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (space_.free(polygon[i]))
        corners_.push_back(
            {polygon[i], polygon[(i + count - 1) % count], polygon[(i + 1) % count]});
    }
  }
}

// A line through the corner does not enter its obstacle: both neighbours lie on one side of it.
bool VisibilityGraph::tangent(const Corner& corner, PointMm from) {
  const std::int64_t before = turn(from, corner.at, corner.before);
  const std::int64_t after = turn(from, corner.at, corner.after);
  return (before >= 0 && after >= 0) || (before <= 0 && after <= 0);
}

void VisibilityGraph::find_edges() {
  const auto later_of = [&](std::size_t i) {
    std::vector<Edge> seen;
    for (std::size_t j = i + 1; j < corners_.size(); ++j) {
      const Corner &a = corners_[i], &b = corners_[j];
      if (tangent(a, b.at) && tangent(b, a.at) && space_.sees(a.at, b.at))
        seen.push_back({static_cast<std::uint32_t>(j), distance_mm(a.at, b.at)});
    }
    return seen;
  };
  const std::vector<std::vector<Edge>> later = parallel_map(corners_.size(), later_of, grain);
  std::vector<std::vector<Edge>> all(corners_.size());
  for (std::uint32_t i = 0; i < later.size(); ++i) {
    for (const Edge& edge : later[i]) {
      all[i].push_back(edge);
      all[edge.to].push_back({i, edge.length_mm});
    }
  }
  first_.assign(1, 0);
  for (const std::vector<Edge>& list : all) {
    edges_.insert(edges_.end(), list.begin(), list.end());
    first_.push_back(static_cast<std::uint32_t>(edges_.size()));
  }
}

std::vector<VisibilityGraph::Edge> VisibilityGraph::corners_seen_from(PointMm p) const {
  std::vector<Edge> seen;
  for (std::uint32_t i = 0; i < corners_.size(); ++i) {
    if (tangent(corners_[i], p) && space_.sees(p, corners_[i].at))
      seen.push_back({i, distance_mm(p, corners_[i].at)});
  }
  return seen;
}

}  // namespace marketgen::navigation
