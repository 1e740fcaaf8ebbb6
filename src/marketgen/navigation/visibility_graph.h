// Exact shortest paths of a round base among the fixtures: a visibility graph over grown obstacles.
//
// The graph is made once for a floor and a base; a query joins its two ends to it. Of all lines of
// sight between corners only bitangents are kept: a shortest path never leaves a corner into its
// own obstacle (Rohnert 1986). Lengths are exact for the octagonal growth of free_space.h; A* on an
// 8-connected grid is up to 8.2 % longer.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "base/result.h"
#include "navigation/free_space.h"

namespace marketgen::navigation {

struct FloorPath {
  std::vector<PointMm> points;  // both ends and every corner between them
  double length_m = 0;
};

// Somebody or something that stands on the floor for now: the centre of the base keeps `radius_mm`.
struct DiscMm {
  PointMm at;
  int radius_mm = 0;
};

// Immutable after make(); queries may run on many threads at once.
class VisibilityGraph {
 public:
  // O(corners^2) lines of sight, in parallel; the same graph for any number of threads. Errors:
  // those of FreeSpace::make.
  static Result<VisibilityGraph> make(const PolygonMm& floor,
                                      const std::vector<RectMm>& obstacles,
                                      int clearance_mm,
                                      const std::vector<PolygonMm>& convex = {});

  // Shortest path for the centre of the base. Of equal paths always the same one. Errors:
  // motion.outside_floor, motion.base_blocked (an end is too near to an obstacle),
  // motion.unreachable.
  Result<FloorPath> shortest_path(PointMm from, PointMm to) const;
  // The same, round the discs: by the octagon about each. Of one that is nearer to `from` than its
  // radius no more is kept than is kept there. Error motion.unreachable, too, when `to` is in one.
  Result<FloorPath> shortest_path_past(PointMm from,
                                       PointMm to,
                                       std::span<const DiscMm> discs) const;

  const FreeSpace& space() const { return space_; }
  std::size_t corners() const { return corners_.size(); }
  std::size_t edges() const { return edges_.size(); }  // each way counted

 private:
  struct Corner {
    PointMm at, before, after;  // with its neighbours on the obstacle
  };
  struct Edge {
    std::uint32_t to;
    double length_mm;
  };
  void find_corners();
  void find_edges();
  std::vector<Edge> corners_seen_from(PointMm p) const;
  static bool tangent(const Corner& corner, PointMm from);
  class Search;  // of one path

  FreeSpace space_;
  std::vector<Corner> corners_;
  std::vector<std::uint32_t> first_;  // of each corner in edges_, and one past the last
  std::vector<Edge> edges_;
};

}  // namespace marketgen::navigation
