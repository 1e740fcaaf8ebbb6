// Ways out of a store: how many people may be in it, through which doors they leave, and how far
// they walk. Figures are those of the International Building Code (2021) for mercantile floors.
#pragma once
#include "layout/layout.h"

namespace marketgen::audit {

struct Egress {
  double people = 0;     // that the floor is for: 60 sq ft gross each (table 1004.5)
  int doors = 0;         // that lead outside: entrances, exits, emergency exits
  int width_mm = 0;      // of all of them together
  double longest_m = 0;  // way from anywhere on the free floor to the nearest of them
  PointMm farthest{0, 0};
};

bool leads_outside(const plan::Opening& opening);

// Ways are those of a person of 0.45 m, on squares of 0.2 m. Floor that no door is reached from is
// not counted: other rules tell of it.
Egress measure_egress(const layout::Layout& layout);

// How many doors so many people need (1006.2.1, 1006.3.3).
int doors_for(double people);

}  // namespace marketgen::audit
