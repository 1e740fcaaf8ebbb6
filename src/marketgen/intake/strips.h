// Zones in a line: along a wall, along the front, or one behind the other in a column.
#pragma once
#include <vector>

#include "intake/slices.h"
#include "intake/store_program.h"

namespace marketgen::intake {

struct StripRoom {
  plan::Axis axis;  // along which the zones follow one another
  int length_mm;
  int depth_mm;  // across
  int gap_mm;    // between neighbours
  int min_mm;    // shortest zone
};

struct Strip {
  Slice slice;
  double crowding = 0;  // metres that zones lack
};

// Lengths in proportion to the zones' targets; zones whose floor was asked for get just that.
// Precondition: zones not empty.
Strip make_strip(const std::vector<int>& zones, const StoreProgram& program, const StripRoom& room);

}  // namespace marketgen::intake
