// What an agent knows of the place where it works before it looks: what stands where, nominally.
//
// Base frame of the arm; metres.
#pragma once
#include <array>
#include <vector>

#include "geometry/pose.h"

namespace marketgen::agent {

// An upright rectangle on the counter.
struct WorkArea {
  std::array<double, 2> low_m{}, high_m{};
  bool holds(double x, double y) const {
    return x >= low_m[0] && x <= high_m[0] && y >= low_m[1] && y <= high_m[1];
  }
};

struct WorkBox {
  Pose pose;  // of its middle
  Vec3 half_size;
};

// A counter (its top is z = 0) with an open basket on it.
struct Workplace {
  WorkArea counter, unloading, set_aside;
  Pose base_from_basket;        // origin in the middle of the inner floor, Z up
  double rim_m = 0;             // height of the rim over the inner floor
  Vec3 inner_half;              // of the basket between the upper edges; z unused
  double wall_m = 0;            // thickness of its walls
  std::vector<WorkBox> walls;   // basket_from_box: those that reach the rim
  std::vector<WorkBox> ledges;  // basket_from_box: other parts of the inside
};

}  // namespace marketgen::agent
