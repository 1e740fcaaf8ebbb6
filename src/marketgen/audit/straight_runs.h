// Straight lines of modules, as people count runs: by where modules stand, not by what the layout
// calls them.
#pragma once
#include <vector>

#include "layout/layout.h"

namespace marketgen::audit {

struct StraightRun {
  RectMm rect;
  int yaw_deg = 0;
  int sides = 1;
  int modules = 0;
  bool back_to_back = false;  // one-sided, with another one-sided run of its kind behind it
};

// Modules of one kind, zone and direction that touch end to end make one run. Deterministic; no
// order is promised.
std::vector<StraightRun> straight_runs(const std::vector<layout::Fixture>& fixtures);

}  // namespace marketgen::audit
