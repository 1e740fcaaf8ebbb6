// A person's way over the floor: a shortest path whose corners are walked as curves.
#pragma once
#include <vector>

#include "assets/people/gait.h"
#include "navigation/visibility_graph.h"

namespace marketgen::collect {

// Immutable. Store frame, metres.
class FloorWay {
 public:
  // Precondition: two points or more that differ.
  explicit FloorWay(const navigation::FloorPath& path);

  double length_m() const { return lengths_.back(); }
  // After so many metres, 0 to length_m(). Corners are cut by at most 4 cm; the body turns round
  // them within 0.8 m.
  assets::WayPlace at(double walked_m) const;

 private:
  Vec2 corner_point(double walked_m) const;
  Vec2 mean_point(double walked_m, double window_m) const;

  std::vector<Vec2> points_;
  std::vector<double> lengths_;  // to each point
};

}  // namespace marketgen::collect
