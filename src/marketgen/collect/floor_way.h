// A person's way over the floor: a shortest path whose corners are walked as curves.
#pragma once
#include <vector>

#include "assets/people/gait.h"
#include "navigation/visibility_graph.h"

namespace marketgen::collect {

// How the body is turned. `along`: as the way goes, within 0.8 m of a corner, and at the ends
// exactly so. `even`: as it goes in the mean of the metre about them, so that no corner, also
// beside an end, turns anybody round at once.
enum class WayTurning { along, even };

// Immutable. Store frame, metres.
class FloorWay {
 public:
  // Precondition: two points or more that differ.
  explicit FloorWay(const navigation::FloorPath& path, WayTurning turning = WayTurning::along);

  double length_m() const { return lengths_.back(); }
  // After so many metres, 0 to length_m(). Corners are cut by at most 4 cm.
  assets::WayPlace at(double walked_m) const;
  // How sharply the body turns at most, rad a metre; looked at every 5 cm.
  double sharpest_rad_m() const;

 private:
  double heading_rad(double walked_m) const;
  Vec2 corner_point(double walked_m) const;
  Vec2 mean_point(double walked_m, double window_m) const;

  std::vector<Vec2> points_;
  std::vector<double> lengths_;  // to each point
  WayTurning turning_;
};

}  // namespace marketgen::collect
