#include "navigation/visibility_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include <fmt/format.h>

#include "base/parallel.h"

namespace marketgen::navigation {
namespace {

constexpr double not_reached_mm = std::numeric_limits<double>::infinity();
constexpr std::size_t grain = 16;  // corners whose lines of sight are one piece of work

double distance_mm(PointMm a, PointMm b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  return std::sqrt(dx * dx + dy * dy);
}

Result<void> check_end(const FreeSpace& space, PointMm p, const char* which) {
  const std::string where = fmt::format("{} of the base path", which);
  if (!space.on_floor(p)) {
    return Error{"motion.outside_floor",
                 where,
                 fmt::format("({}, {}) mm is not on the store's floor", p[0], p[1])};
  }
  if (!space.free(p)) {
    return Error{"motion.base_blocked",
                 where,
                 fmt::format("({}, {}) mm is nearer than {} mm to a wall or fixture; choose a "
                             "place farther off",
                             p[0],
                             p[1],
                             space.clearance_mm())};
  }
  return {};
}

// An entry of the search: the lower estimate first, then the lower node.
struct Open {
  double estimate;
  std::uint32_t node;
  bool operator>(const Open& o) const {
    return estimate != o.estimate ? estimate > o.estimate : node > o.node;
  }
};

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

// A*; the two ends are nodes `corners` and `corners + 1`.
Result<FloorPath> VisibilityGraph::shortest_path(PointMm from, PointMm to) const {
  MARKETGEN_CHECK(check_end(space_, from, "start"));
  MARKETGEN_CHECK(check_end(space_, to, "goal"));
  if (space_.sees(from, to)) return FloorPath{{from, to}, 1e-3 * distance_mm(from, to)};
  const auto start = static_cast<std::uint32_t>(corners_.size()), goal = start + 1;
  std::vector<double> to_goal(corners_.size(), not_reached_mm),
      cost(corners_.size() + 2, not_reached_mm);
  for (const Edge& edge : corners_seen_from(to))
    to_goal[edge.to] = edge.length_mm;
  std::vector<std::uint32_t> parent(corners_.size() + 2, start);
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  const auto offer = [&](std::uint32_t node, std::uint32_t by, double through) {
    if (through >= cost[node]) return;
    cost[node] = through;
    parent[node] = by;
    open.push({through + (node == goal ? 0 : distance_mm(corners_[node].at, to)), node});
  };
  for (const Edge& edge : corners_seen_from(from))
    offer(edge.to, start, edge.length_mm);
  std::vector<bool> closed(corners_.size() + 2, false);
  while (!open.empty() && open.top().node != goal) {
    const std::uint32_t at = open.top().node;
    open.pop();
    if (closed[at]) continue;
    closed[at] = true;
    if (to_goal[at] < not_reached_mm) offer(goal, at, cost[at] + to_goal[at]);
    for (std::uint32_t k = first_[at]; k < first_[at + 1]; ++k)
      offer(edges_[k].to, at, cost[at] + edges_[k].length_mm);
  }
  if (cost[goal] == not_reached_mm) {
    return Error{"motion.unreachable",
                 "base path",
                 fmt::format("no passage of {} mm leads from ({}, {}) to ({}, {}) mm",
                             2 * space_.clearance_mm(),
                             from[0],
                             from[1],
                             to[0],
                             to[1])};
  }
  FloorPath path{{to}, 1e-3 * cost[goal]};
  for (std::uint32_t node = parent[goal]; node != start; node = parent[node])
    path.points.push_back(corners_[node].at);
  path.points.push_back(from);
  std::reverse(path.points.begin(), path.points.end());
  return path;
}

}  // namespace marketgen::navigation
