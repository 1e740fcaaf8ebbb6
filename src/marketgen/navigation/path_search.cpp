// Shortest paths over a visibility graph, also past what stands on the floor for now.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include <fmt/format.h>

#include "navigation/visibility_graph.h"

namespace marketgen::navigation {
namespace {

constexpr double not_reached_mm = std::numeric_limits<double>::infinity();
constexpr int ring_points = 8, beside_ring_mm = 3;  // whole millimetres never enter the disc

double length_mm(PointMm a, PointMm b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  return std::sqrt(dx * dx + dy * dy);
}

// From a point to the nearest of a straight way.
double length_to_way_mm(PointMm p, PointMm a, PointMm b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
  const double along =
      square > 0 ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(a[0] + along * dx - p[0], a[1] + along * dy - p[1]);
}

bool keeps_clear(std::span<const DiscMm> discs, PointMm a, PointMm b) {
  return std::ranges::all_of(
      discs, [&](const DiscMm& disc) { return length_to_way_mm(disc.at, a, b) >= disc.radius_mm; });
}

std::vector<DiscMm> discs_for(PointMm from, std::span<const DiscMm> discs) {
  std::vector<DiscMm> kept;
  for (const DiscMm& disc : discs) {
    const int room = static_cast<int>(length_mm(from, disc.at)) - 1;
    if (room > 0) kept.push_back({disc.at, std::min(disc.radius_mm, room)});
  }
  return kept;
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

}  // namespace

// A*. Its nodes: the graph's corners, then points about the discs, then the two ends.
class VisibilityGraph::Search {
 public:
  Search(const VisibilityGraph& graph, PointMm from, PointMm to, std::span<const DiscMm> discs)
      : graph_(graph), from_(from), to_(to), discs_(discs_for(from, discs)) {
    number_nodes();
  }

  // Empty when there is none.
  FloorPath find() {
    if (!keeps_clear(discs_, to_, to_)) return {};
    if (goes(from_, to_)) return {{from_, to_}, 1e-3 * length_mm(from_, to_)};
    for (const Edge& edge : graph_.corners_seen_from(to_))
      to_goal_[edge.to] = edge.length_mm;
    expand(start(), 0);
    while (!open_.empty() && open_.top().node != goal()) {
      const std::uint32_t at = open_.top().node;
      open_.pop();
      if (closed_[at]) continue;
      closed_[at] = true;
      expand(at, cost_[at]);
    }
    return cost_[goal()] < not_reached_mm ? path() : FloorPath{};
  }

 private:
  void number_nodes() {
    for (const DiscMm& disc : discs_)
      add_ring(disc);
    first_end_ = static_cast<std::uint32_t>(graph_.corners_.size() + ring_.size());
    cost_.assign(first_end_ + 2, not_reached_mm);
    parent_.assign(first_end_ + 2, start());
    closed_.assign(first_end_ + 2, false);
    to_goal_.assign(graph_.corners_.size(), not_reached_mm);
  }
  // An entry of the search: the lower estimate first, then the lower node.
  struct Open {
    double estimate;
    std::uint32_t node;
    bool operator>(const Open& o) const {
      return estimate != o.estimate ? estimate > o.estimate : node > o.node;
    }
  };

  std::uint32_t start() const { return first_end_; }
  std::uint32_t goal() const { return first_end_ + 1; }
  std::size_t corners() const { return graph_.corners_.size(); }
  PointMm point(std::uint32_t node) const {
    if (node < corners()) return graph_.corners_[node].at;
    if (node < first_end_) return ring_[node - corners()];
    return node == start() ? from_ : to_;
  }
  bool goes(PointMm a, PointMm b) const {
    return graph_.space_.sees(a, b) && keeps_clear(discs_, a, b);
  }

  void add_ring(const DiscMm& disc) {
    const double radius = (disc.radius_mm + beside_ring_mm) / std::cos(std::numbers::pi / 8);
    for (int i = 0; i < ring_points; ++i) {
      const double angle = 2 * std::numbers::pi * i / ring_points;
      const PointMm at{disc.at[0] + static_cast<int>(std::lround(radius * std::cos(angle))),
                       disc.at[1] + static_cast<int>(std::lround(radius * std::sin(angle)))};
      if (graph_.space_.on_floor(at) && graph_.space_.free(at) && keeps_clear(discs_, at, at))
        ring_.push_back(at);
    }
  }

  void offer(std::uint32_t node, std::uint32_t by, double through) {
    if (through >= cost_[node]) return;
    cost_[node] = through;
    parent_[node] = by;
    open_.push({through + (node == goal() ? 0 : length_mm(point(node), to_)), node});
  }

  void expand(std::uint32_t at, double cost) {
    const PointMm here = point(at);
    if (at < corners()) {
      if (to_goal_[at] < not_reached_mm && keeps_clear(discs_, here, to_))
        offer(goal(), at, cost + to_goal_[at]);
      for (std::uint32_t k = graph_.first_[at]; k < graph_.first_[at + 1]; ++k) {
        const Edge& edge = graph_.edges_[k];
        if (keeps_clear(discs_, here, point(edge.to))) offer(edge.to, at, cost + edge.length_mm);
      }
    } else {
      if (at != start() && goes(here, to_)) offer(goal(), at, cost + length_mm(here, to_));
      for (const Edge& edge : graph_.corners_seen_from(here))
        if (keeps_clear(discs_, here, point(edge.to))) offer(edge.to, at, cost + edge.length_mm);
    }
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const auto node = static_cast<std::uint32_t>(corners() + i);
      if (node != at && !closed_[node] && goes(here, ring_[i]))
        offer(node, at, cost + length_mm(here, ring_[i]));
    }
  }

  FloorPath path() const {
    FloorPath found{{to_}, 1e-3 * cost_[goal()]};
    for (std::uint32_t node = parent_[goal()]; node != start(); node = parent_[node])
      found.points.push_back(point(node));
    found.points.push_back(from_);
    std::ranges::reverse(found.points);
    return found;
  }

  const VisibilityGraph& graph_;
  PointMm from_, to_;
  std::vector<DiscMm> discs_;
  std::vector<PointMm> ring_;
  std::uint32_t first_end_ = 0;
  std::vector<double> to_goal_, cost_;
  std::vector<std::uint32_t> parent_;
  std::vector<bool> closed_;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

Result<FloorPath> VisibilityGraph::shortest_path(PointMm from, PointMm to) const {
  return shortest_path_past(from, to, {});
}

Result<FloorPath> VisibilityGraph::shortest_path_past(PointMm from,
                                                      PointMm to,
                                                      std::span<const DiscMm> discs) const {
  MARKETGEN_CHECK(check_end(space_, from, "start"));
  MARKETGEN_CHECK(check_end(space_, to, "goal"));
  FloorPath found = Search(*this, from, to, discs).find();
  if (!found.points.empty()) return found;
  return Error{"motion.unreachable",
               "base path",
               fmt::format("no passage of {} mm leads from ({}, {}) to ({}, {}) mm{}",
                           2 * space_.clearance_mm(),
                           from[0],
                           from[1],
                           to[0],
                           to[1],
                           discs.empty() ? "" : " past who stands there now")};
}

}  // namespace marketgen::navigation
