// How far people in a store walk to leave it. What doors so large a floor needs: plan/egress.h.
#pragma once
#include "layout/layout.h"

namespace marketgen::audit {

struct Egress {
  double longest_m =
      0;  // way from anywhere on the free floor to the nearest door that leads outside
  PointMm farthest{0, 0};
};

// Ways are those of a person of 0.45 m, on squares of 0.2 m. Floor that no door is reached from is
// not counted: other rules tell of it.
Egress measure_egress(const layout::Layout& layout);

}  // namespace marketgen::audit
